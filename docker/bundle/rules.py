"""What a bundle must keep so that it runs on other machines, from any folder."""

import os
import re
import subprocess
from pathlib import Path

from elf import Elf, is_elf, read_elf

# What every Linux with glibc has. Nothing else is taken from the system.
SYSTEM = {"libc.so.6", "libm.so.6", "libpthread.so.0", "libdl.so.2", "librt.so.1", "ld-linux-x86-64.so.2"}
NEWEST_GLIBC = (2, 36)
# The old tag, on purpose: RUNPATH comes after LD_LIBRARY_PATH, where the modules of a cluster put other libraries.
PROGRAM_RPATH = "$ORIGIN/../lib"
LIMIT_BYTES = 60_000_000
GLIBC = re.compile(r"GLIBC_(\d+)\.(\d+)")
RESOLVED = re.compile(r"^\s*(\S+)(?: => (.+?))?(?: \(0x[0-9a-f]+\))?$")


def offences(bundle: Path) -> list[str]:
    """Every broken rule, as one sentence."""
    bundle = bundle.resolve()
    inside = {path.name for path in (bundle / "lib").iterdir()}
    found = []
    for path in sorted(bundle.rglob("*")):
        name = path.relative_to(bundle).as_posix()
        if path.is_symlink():
            found.append(f"{name} is a link; a copy through another system may lose it")
        elif path.is_file() and is_elf(path):
            elf = read_elf(path)
            found += [f"{name} {what}" for what in elf_offences(elf, inside)]
            if path.parent != bundle / "lib":
                found += [f"{name} {what}" for what in program_offences(elf)]
                found += [f"{name} {what}" for what in resolved_offences(path, bundle)]
    return found


def elf_offences(elf: Elf, inside: set[str]) -> list[str]:
    found = [f"needs {name}, which is not in lib/" for name in elf.needed if name not in inside | SYSTEM]
    for library, version in sorted(elf.versions):
        glibc = GLIBC.fullmatch(version)
        if glibc and (int(glibc[1]), int(glibc[2])) > NEWEST_GLIBC:
            found.append(f"needs {version} of {library}: newer than {'.'.join(map(str, NEWEST_GLIBC))}")
    for folder in f"{elf.rpath}:{elf.runpath}".split(":"):
        if folder and not folder.startswith("$ORIGIN"):
            found.append(f"looks for libraries in {folder}")
    if elf.has_debug:
        found.append("is not stripped")
    return found


def program_offences(elf: Elf) -> list[str]:
    if elf.rpath == PROGRAM_RPATH and not elf.runpath:
        return []
    return [f"has RPATH '{elf.rpath}' and RUNPATH '{elf.runpath}', not RPATH '{PROGRAM_RPATH}' alone"]


def resolved_offences(program: Path, bundle: Path) -> list[str]:
    """What the loader of this machine finds, with an empty environment."""
    answer = subprocess.run(["/usr/bin/ldd", program], capture_output=True, text=True, env={}, check=False)
    found = [line.strip() for line in answer.stderr.splitlines()]
    for line in answer.stdout.splitlines():
        match = RESOLVED.match(line)
        place = match and (match[2] or match[1])
        if not place or "not found" in line:
            found.append(f"does not resolve: {line.strip()}")
        elif os.path.basename(place) in SYSTEM | {"linux-vdso.so.1"}:
            continue
        elif not Path(place).resolve().is_relative_to(bundle):
            found.append(f"takes {place} from outside")
    return found
