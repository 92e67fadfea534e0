"""raywalk kernels against a program that gives prepared lists."""

import json

import pytest
from raywalk.errors import RaywalkError
from raywalk.kernels import Kernel, Listing, committed_file, differences, read_file, write_file
from raywalk.kernels.file import COLUMNS

from tests.client.test_daemon import script

FRAME = Kernel(
    architecture="sm_90",
    program="frame",
    traversal="bvh/packet",
    intersector="Watertight",
    mode="primary",
    features=31,
    block=64,
    registers_cap=0,
    entry="frame",
    registers=56,
    stack_bytes=0,
    spill_store_bytes=0,
    spill_load_bytes=0,
    shared_bytes=600,
)
OLDER = FRAME.model_copy(update={"architecture": "sm_80", "registers": 54})
TRACE = FRAME.model_copy(update={"program": "trace", "entry": "trace_any", "mode": None, "features": 0})
LISTING = Listing(nvrtc="13.0", kernels=[OLDER, FRAME, TRACE])
PROGRAM = """
import json, os, sys
assert sys.argv[1::2] == ["--compile-kernels", "--kernel-cache"] and sys.argv[4].endswith("raywalk/kernels")
listing = json.loads({listing!r})
listing["kernels"] = [one for one in listing["kernels"] if one["architecture"] in sys.argv[2].split(",")]
print(json.dumps(listing))
"""


@pytest.fixture
def compiles(tmp_path, monkeypatch):
    """Puts a program in the daemon's place."""

    def put(body: str | Listing) -> None:
        text = PROGRAM.format(listing=body.model_dump_json()) if isinstance(body, Listing) else body
        monkeypatch.setenv("RAYWALKD", str(script(tmp_path, text)))

    return put


@pytest.fixture
def table(tmp_path):
    path = tmp_path / "kernels.csv"
    write_file(path, LISTING)
    return path


def test_the_table_is_shown(raywalk, compiles) -> None:
    compiles(LISTING)
    got = raywalk("kernels", "--arch", "sm_90")
    assert got.exit_code == 0, got.stderr
    assert "GPU kernels by NVRTC 13.0" in got.stdout
    assert [line.split()[:3] for line in got.stdout.splitlines() if "bvh/packet" in line] == [
        ["sm_90", "frame", "bvh/packet"],
        ["sm_90", "trace", "bvh/packet"],
    ]
    assert len(json.loads(raywalk("kernels", "--json").stdout)["kernels"]) == 3


def test_the_file_comes_back_as_it_was(table) -> None:
    assert read_file(table) == LISTING
    first, second, *rows = table.read_text().splitlines()
    assert first == "# Compiled by NVRTC 13.0; renewed by `raywalk kernels --write`."
    assert second == ",".join(COLUMNS)
    assert rows[1] == "sm_90,frame,bvh/packet,Watertight,primary,31,64,0,frame,56,0,0,0,600"


def test_check_of_what_is_the_same(raywalk, compiles, table) -> None:
    compiles(LISTING)
    for words in ([], ["--arch", "sm_90"]):
        got = raywalk("kernels", "--check", "--table", table, *words)
        assert (got.exit_code, got.stdout) == (0, "")
        assert f"kernels by NVRTC 13.0 are as {table} has them" in got.stderr


def test_check_says_exactly_what_differs(raywalk, compiles, table) -> None:
    slower = FRAME.model_copy(update={"registers": 60, "spill_load_bytes": 8})
    new = TRACE.model_copy(update={"entry": "trace_closest"})
    compiles(Listing(nvrtc="13.0", kernels=[OLDER, slower, new]))
    got = raywalk("kernels", "--check", "--table", table)
    assert got.exit_code == 1
    packet = "bvh/packet primary Watertight features 31 block 64 frame"
    assert got.stdout.splitlines() == [
        f"sm_90 frame {packet}: registers 56 -> 60, spill loads 0 -> 8",
        "sm_90 trace bvh/packet Watertight features 0 block 64 trace_any: not compiled any more",
        "sm_90 trace bvh/packet Watertight features 0 block 64 trace_closest: not in the table",
    ]
    assert got.stderr == f"raywalk: 3 kernels differ from {table}; raywalk kernels --write renews it\n"


def test_write_renews_the_table(raywalk, compiles, tmp_path) -> None:
    compiles(LISTING)
    path = tmp_path / "gpu" / "new.csv"
    got = raywalk("kernels", "--write", "--table", path)
    assert got.stderr == f"wrote {path}: 3 kernels by NVRTC 13.0\n"
    assert read_file(path) == LISTING


def test_another_compiler_is_no_comparison(raywalk, compiles, table) -> None:
    compiles(LISTING.model_copy(update={"nvrtc": "13.1"}))
    got = raywalk("kernels", "--check", "--table", table)
    assert (got.exit_code, got.stdout) == (1, "")
    assert got.stderr.startswith(
        "raywalk: the table was made by NVRTC 13.0 and this is NVRTC 13.1: their kernels cannot"
    )
    assert "nvidia-cuda-nvrtc==13.0.*" in got.stderr


def test_architectures_that_were_not_compiled_are_not_compared() -> None:
    assert differences(LISTING, Listing(nvrtc="13.0", kernels=[OLDER]), ["sm_80"]) == []


@pytest.mark.parametrize(
    ("body", "said"),
    [
        ("import sys; sys.exit('raywalkd: There is no kernel compiler (NVRTC).')", "There is no kernel compiler"),
        ("import sys; sys.exit('raywalkd: error at line 3: no such name')", "exit code 1): raywalkd: error at line 3"),
        ("import sys; sys.exit(4)", "(exit code 4): no cause given"),
        ("print('hello')", "gave no list of kernels: /: Invalid JSON"),
        ('print(\'{"nvrtc": "13.0", "kernels": [{}]}\')', "gave no list of kernels: /kernels/0/architecture"),
    ],
)
def test_a_program_that_fails(raywalk, compiles, body, said) -> None:
    compiles(body)
    got = raywalk("kernels")
    assert got.exit_code == 1
    assert said in got.stderr


def test_without_nvrtc_there_is_advice(raywalk, compiles, monkeypatch) -> None:
    monkeypatch.setattr("raywalk.nvrtc.WHEELS", ())
    compiles("import sys; sys.exit('raywalkd: There is no kernel compiler (NVRTC).')")
    assert raywalk("kernels").stderr.endswith("\n  pip install nvidia-cuda-nvrtc\n")


@pytest.mark.parametrize(
    "words",
    [["--arch", "90"], ["--arch", ","], ["--check", "--write"], ["--check", "--json"], ["--write", "--arch", "sm_90"]],
)
def test_wrong_usage(raywalk, words) -> None:
    assert raywalk("kernels", *words).exit_code == 2


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda text: "", "cannot be read: it is no text with lines"),
        (lambda text: text.replace("# Compiled by", "# Made by"), "is no table of kernels"),
        (lambda text: text.replace("registers,stack", "stack,registers"), "is no table of kernels"),
        (lambda text: text.replace(",600\n", "\n", 1), ":3: 13 values, not 14"),
        (lambda text: text.replace("frame,56", "frame,many"), ":4: registers: Input should be a valid integer"),
    ],
)
def test_a_damaged_table(raywalk, table, change, said) -> None:
    table.write_text(change(table.read_text()))
    got = raywalk("kernels", "--check", "--table", table)
    assert got.exit_code == 1
    assert said in got.stderr


def test_a_missing_table(tmp_path) -> None:
    with pytest.raises(RaywalkError, match="No such file.*--write makes it"):
        read_file(tmp_path / "none.csv")


def test_the_committed_table() -> None:
    listing = read_file(committed_file())
    assert listing.nvrtc == "13.0"
    assert {kernel.architecture for kernel in listing.kernels} == {"sm_80", "sm_90", "sm_100", "sm_120"}
