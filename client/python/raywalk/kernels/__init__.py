"""What the compiler says of every GPU kernel, and the committed table that it is held against."""

from raywalk.kernels.compare import differences
from raywalk.kernels.file import committed_file, read_file, write_file
from raywalk.kernels.listing import Kernel, Listing, compile_kernels

__all__ = [
    "Kernel",
    "Listing",
    "committed_file",
    "compile_kernels",
    "differences",
    "read_file",
    "write_file",
]
