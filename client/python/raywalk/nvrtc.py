"""NVRTC, the compiler of GPU kernels, where the Python environment has its wheel."""

from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path

VARIABLE = "RAYWALK_NVRTC"  # the daemon's: the libraries to try, separated by colons
ADVICE = "pip install nvidia-cuda-nvrtc"
CUDA12_ADVICE = "pip install 'nvidia-cuda-nvrtc-cu12>=12.4'"
WHEELS = ("nvidia-cuda-nvrtc", "nvidia-cuda-nvrtc-cu13", "nvidia-cuda-nvrtc-cu12")


def wheel_libraries() -> list[Path]:
    """The library of each wheel that is installed: the daemon takes the first that goes with its driver."""
    found = []
    for name in WHEELS:
        try:
            files = distribution(name).files or []
        except PackageNotFoundError:
            continue
        paths = (Path(file.locate()) for file in files)
        found += [path for path in paths if path.name.startswith("libnvrtc.so.") and path.is_file()]
    return found


def environment(current: dict[str, str]) -> dict[str, str]:
    """`current` with the wheels' libraries for the daemon; what the variable says already stands."""
    if current.get(VARIABLE) or not (libraries := wheel_libraries()):
        return current
    return current | {VARIABLE: ":".join(str(path) for path in libraries)}
