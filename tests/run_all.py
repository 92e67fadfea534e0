"""All tests of Raywalk, stage by stage: `./run test` and `./run test --slow` start this.

A stage that fails does not stop the next one. Every stage says what it runs and how long it took; the last line counts
all checks: "N passed, N failed, N skipped". The exit code is 1 when anything failed.
"""

import argparse
import os
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
STAGE_LIMIT_S = 1800
CPP_FOLDERS = ("kernels", "server", "scenes", "tests")
CPP_SUFFIXES = (".h", ".cpp", ".cu")
PYTHON = ROOT / ".venv/bin/python"


@dataclass
class Counts:
    passed: int = 0
    failed: int = 0
    skipped: int = 0

    def __add__(self, other: "Counts") -> "Counts":
        return Counts(self.passed + other.passed, self.failed + other.failed, self.skipped + other.skipped)

    def __str__(self) -> str:
        return f"{self.passed} passed, {self.failed} failed, {self.skipped} skipped"


def counts_of(report: Path, exit_code: int) -> Counts:
    """Reads a JUnit report. A program that failed without a failed test in its report (it crashed, it was stopped, it
    wrote none) counts as one failure."""
    counts = Counts()
    try:
        cases = list(ElementTree.parse(report).iter("testcase"))
    except (OSError, ElementTree.ParseError):
        cases = []
    for case in cases:
        if case.find("failure") is not None or case.find("error") is not None:
            counts.failed += 1
        elif case.find("skipped") is not None or case.get("status") == "notrun":
            counts.skipped += 1
        else:
            counts.passed += 1
    if exit_code != 0 and counts.failed == 0:
        counts.failed = 1
    return counts


def run(command: list[str | Path], environment: dict[str, str] | None = None) -> int:
    """Runs a command in the root and gives its exit code; one that takes too long is stopped and has failed."""
    shown = " ".join(str(part) for part in command)
    print("$ " + (shown if len(shown) < 200 else shown[:197] + "..."), flush=True)
    try:
        return subprocess.run(
            [str(part) for part in command],
            cwd=ROOT,
            env=os.environ | (environment or {}),
            stdin=subprocess.DEVNULL,
            timeout=STAGE_LIMIT_S,
        ).returncode
    except subprocess.TimeoutExpired:
        print(f"stopped after {STAGE_LIMIT_S} s")
        return 124
    except OSError as error:
        print(f"could not be started: {error}")
        return 127


def check(*command: str | Path) -> Counts:
    """A command that counts as one test."""
    return Counts(passed=1) if run(list(command)) == 0 else Counts(failed=1)


def sources(folders: Iterable[str], suffixes: Iterable[str]) -> list[Path]:
    suffixes = tuple(suffixes)
    found = (path for folder in folders for path in sorted((ROOT / folder).rglob("*")))
    return [path.relative_to(ROOT) for path in found if path.suffix in suffixes]


def clang_format() -> Counts:
    return check(ROOT / ".venv/bin/clang-format", "--dry-run", "-Werror", *sources(CPP_FOLDERS, CPP_SUFFIXES))


def ruff() -> Counts:
    return check(PYTHON, "-m", "ruff", "check") + check(PYTHON, "-m", "ruff", "format", "--check")


def build(preset: str) -> Counts:
    return check(ROOT / "run", "build", "--preset", preset)


def gpu_kernels() -> Counts:
    """All GPU kernels compile, with the registers and spills of tests/gpu/kernels.csv. Needs NVRTC but no GPU."""
    return check(ROOT / ".venv/bin/raywalk", "kernels", "--check")


def cpp_tests(preset: str, gtest_filter: str) -> Counts:
    """Every test program of a build. One whose build failed may be old or missing: the build's failure is counted."""
    total = Counts()
    programs = [path for path in sorted((ROOT / f"build/{preset}/tests").glob("test_*")) if os.access(path, os.X_OK)]
    for program in (path for path in programs if path.is_file()):
        with tempfile.TemporaryDirectory() as scratch:
            report = Path(scratch) / "report.xml"
            exit_code = run(
                [program.relative_to(ROOT), f"--gtest_filter={gtest_filter}", f"--gtest_output=xml:{report}"],
                {"GTEST_BRIEF": "1"},
            )
            total += counts_of(report, exit_code)
    return total


def python_tests(marker: str) -> Counts:
    with tempfile.TemporaryDirectory() as scratch:
        report = Path(scratch) / "report.xml"
        exit_code = run([PYTHON, "-m", "pytest", "-q", "-m", marker, f"--junitxml={report}"])
        none_selected = 5
        return counts_of(report, 0 if exit_code == none_selected else exit_code)


def web_client() -> Counts:
    """Format and unit tests of the pages; types were checked by the build. Their tests in a browser are pytest's."""
    web = ROOT / "client/web"
    try:
        node = (web / "node_modules/raywalk-node").read_text().strip()
    except OSError as error:
        print(f"run ./run setup: {error}")
        return Counts(failed=1)
    places = [web / name for name in ("src", "tests", "index.html", "build.mjs", "test.mjs")]
    formatted = check(node, web / "node_modules/prettier/bin/prettier.cjs", "--check", "--log-level=warn", *places)
    with tempfile.TemporaryDirectory() as scratch:
        report = Path(scratch) / "report.xml"
        exit_code = run([node, web / "test.mjs", ROOT / "build/web-tests", report])
        return formatted + counts_of(report, exit_code)


def fuzzers() -> Counts:
    return check(PYTHON, "tests/fuzz/run.py")


Stage = tuple[str, Callable[[], Counts]]

PLAIN: list[Stage] = [
    ("clang-format", clang_format),
    ("ruff", ruff),
    ("build", lambda: build("release")),
    ("GPU kernels compile, as their table says", gpu_kernels),
    ("format and unit tests of the web client", web_client),
    ("C++ tests", lambda: cpp_tests("release", "-*Slow*")),
    ("Python tests", lambda: python_tests("not slow")),
]
SLOW: list[Stage] = [
    ("build", lambda: build("release")),
    ("slow C++ tests", lambda: cpp_tests("release", "*Slow*")),
    ("slow Python tests", lambda: python_tests("slow")),
    ("build for the address and undefined behaviour sanitizers", lambda: build("asan")),
    ("C++ tests under the sanitizers", lambda: cpp_tests("asan", "-*Slow*")),
    ("build of the fuzzers", lambda: build("fuzz")),
    ("fuzzing of the scene formats, two minutes each", fuzzers),
]


def run_stages(stages: list[Stage]) -> Counts:
    total = Counts()
    summary = []
    for name, stage in stages:
        print(f"\n== {name}", flush=True)
        start = time.monotonic()
        counts = stage()
        seconds = time.monotonic() - start
        total += counts
        summary.append(f"{'ok' if counts.failed == 0 else 'FAILED':8}{seconds:7.1f} s  {name}: {counts}")
    print("\n" + "\n".join(summary))
    return total


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--slow", action="store_true", help="run what the plain tests leave out for its time")
    # A job in a shell's background ignores SIGINT, and so would the programs whose answer to it is tested.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    total = run_stages(SLOW if parser.parse_args().slow else PLAIN)
    print(total)
    return 1 if total.failed else 0


if __name__ == "__main__":
    sys.exit(main())
