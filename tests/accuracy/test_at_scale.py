"""The program that asks the goals of accuracy in full numbers: here with a few rays on the processor."""

import re
import subprocess

import pytest
from raywalk.places import daemon_program

PROGRAM = daemon_program().parent.parent / "tests/raywalk_at_scale"
STRICT = 12  # six traversals with two strict triangle tests


def ask(*arguments):
    return subprocess.run([PROGRAM, "--device", "cpu", *arguments], capture_output=True, text=True, timeout=120)


def lines_of(output, part):
    """Technique, rays and failures of each line of a part but the sum."""
    found = [re.match(rf"{part} +(\S.*?) +(\d+) +(\d+) +[\d.]+( .*)?$", line) for line in output.splitlines()]
    return [(m[1], int(m[2]), int(m[3]), m[4] or "") for m in found if m]


def test_every_strict_technique_is_asked_and_right():
    done = ask("--share", "1e-5", "--threads", "2", "--only", "spawned,brute")
    assert done.returncode == 0, done.stdout + done.stderr
    for part in ("spawned", "brute"):
        lines = lines_of(done.stdout, part)
        assert len({technique for technique, *_ in lines}) == STRICT, done.stdout
        assert all(rays > 900 and failures == 0 for _, rays, failures, _ in lines), done.stdout
    assert "cpu; commit" in done.stdout and "--share 1e-5" in done.stdout


def test_box_tests_that_are_not_strict_lose_hits():
    done = ask("--share", "1e-4", "--threads", "2", "--only", "slabs")
    assert done.returncode == 0, done.stdout + done.stderr
    missed = {name: failures for name, _, failures, _ in lines_of(done.stdout, "slabs")}
    assert [missed.pop(name) for name in ("padded", "padded, half nodes", "padded, byte nodes")] == [0, 0, 0]
    assert set(missed) == {"ize", "plain"} and min(missed.values()) > 0


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--only", "corners"], "corners not in"),
        (["--share", "0"], "--share"),
        (["--only", "visits", "--scenes", "nowhere"], "nowhere"),
    ],
)
def test_what_cannot_be_asked_is_said(arguments, said):
    done = ask(*arguments)
    assert done.returncode == 2
    assert said in done.stdout + done.stderr
