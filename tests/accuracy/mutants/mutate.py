"""Copies the kernels with something broken: mutate.py SOURCE_ROOT TARGET_ROOT FILE FIND REPLACE [FIND REPLACE ...].

Each FIND must stand in FILE exactly once, else the mutation is out of date and the build fails. Files that are up to
date are left alone, so that nothing is compiled again without need.
"""

import sys
from pathlib import Path


def write_if_changed(path: Path, text: str) -> None:
    if not path.is_file() or path.read_text(encoding="utf-8") != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def mutate(source: Path, target: Path, broken: str, *changes: str) -> None:
    for path in sorted((source / "kernels").rglob("*")):
        name = path.relative_to(source)
        if path.suffix not in (".h", ".cpp"):
            continue
        text = path.read_text(encoding="utf-8")
        if name.as_posix() == broken:
            for find, replace in zip(changes[::2], changes[1::2], strict=True):
                if text.count(find) != 1:
                    sys.exit(f"{broken} has this {text.count(find)} times, not once: {find}")
                text = text.replace(find, replace)
        write_if_changed(target / name, text)


if __name__ == "__main__":
    mutate(Path(sys.argv[1]), Path(sys.argv[2]), *sys.argv[3:])
