"""Image files: saving frames as they came, animated previews."""

import io
from pathlib import Path

import numpy as np
from PIL import Image, UnidentifiedImageError

from raywalk.errors import RaywalkError
from raywalk.payload import Frame

SUFFIXES = {
    ".png": "image/png",
    ".jpg": "image/jpeg",
    ".jpeg": "image/jpeg",
    ".exr": "image/x-exr",
    ".raw": "application/octet-stream",
    ".npy": "application/octet-stream",
}
PREVIEW_SIDE = 384


def save_frame(frame: Frame, path: Path) -> None:
    """Writes the bytes of the daemon; .npy becomes an array (height, width, channels) of float32."""
    if path.suffix.lower() == ".npy":
        np.save(path, frame.array())
    else:
        path.write_bytes(frame.content)


def opened(content: bytes) -> Image.Image:
    """An encoded image in RGB; throws RaywalkError when it is none."""
    try:
        return Image.open(io.BytesIO(content)).convert("RGB")
    except (UnidentifiedImageError, OSError) as error:
        raise RaywalkError(f"the daemon's answer is no image: {error}") from error


class Animation:
    """Collects frames, shrunk to a preview's size, and writes them as one moving image."""

    def __init__(self, fps: float):
        self._duration_ms = round(1000 / fps)
        self._frames: list[Image.Image] = []

    def add(self, content: bytes) -> None:
        image = opened(content)
        image.thumbnail((PREVIEW_SIDE, PREVIEW_SIDE), Image.Resampling.LANCZOS)
        self._frames.append(image)

    def save(self, path: Path) -> None:
        first, *rest = self._frames
        options = {"quality": 80, "method": 2} if path.suffix == ".webp" else {}
        first.save(path, save_all=True, append_images=rest, duration=self._duration_ms, loop=0, **options)
