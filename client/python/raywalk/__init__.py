"""Client of the Raywalk daemon: scenes, structures, frames, rays and benchmarks over HTTP."""

from raywalk.client import Client
from raywalk.daemon import LocalDaemon
from raywalk.errors import ProblemError, RaywalkError, UnreachableError
from raywalk.payload import Frame, RayHits, pack_rays

__all__ = [
    "Client",
    "Frame",
    "LocalDaemon",
    "ProblemError",
    "RayHits",
    "RaywalkError",
    "UnreachableError",
    "pack_rays",
]
__version__ = "0.1.0"
