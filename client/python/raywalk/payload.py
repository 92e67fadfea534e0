"""Bodies that are not JSON: images with their timing, rays and hits."""

import re
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from raywalk.errors import RaywalkError

CHANNELS = {"color": 3, "normal": 3, "depth": 1, "id": 1, "steps": 2}
HIT = np.dtype([("t", "<f4"), ("id", "<u4"), ("u", "<f4"), ("v", "<f4")])
MISS = 0xFFFFFFFF
RAY_BYTES = 32
FARTHEST = float(np.finfo(np.float32).max)  # an infinite tmax would make a ray invalid


@dataclass(frozen=True)
class Frame:
    """An encoded image; `timing_ms` holds the entries of Server-Timing (queue, trace, readback, encode)."""

    content: bytes
    media_type: str
    width: int
    height: int
    output: str = "color"
    timing_ms: dict[str, float] = field(default_factory=dict)
    etag: str = ""

    def array(self) -> NDArray[np.float32]:
        """Pixels (height, width, channels) of a raw frame, rows top down."""
        shape = (self.height, self.width, CHANNELS[self.output])
        if self.media_type != "application/octet-stream" or len(self.content) != 4 * int(np.prod(shape)):
            raise RaywalkError(f"{len(self.content)} bytes of {self.media_type} are no raw frame of shape {shape}")
        return np.frombuffer(self.content, "<f4").reshape(shape)


@dataclass(frozen=True)
class RayHits:
    """Answer to a ray query: records (t, id, u, v) for closest, booleans for any; `invalid` rays missed."""

    hits: NDArray
    invalid: int = 0


def server_timing(header: str) -> dict[str, float]:
    """Durations in ms by name of a Server-Timing header."""
    found = re.findall(r"([\w-]+)\s*;[^,]*?dur=([0-9.eE+-]+)", header)
    return {name: float(duration) for name, duration in found}


def pack_rays(origins: ArrayLike, directions: ArrayLike, tmin: ArrayLike = 0.0, tmax: ArrayLike = FARTHEST) -> bytes:
    """Rays in the form of the wire from (n, 3) origins and directions; the rest is broadcast."""
    origins = np.atleast_2d(np.asarray(origins, "<f4"))
    rays = np.empty((len(origins), 8), "<f4")
    rays[:, 0:3], rays[:, 4:7] = origins, np.asarray(directions, "<f4")
    rays[:, 3], rays[:, 7] = np.asarray(tmin, "<f4"), np.asarray(tmax, "<f4")
    return rays.tobytes()


def ray_bytes(rays: bytes | NDArray) -> bytes:
    """Accepts packed bytes or an (n, 8) array: origin, tmin, direction, tmax."""
    if isinstance(rays, (bytes, bytearray, memoryview)):
        packed = bytes(rays)
        if len(packed) % RAY_BYTES:
            raise RaywalkError(f"{len(packed)} bytes are no whole number of rays of {RAY_BYTES} bytes")
        return packed
    array = np.ascontiguousarray(rays, "<f4")
    if array.ndim != 2 or array.shape[1] != 8:
        raise RaywalkError(f"rays need the shape (n, 8), not {array.shape}")
    return array.tobytes()


def unpack_hits(content: bytes, query: str) -> NDArray:
    """Hits of a binary answer."""
    return np.frombuffer(content, np.uint8).astype(bool) if query == "any" else np.frombuffer(content, HIT)
