"""The project's own source files, as the checks of tests/project see them."""

from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ("server", "client", "kernels", "proto", "scenes", "tests", "docker")
CPP_SUFFIXES = {".h", ".cpp", ".cu"}
SOURCE_SUFFIXES = CPP_SUFFIXES | {".py", ".ts", ".js", ".css", ".html", ".cmake", ".sh"}
NAMES = {"Dockerfile", "CMakeLists.txt"}
# Not written by hand, not in the repository, or data.
SKIPPED = {"node_modules", "dist", "__pycache__", "data"}


def is_script(path: Path) -> bool:
    if path.suffix:
        return False
    with path.open("rb") as file:
        return file.read(2) == b"#!"


def source_files(root: Path) -> Iterator[Path]:
    """All source files and scripts below `root`, in a fixed order; paths are relative to it."""
    places = [root / folder for folder in FOLDERS]
    found = [path for place in places for path in place.rglob("*")] + list(root.glob("*"))
    for path in sorted(found + [root / ".ci/run"]):
        relative = path.relative_to(root)
        if SKIPPED & set(relative.parts) or not path.is_file():
            continue
        if path.suffix in SOURCE_SUFFIXES or path.name in NAMES or is_script(path):
            yield relative


def cpp_files(root: Path) -> Iterator[Path]:
    return (path for path in source_files(root) if path.suffix in CPP_SUFFIXES)
