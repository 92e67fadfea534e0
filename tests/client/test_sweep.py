"""raywalk bench with kernel options, and the sweep of register caps behind Table 3."""

import json

import pytest

from tests.client.conftest import job_that_gives, specs_sent
from tests.client.test_client import SYSTEM

REGISTERS = {"name": "registers", "help": "h", "default": 0, "maximum": 255, "integer": True}
BLOCK = {"name": "block", "help": "h", "default": 128, "minimum": 32, "maximum": 512, "integer": True}


def traversal(name: str, *options: dict) -> dict:
    return {"name": name, "help": "h", "options": list(options)}


def kind(name: str, *traversals: dict) -> dict:
    return {"name": name, "help": "h", "options": [], "traversals": list(traversals)}


KINDS = [
    kind("brute", traversal("linear", REGISTERS, BLOCK)),
    kind("grid", traversal("dda", REGISTERS, BLOCK)),
    kind("bvh", traversal("packet", REGISTERS), traversal("while-while", REGISTERS, BLOCK)),
    kind("embree", traversal("intersect")),
]
GPU = SYSTEM | {"device": SYSTEM["device"] | {"name": "H100", "kind": "cuda"}}


@pytest.fixture
def ready(daemon):
    daemon.on("GET", "/v1/system", GPU)
    daemon.on("GET", "/v1/kinds", {"kinds": KINDS})
    return daemon


def named(spec: dict) -> list[tuple[str, dict]]:
    return [(f"{one['structure']}/{one['traversal']}", one.get("kernel")) for one in spec["techniques"]]


def on_cpu(**device) -> dict:
    return SYSTEM | {"device": SYSTEM["device"] | device}


def test_every_traversal_with_every_cap(raywalk, ready, sweep) -> None:
    job_that_gives(ready, sweep)
    got = raywalk("bench", "--table", "3", "--registers", "0,32, 64,32")
    assert got.exit_code == 0, got.stderr
    (spec,) = specs_sent(ready)
    caps = [{"registers": cap} for cap in (0, 32, 64)]
    techniques = ("grid/dda", "bvh/packet", "bvh/while-while")
    assert named(spec) == [(technique, cap) for technique in techniques for cap in caps]
    assert (spec["scene"], spec["modes"], spec["batch"], spec["error_frames"]) == ("bunny", ["primary"], 0, 1)
    assert "Table 3: kernels under register caps" in got.stdout
    assert "of best" in got.stdout


def test_a_sweep_of_more_than_one_job(raywalk, ready, sweep, tmp_path) -> None:
    job_that_gives(ready, sweep, sweep)
    caps = ",".join(str(cap) for cap in range(32, 62))  # 30
    got = raywalk("bench", "--table", "3", "city", "--registers", caps, "--out", tmp_path / "t3.json", "--json")
    assert got.exit_code == 0, got.stderr
    assert [len(spec["techniques"]) for spec in specs_sent(ready)] == [60, 30]
    assert {spec["scene"] for spec in specs_sent(ready)} == {"city"}
    assert sorted(path.name for path in tmp_path.iterdir()) == ["t3-1.json", "t3-2.json"]
    assert len(json.loads(got.stdout)) == 2


def test_saved_results_make_the_table_again(raywalk, ready, sweep, tmp_path) -> None:
    job_that_gives(ready, sweep)
    shown = raywalk("bench", "--table", "3", "--out", tmp_path / "t3.json", "--csv").stdout
    assert shown.startswith("scene,fidelity,width_px")
    words = ("tables", tmp_path / "t3.json", "--table", "3", "--format")
    assert raywalk(*words, "csv").stdout == shown
    assert raywalk(*words, "md").stdout.startswith("NVIDIA H100")
    assert raywalk("tables", tmp_path / "t3.json", "--out", tmp_path / "t").exit_code == 0
    assert sorted(path.name for path in (tmp_path / "t").iterdir()) == ["table1.md", "table2.md", "table3.md"]


def test_table3_of_results_of_a_cpu(raywalk, result, tmp_path) -> None:
    (tmp_path / "cpu.json").write_text(result.model_dump_json())
    got = raywalk("tables", tmp_path / "cpu.json", "--table", "3")
    words = "raywalk: Table 3 is about GPU kernels, and these results were measured without a GPU\n"
    assert (got.exit_code, got.stderr, got.stdout) == (1, words, "")


@pytest.mark.parametrize(
    ("device", "why"),
    [
        ({"no_cuda": "libcuda.so.1 was not found."}, "libcuda.so.1 was not found."),
        ({"requested": "cpu"}, "the daemon was started with --device cpu"),
    ],
)
def test_without_a_gpu_one_sentence_says_why(raywalk, ready, device, why) -> None:
    ready.on("GET", "/v1/system", on_cpu(**device))
    got = raywalk("bench", "--table", "3")
    assert got.exit_code == 1
    assert got.stderr == f"raywalk: Table 3 is about GPU kernels, and the device is a CPU (d): {why}\n"
    assert specs_sent(ready) == []


@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (["--table", "3", "--registers", "-1"], 1, "'-1' are no register caps"),
        (["--table", "3", "--registers", "many"], 1, "'many' are no register caps"),
        (["--table", "3", "--registers", ","], 1, "are no register caps"),
        (["--table", "3", "--registers", "0,300"], 1, "a register cap of 300 is out of range: grid/dda takes 0 to 255"),
        (["--table", "3", "--registers", ",".join(map(str, range(65)))], 1, "65 register caps are more than the 64"),
        (["--table", "3", "--techniques", "embree/intersect"], 1, "embree/intersect is no technique of this daemon"),
        (["--table", "3", "--kernel", "registers=64"], 2, "name them with --registers"),
        (["--table", "1", "bunny"], 2, "--table"),
        (["bunny", "--registers", "32"], 2, "--registers is for --table 3"),
        ([], 2, "name a scene"),
        (["bunny", "--kernel", "registers"], 2, "is no option like registers=64"),
        (["bunny", "--kernel", "registers="], 2, "is no option like registers=64"),
        (["bunny", "--kernel", "block=64,block=32"], 2, "'block' is given twice"),
        (["bunny", "--kernel", ","], 2, "are no kernel options"),
        (["bunny", "--kernel", "registers=nan"], 2, "is not finite"),
        (["bunny", "--kernel", "speed=9"], 1, "no technique has the kernel option speed; known: block, registers"),
        (["bunny", "--batch", "17"], 1, "batch: Input should be less than or equal to 16"),
        (["bunny", "--batch", "-1"], 1, "batch: Input should be greater than or equal to 0"),
    ],
)
def test_wrong_usage(raywalk, ready, words, code, said) -> None:
    got = raywalk("bench", *words)
    assert got.exit_code == code
    assert said in " ".join(got.stderr.replace("│", " ").split())
    assert specs_sent(ready) == []


def test_each_technique_takes_the_kernel_options_that_it_has(raywalk, ready, gpu) -> None:
    job_that_gives(ready, gpu)
    words = ("bench", "bunny", "--kernel", "registers=64,block=256", "--batch", "8")
    assert raywalk(*words).exit_code == 0
    both, one = {"registers": 64, "block": 256}, {"registers": 64}
    (spec,) = specs_sent(ready)
    assert named(spec) == [
        ("grid/dda", both),
        ("bvh/packet", one),
        ("bvh/while-while", both),
        ("embree/intersect", None),
    ]
    assert spec["batch"] == 8


def test_kernel_options_of_a_cpu(raywalk, ready) -> None:
    ready.on("GET", "/v1/kinds", {"kinds": [kind("bvh", traversal("packet"))]})
    got = raywalk("bench", "bunny", "--kernel", "block=64")
    assert got.stderr == "raywalk: no technique has the kernel option block; a CPU has none\n"


def test_a_sweep_with_another_block(raywalk, ready, sweep) -> None:
    job_that_gives(ready, sweep)
    words = (
        "--techniques",
        "bvh/packet,grid/dda",
        "--registers",
        "0,40",
        "--kernel",
        "block=256",
        "--modes",
        "whitted",
    )
    assert raywalk("bench", "--table", "3", *words).exit_code == 0
    (spec,) = specs_sent(ready)
    assert named(spec)[:2] == [("bvh/packet", {"registers": 0}), ("bvh/packet", {"registers": 40})]
    assert named(spec)[3] == ("grid/dda", {"block": 256, "registers": 40})
    assert spec["modes"] == ["whitted"]
