"""Compiles every GPU kernel without a GPU: the daemon's program lists what the assembler says of each."""

import os
import subprocess
from collections.abc import Sequence
from pathlib import Path

from pydantic import BaseModel, ValidationError

from raywalk import nvrtc
from raywalk.errors import RaywalkError
from raywalk.places import daemon_program, kernel_cache_dir

LIMIT_S = 900.0
WORDS = 3000  # characters of a failure that are shown: a compiler's log may be long


class Kernel(BaseModel):
    """One entry point of one kernel. The first nine fields say which, the others are its figures."""

    architecture: str
    program: str
    traversal: str
    intersector: str
    mode: str | None
    features: int
    block: int
    registers_cap: int
    entry: str
    registers: int
    stack_bytes: int
    spill_store_bytes: int
    spill_load_bytes: int
    shared_bytes: int


KEY = tuple(Kernel.model_fields)[:9]
FIGURES = tuple(Kernel.model_fields)[9:]


class Listing(BaseModel):
    """`nvrtc` is the version of the compiler, on which the figures depend."""

    nvrtc: str
    kernels: list[Kernel]


def compile_kernels(architectures: Sequence[str], program: Path | None = None) -> Listing:
    """Kernels that were compiled before come from the cache. Throws RaywalkError with the program's words when it
    cannot: no NVRTC, an unknown architecture, an error in the sources."""
    path = program or daemon_program()
    command = [str(path), "--compile-kernels", ",".join(architectures), "--kernel-cache", str(kernel_cache_dir())]
    try:
        done = subprocess.run(
            command,
            env=nvrtc.environment(dict(os.environ)),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=LIMIT_S,
            check=False,
        )
    except subprocess.TimeoutExpired as error:
        raise RaywalkError(f"the kernels were not compiled after {LIMIT_S:.0f} s") from error
    except OSError as error:
        raise RaywalkError(f"{path} could not be started: {error.strerror or error}") from error
    if done.returncode != 0:
        raise RaywalkError(failure(done.returncode, done.stderr.decode(errors="replace").strip()))
    try:
        return Listing.model_validate_json(done.stdout)
    except ValidationError as error:
        first = error.errors()[0]
        where = "/".join(str(step) for step in first["loc"])
        raise RaywalkError(f"{path} gave no list of kernels: /{where}: {first['msg']}") from error


def failure(code: int, words: str) -> str:
    text = words if len(words) <= WORDS else f"{words[:WORDS]} …"
    advice = f"\n  {nvrtc.ADVICE}" if "NVRTC" in words and not nvrtc.wheel_libraries() else ""
    return f"the kernels could not be compiled (exit code {code}): {text or 'no cause given'}{advice}"
