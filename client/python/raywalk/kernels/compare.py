"""What differs between the committed table of kernels and what the compiler says now."""

from collections.abc import Sequence

from raywalk.errors import RaywalkError
from raywalk.kernels.file import NAMES
from raywalk.kernels.listing import FIGURES, KEY, Kernel, Listing


def differences(table: Listing, now: Listing, architectures: Sequence[str]) -> list[str]:
    """One line a kernel, for these architectures alone. Throws RaywalkError when the compilers are not the same: their
    figures cannot be compared."""
    if table.nvrtc != now.nvrtc:
        raise RaywalkError(
            f"the table was made by NVRTC {table.nvrtc} and this is NVRTC {now.nvrtc}: their kernels cannot be "
            f"compared; install nvidia-cuda-nvrtc=={table.nvrtc}.*, or renew the table with raywalk kernels --write"
        )
    expected = {key_of(kernel): kernel for kernel in table.kernels if kernel.architecture in architectures}
    found = {key_of(kernel): kernel for kernel in now.kernels}
    said = [changed(kernel, found[key]) for key, kernel in expected.items() if key in found and kernel != found[key]]
    said += [f"{name_of(kernel)}: not compiled any more" for key, kernel in expected.items() if key not in found]
    said += [f"{name_of(kernel)}: not in the table" for key, kernel in found.items() if key not in expected]
    return said


def key_of(kernel: Kernel) -> tuple[object, ...]:
    return tuple(getattr(kernel, field) for field in KEY)


def name_of(kernel: Kernel) -> str:
    mode = f" {kernel.mode}" if kernel.mode else ""
    cap = f" cap {kernel.registers_cap}" if kernel.registers_cap else ""
    return (
        f"{kernel.architecture} {kernel.program} {kernel.traversal}{mode} {kernel.intersector} "
        f"features {kernel.features} block {kernel.block}{cap} {kernel.entry}"
    )


def changed(before: Kernel, now: Kernel) -> str:
    pairs = [
        f"{NAMES.get(field, field).replace('_', ' ')} {getattr(before, field)} -> {getattr(now, field)}"
        for field in FIGURES
        if getattr(before, field) != getattr(now, field)
    ]
    return f"{name_of(before)}: {', '.join(pairs)}"
