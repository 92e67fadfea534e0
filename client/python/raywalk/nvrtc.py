"""NVRTC, the compiler of GPU kernels, where the Python environment has its wheel."""

from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path

VARIABLE = "RAYWALK_NVRTC"  # the daemon's: the library to open
ADVICE = "pip install nvidia-cuda-nvrtc"
WHEELS = ("nvidia-cuda-nvrtc", "nvidia-cuda-nvrtc-cu13", "nvidia-cuda-nvrtc-cu12")


def wheel_library() -> Path | None:
    """The library of the first wheel that is installed."""
    for name in WHEELS:
        try:
            files = distribution(name).files or []
        except PackageNotFoundError:
            continue
        for file in files:
            path = Path(file.locate())
            if path.name.startswith("libnvrtc.so.") and path.is_file():
                return path
    return None


def environment(current: dict[str, str]) -> dict[str, str]:
    """`current` with the wheel's library for the daemon; what the variable says already stands."""
    if current.get(VARIABLE) or (library := wheel_library()) is None:
        return current
    return current | {VARIABLE: str(library)}
