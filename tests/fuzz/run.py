"""The fuzzers of the scene formats: `./run test --slow` builds them and runs each for two minutes, two at a time.

By hand: `./run build --preset fuzz`, then `.venv/bin/python tests/fuzz/run.py [--seconds N] [FORMAT ...]`. New inputs
that reach new code are kept in build/fuzz/corpus/, what crashes in out/fuzz/.
"""

import argparse
import base64
import os
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = ROOT / "build/fuzz/tests/fuzz"
SECONDS = 120
GRACE_S = 120  # reading the seeds, and the last input
AT_ONCE = 2
LARGEST_INPUT_BYTES = 1 << 16
SLOWEST_INPUT_S = 10
MEMORY_LIMIT_MB = 2048


@dataclass
class Result:
    name: str
    exit_code: int
    output: str
    reproducers: list[Path]


def fuzz(program: Path, seconds: int) -> Result:
    """Runs one fuzzer from the seeds and from what earlier runs found."""
    name = program.name.removeprefix("fuzz_")
    found = ROOT / "build/fuzz/corpus" / name
    crashes = ROOT / "out/fuzz" / name
    for folder in (found, crashes):
        folder.mkdir(parents=True, exist_ok=True)
    earlier = set(crashes.iterdir())
    seeds = [ROOT / "tests/fuzz/corpus" / name, ROOT / "tests/scene/data" / name]
    command = [
        program,
        found,
        *(place for place in seeds if place.is_dir()),
        f"-max_total_time={seconds}",
        f"-timeout={SLOWEST_INPUT_S}",
        f"-rss_limit_mb={MEMORY_LIMIT_MB}",
        f"-max_len={LARGEST_INPUT_BYTES}",
        f"-artifact_prefix={crashes}/",
        "-print_final_stats=1",
    ]
    with tempfile.TemporaryDirectory(dir="/dev/shm" if Path("/dev/shm").is_dir() else None) as scratch:
        try:
            done = subprocess.run(
                command,
                env=os.environ | {"TMPDIR": scratch, "UBSAN_OPTIONS": "print_stacktrace=1"},
                stdin=subprocess.DEVNULL,
                capture_output=True,
                timeout=seconds + GRACE_S,
            )
            exit_code, output = done.returncode, done.stderr.decode(errors="replace")
        except subprocess.TimeoutExpired:
            exit_code, output = 124, "it did not stop in time"
    return Result(name, exit_code, output, sorted(set(crashes.iterdir()) - earlier))


def report(result: Result) -> None:
    stats = dict(
        line.removeprefix("stat::").split(":", 1) for line in result.output.splitlines() if line.startswith("stat::")
    )
    inputs = stats.get("number_of_executed_units", "0").strip()
    memory = stats.get("peak_rss_mb", "0").strip()
    verdict = "ok" if result.exit_code == 0 else f"FAILED with exit code {result.exit_code}"
    print(f"{result.name}: {verdict}, {inputs} inputs, {memory} MB", flush=True)
    if result.exit_code == 0:
        return
    print("\n".join(result.output.splitlines()[-60:]))
    for path in result.reproducers:
        print(f"reproducer: {path}\nbase64: {base64.b64encode(path.read_bytes()).decode()}", flush=True)


def fuzz_all(seconds: int, formats: Sequence[str]) -> list[Result]:
    """Runs the fuzzers that are built, all or those of the named formats, and prints how each went."""
    wanted = {f"fuzz_{name}" for name in formats}
    programs = [
        path
        for path in sorted(PROGRAMS.glob("fuzz_*"))
        if path.is_file() and not path.suffix and (not wanted or path.name in wanted)
    ]
    results = []
    with ThreadPoolExecutor(AT_ONCE) as pool:
        for result in pool.map(lambda program: fuzz(program, seconds), programs):
            report(result)
            results.append(result)
    return results


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("formats", nargs="*", help="names as in server/scene/formats/; all without")
    parser.add_argument("--seconds", type=int, default=SECONDS, help="for each")
    args = parser.parse_args()
    results = fuzz_all(args.seconds, args.formats)
    if not results:
        print("there are no fuzzers: ./run build --preset fuzz")
    return 0 if results and all(result.exit_code == 0 for result in results) else 1


if __name__ == "__main__":
    sys.exit(main())
