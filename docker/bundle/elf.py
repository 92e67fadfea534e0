"""What an ELF file asks of the system, as readelf tells it."""

import re
import subprocess
from dataclasses import dataclass
from pathlib import Path

ENTRY = re.compile(r"\((NEEDED|SONAME|RPATH|RUNPATH)\).*\[(.*)\]")
VERSION_FILE = re.compile(r"File: (\S+) ")
VERSION_NAME = re.compile(r"Name: (\S+) ")


@dataclass(frozen=True)
class Elf:
    """`versions` are pairs of a library and a symbol version that it must have: ("libc.so.6", "GLIBC_2.34")."""

    needed: tuple[str, ...]
    soname: str
    rpath: str
    runpath: str
    versions: frozenset[tuple[str, str]]
    has_debug: bool


def is_elf(path: Path) -> bool:
    with path.open("rb") as file:
        return file.read(4) == b"\x7fELF"


def readelf(*arguments: str | Path) -> str:
    return subprocess.run(["readelf", *arguments], check=True, capture_output=True, text=True).stdout


def read_elf(path: Path) -> Elf:
    entries = ENTRY.findall(readelf("--dynamic", "--wide", path))

    def last(tag: str) -> str:
        return next((value for kind, value in reversed(entries) if kind == tag), "")

    versions = set()
    library = ""
    _, _, needs = readelf("--version-info", "--wide", path).partition("Version needs section")
    for line in needs.splitlines():
        if found := VERSION_FILE.search(line):
            library = found[1]
        elif found := VERSION_NAME.search(line):
            versions.add((library, found[1]))
    return Elf(
        needed=tuple(value for kind, value in entries if kind == "NEEDED"),
        soname=last("SONAME"),
        rpath=last("RPATH"),
        runpath=last("RUNPATH"),
        versions=frozenset(versions),
        has_debug=".debug_info" in readelf("--section-headers", "--wide", path),
    )
