"""Pictures and frames of ids, read back from the files that `raywalk render` writes."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image, UnidentifiedImageError

from raywalk.errors import RaywalkError
from raywalk.image_metrics import Pixels, srgb_encoded

UNREADABLE = {
    ".exr": "EXR is not read; render to .npy, which holds the same values",
    ".raw": "a raw frame does not say its size; render to .npy, which holds the same values",
}
DEEP_MODES = ("I", "F")  # more than 8 bits a channel, which Pillow cannot turn into RGB


def read_picture(path: Path) -> Pixels:
    """sRGB values (h, w, 3) in 0..1: of an 8-bit image file, or of a frame of colours that was saved as .npy."""
    if path.suffix.lower() in UNREADABLE:
        raise RaywalkError(f"{path}: {UNREADABLE[path.suffix.lower()]}")
    if path.suffix.lower() == ".npy":
        array = read_array(path)
        if array.ndim != 3 or array.shape[2] != 3:
            raise RaywalkError(f"{path}: an array of shape {array.shape} is no frame of colours, (height, width, 3)")
        return srgb_encoded(array)
    try:
        with Image.open(path) as image:
            if image.mode.startswith(DEEP_MODES):
                raise RaywalkError(f"{path}: only images of 8 bits a channel are read, and .npy")
            return np.asarray(image.convert("RGB"), np.float32) / 255
    except UnidentifiedImageError as error:
        raise RaywalkError(f"{path}: no image of a known format") from error
    except (OSError, SyntaxError) as error:
        if isinstance(error, OSError) and error.errno is not None:
            raise  # says which file and what
        raise RaywalkError(f"{path}: {error}") from error


def read_ids(path: Path) -> NDArray[np.int64]:
    """Triangle ids (h, w) of a frame of `--output id` that was saved as .npy; -1 is a miss."""
    if path.suffix.lower() != ".npy":
        raise RaywalkError(f"{path}: ids are read from .npy, as `raywalk render --output id --out ids.npy` writes them")
    array = read_array(path)
    if array.ndim != 3 or array.shape[2] != 1:
        raise RaywalkError(f"{path}: an array of shape {array.shape} is no frame of ids, (height, width, 1)")
    if not np.all((array >= -1) & (array == np.floor(array))):
        raise RaywalkError(f"{path}: holds values that are no ids")
    return array[..., 0].astype(np.int64)


def read_array(path: Path) -> NDArray:
    """Numbers of a file of numpy, at least one."""
    try:
        array = np.load(path, allow_pickle=False)
    except (ValueError, EOFError) as error:
        raise RaywalkError(f"{path}: no array of numpy ({error})") from error
    if not isinstance(array, np.ndarray) or array.dtype.kind not in "fiu" or array.size == 0:
        raise RaywalkError(f"{path}: no array of numbers")
    return array
