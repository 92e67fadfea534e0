"""Commands against a daemon made of answers."""

import csv
import io
import json
import os
import subprocess
import sys

import httpx2
import pytest
from PIL import Image
from raywalk.cli import app
from typer.testing import CliRunner

from tests.client.conftest import EVENTS, HERE, JOB, job_that_gives, problem
from tests.client.test_client import SCENE, STRUCTURE, SYSTEM

KINDS = {
    "kinds": [
        {"name": "bvh", "help": "h", "options": [], "traversals": [{"name": "while-while", "help": "h"}]},
        {"name": "embree", "help": "h", "options": [], "traversals": [{"name": "intersect", "help": "h"}]},
    ]
}


def image(kind: str = "PNG", side: tuple[int, int] = (8, 6)) -> httpx2.Response:
    out = io.BytesIO()
    Image.new("RGB", side, (200, 100, 50)).save(out, kind)
    headers = {"Content-Type": f"image/{kind.lower()}", "Server-Timing": "queue;dur=0.1, trace;dur=2.0, encode;dur=1"}
    return httpx2.Response(200, content=out.getvalue(), headers=headers)


@pytest.fixture
def ready(daemon):
    daemon.on("GET", "/v1/scenes", {"scenes": [SCENE]})
    daemon.on("GET", "/v1/scenes/bunny", SCENE)
    daemon.on("POST", "/v1/scenes", SCENE)
    daemon.on("POST", "/v1/structures", STRUCTURE | {"state": "building"})
    daemon.on("GET", "/v1/structures/s1", STRUCTURE)
    daemon.on("POST", "/v1/frames", lambda _: image())
    daemon.on("GET", "/v1/kinds", KINDS)
    daemon.on("GET", "/v1/system", SYSTEM)
    return daemon


def test_scenes_list_as_json(raywalk, ready) -> None:
    got = raywalk("scenes", "list", "--json")
    assert got.exit_code == 0
    (scene,) = json.loads(got.stdout)
    assert {key: scene[key] for key in ("name", "triangles", "lights", "fidelity")} == {
        "name": "bunny",
        "triangles": 3,
        "lights": 1,
        "fidelity": "original",
    }


def test_scenes_list_and_info(raywalk, ready) -> None:
    assert "bunny" in raywalk("scenes", "list").stdout
    assert "original" in raywalk("scenes", "info", "bunny").stdout
    assert json.loads(raywalk("scenes", "info", "bunny", "--json").stdout)["name"] == "bunny"
    assert isinstance(json.loads(raywalk("scenes", "info", "--all", "--json").stdout), list)


def test_scenes_info_needs_one_of_both(raywalk, ready) -> None:
    assert raywalk("scenes", "info").exit_code == 2
    assert raywalk("scenes", "info", "bunny", "--all").exit_code == 2


def test_scenes_upload(raywalk, ready, tmp_path) -> None:
    (tmp_path / "m.ply").write_bytes(b"ply")
    ready.on("PUT", "/v1/scenes/mine", SCENE | {"name": "mine"})
    assert (
        json.loads(raywalk("scenes", "upload", tmp_path / "m.ply", "--name", "mine", "--json").stdout)["name"] == "mine"
    )
    assert ready.requests[-1].content == b"ply"


def test_a_problem_is_one_message(raywalk, ready) -> None:
    ready.on("GET", "/v1/scenes/hare", problem(404, "unknown_scene", "There is no scene 'hare'.", known=["bunny"]))
    got = raywalk("scenes", "info", "hare")
    assert got.exit_code == 1
    assert got.stderr == "raywalk: There is no scene 'hare'.\n  known: bunny\n"
    assert got.stdout == ""


def test_what_the_models_refuse_is_one_message(raywalk, ready) -> None:
    got = raywalk("scenes", "load", "BAD NAME")
    assert got.exit_code == 1
    assert got.stderr.startswith("raywalk: name: String should match pattern")
    assert ready.requests == []


def test_no_daemon_is_one_message() -> None:
    got = CliRunner().invoke(app, ["--server", "http://127.0.0.1:9", "scenes", "list"])
    assert got.exit_code == 1
    assert got.stderr.startswith("raywalk: no answer from the daemon at http://127.0.0.1:9")


def test_structures(raywalk, ready) -> None:
    got = raywalk("structures", "build", "bunny", "bvh", "-o", "bins=8", "-o", "sah=exact", "--json")
    assert json.loads(got.stdout)["state"] == "ready"
    posted = [json.loads(one.content) for one in ready.requests if one.url.path == "/v1/structures"]
    assert posted == [{"scene": "bunny", "kind": "bvh", "options": {"bins": 8.0, "sah": "exact"}}]
    assert raywalk("structures", "build", "bunny", "bvh", "-o", "bins").exit_code == 2


def test_a_failed_build(raywalk, ready) -> None:
    ready.on("GET", "/v1/structures/s1", STRUCTURE | {"state": "failed", "error": "no memory"})
    assert (
        raywalk("structures", "build", "bunny", "bvh").stderr == "raywalk: bvh of bunny could not be built: no memory\n"
    )


@pytest.mark.parametrize(
    ("name", "accept"), [("f.png", "image/png"), ("f.JPG", "image/jpeg"), ("f.exr", "image/x-exr")]
)
def test_render(raywalk, ready, tmp_path, name, accept) -> None:
    got = raywalk("render", "bunny", "--out", tmp_path / name, "--size", "8x6", "--frame", "3", "--of", "9")
    assert got.exit_code == 0, got.stderr
    assert (tmp_path / name).read_bytes()[:4] == b"\x89PNG"
    assert ready.requests[-1].headers["Accept"] == accept
    assert ready.sent()["camera"] == {"frame": 3, "of": 9}
    assert "trace 2.00 ms" in got.stderr


def test_render_a_pose(raywalk, ready, tmp_path) -> None:
    words = ["--eye", "0,0.5,2", "--target", "0,0,0", "--fov", "60", "--output", "steps", "--tier", "fast"]
    assert raywalk("render", "bunny", "--out", tmp_path / "f.png", *words).exit_code == 0
    assert ready.sent()["camera"] == {"eye": [0, 0.5, 2], "target": [0, 0, 0], "vertical_fov_deg": 60}
    assert (ready.sent()["output"], ready.sent()["tier"]) == ("steps", "fast")


def test_render_with_up_and_options(raywalk, ready, tmp_path) -> None:
    words = ["--eye=-1,0,2", "--target=0,0,0", "--up=0,0,1", "--kernel", "intersector=exact,spawn=none"]
    assert raywalk("render", "bunny", "--out", tmp_path / "f.png", *words).exit_code == 0
    assert ready.sent()["camera"] == {"eye": [-1, 0, 2], "target": [0, 0, 0], "up": [0, 0, 1]}
    assert ready.sent()["kernel"] == {"intersector": "exact", "spawn": "none"}
    assert "lights" not in ready.sent()
    assert raywalk("render", "bunny", "--out", tmp_path / "f.png", "-o", "bins=8", "--lights", "0").exit_code == 0
    assert ready.sent()["lights"] == 0
    builds = [json.loads(request.content) for request in ready.requests if request.url.path == "/v1/structures"]
    assert builds[-1]["options"] == {"bins": 8}


@pytest.mark.parametrize(
    "words",
    [
        ["--size", "8"],
        ["--size", "0x8"],
        ["--out", "f.bmp"],
        ["--eye", "0,0,1"],
        ["--eye", "0,1", "--target", "0,0,0"],
        ["--fov", "9"],
        ["--up", "0,0,1"],
        ["--kernel", "exact"],
        ["--mode", "path"],
        ["--tier", "auto"],
        ["--frame", "1", "--eye", "0,0,1", "--target", "0,0,0"],
    ],
)
def test_wrong_usage(raywalk, ready, words) -> None:
    assert raywalk("render", "bunny", *words).exit_code == 2
    assert ready.requests == []


@pytest.mark.parametrize("words", [["--eye", "nan,0,0"], ["--eye", "0,0,1", "--fov", "inf"]])
def test_numbers_are_finite(raywalk, ready, words) -> None:
    got = raywalk("render", "bunny", "--target", "0,0,0", *words)
    assert got.exit_code == 2
    assert "not finite" in got.stderr
    assert ready.requests == []


def test_a_reader_that_left_is_no_error() -> None:
    command = [
        sys.executable,
        "-c",
        "from raywalk.cli import main; main()",
        "tables",
        *[str(HERE / "data/result.json")] * 99,
    ]
    read, write = os.pipe()
    os.close(read)
    for form in ("md", "term"):
        done = subprocess.run(
            [*command, "--format", form], stdout=write, stderr=subprocess.PIPE, timeout=60, check=False
        )
        assert done.stderr == b""
    os.close(write)


def test_walk(raywalk, ready, tmp_path) -> None:
    got = raywalk("walk", "bunny", "--frames", "3", "--out", tmp_path / "w", "--size", "8x6", "--preview", "p.gif")
    assert got.exit_code == 0, got.stderr
    assert sorted(path.name for path in (tmp_path / "w/frames").iterdir()) == ["0000.png", "0001.png", "0002.png"]
    assert Image.open(tmp_path / "w/p.gif").size == (8, 6)
    rows = list(csv.DictReader((tmp_path / "w/times.csv").open()))
    assert [row["trace_ms"] for row in rows] == ["2.0"] * 3


def test_unwritable_out_comes_first(raywalk, ready, tmp_path) -> None:
    (tmp_path / "file").write_text("")
    for words in (["walk", "bunny"], ["demo"]):
        got = raywalk(*words, "--out", tmp_path / "file")
        assert got.exit_code == 1
        assert got.stderr.count("\n") == 1
        assert "cannot be written" in got.stderr
    assert ready.requests == []


def test_bench(raywalk, ready, result, tmp_path) -> None:
    job_that_gives(ready, result)
    words = ["bench", "bunny", "--techniques", "bvh/packet,grid/dda", "--modes", "primary", "--frames", "8"]
    got = raywalk(*words, "--size", "64x32", "--out", tmp_path / "r.json")
    assert got.exit_code == 0, got.stderr
    spec = next(json.loads(one.content) for one in ready.requests if one.url.path == "/v1/jobs")["spec"]
    assert spec["techniques"][1] == {"structure": "grid", "traversal": "dda"}
    assert (spec["width"], spec["height"], spec["frames"], spec["modes"]) == (64, 32, 8, ["primary"])
    assert "bvh/while-while traces 0.55x the rays of embree/intersect" in got.stdout
    assert "error" in got.stdout
    shown = raywalk("tables", tmp_path / "r.json", "--table", "2", "--format", "csv")
    assert shown.stdout.startswith("scene,fidelity,width_px,")
    assert raywalk("tables", tmp_path / "r.json", "--format", "csv").exit_code == 2
    assert raywalk("tables", tmp_path / "r.json", "--format", "csv", "--out", tmp_path / "c").exit_code == 0
    assert sorted(path.name for path in (tmp_path / "c").iterdir()) == ["table1.csv", "table2.csv"]
    assert raywalk("tables", tmp_path / "r.json", "--out", tmp_path / "t").exit_code == 0
    assert sorted(path.name for path in (tmp_path / "t").iterdir()) == ["table1.md", "table2.md"]


def test_bench_that_fails(raywalk, ready, result) -> None:
    job_that_gives(ready, result)
    error = problem(503, "out_of_memory", "no memory").json()
    stream = f"event: job\ndata: {json.dumps(JOB | {'state': 'failed', 'error': error})}\n\n"
    ready.on("GET", "/v1/jobs/j0/events", httpx2.Response(200, content=stream, headers=EVENTS))
    got = raywalk("bench", "bunny")
    assert (got.exit_code, got.stderr) == (1, "raywalk: the benchmark of bunny ended as failed: no memory\n")


def test_bench_usage(raywalk, ready) -> None:
    assert raywalk("bench", "bunny", "--techniques", "bvh").exit_code == 2
    got = raywalk("bench", "bunny", "--modes", "fast")
    assert (got.exit_code, got.stderr.count("\n")) == (1, 1)


def test_doctor(raywalk, ready) -> None:
    got = raywalk("doctor")
    assert got.exit_code == 1
    lines = got.stdout.splitlines()
    assert all(line.split()[0] in ("ok", "warn", "fail") for line in lines)
    assert any(line.startswith("fail techniques: missing: grid/dda") for line in lines)
    assert any(line.startswith("ok   Embree") for line in lines)


def doctor_with(raywalk, ready, **device) -> list[str]:
    ready.on("GET", "/v1/system", SYSTEM | {"device": SYSTEM["device"] | device})
    return raywalk("doctor").stdout.splitlines()


def test_doctor_shows_a_gpu(raywalk, ready) -> None:
    memory = {"total_bytes": 85_000_000_000, "free_bytes": 84_000_000_000, "resident_bytes": 100_000_000}
    details = {"driver": "580.95", "architecture": "sm_90"}
    lines = doctor_with(raywalk, ready, name="H100", kind="cuda", details=details, memory=memory)
    assert "ok   device: H100 (cuda), 2 threads" in lines
    assert "ok   device details: architecture sm_90, driver 580.95" in lines
    assert "ok   device memory: 85.0 GB, 84.0 GB free, 0.1 GB scenes and structures" in lines
    assert not any("GPU" in line for line in lines)


@pytest.mark.parametrize(
    ("reason", "advice"),
    [
        ("libcuda.so.1 was not found.", " → for a GPU, install NVIDIA's driver; without one the CPU renders"),
        ("There is no kernel compiler (NVRTC).", " → pip install nvidia-cuda-nvrtc"),
        (
            "The kernel compiler NVRTC (libnvrtc.so.13) is too new for the driver: it is 13.0, and the driver supports "
            "CUDA 12.8.",
            " → pip install 'nvidia-cuda-nvrtc-cu12>=12.4'",
        ),
        ("The driver shows no device of it all.", " → for a GPU, install NVIDIA's driver; without one the CPU renders"),
        ("It is a toy.", ""),
    ],
)
def test_doctor_says_why_there_is_no_gpu(raywalk, ready, reason, advice) -> None:
    assert f"warn GPU: not used: {reason}{advice}" in doctor_with(raywalk, ready, no_cuda=reason)


def test_doctor_tells_a_missing_gpu_once(raywalk, ready) -> None:
    why = "libcuda.so.1 was not found."
    device = SYSTEM["device"] | {"no_cuda": why}
    ready.on(
        "GET", "/v1/system", SYSTEM | {"device": device, "warnings": [f"No GPU is used. {why}", "The disk is full."]}
    )
    lines = raywalk("doctor").stdout.splitlines()
    assert sum(why in line for line in lines) == 1
    assert "warn daemon: The disk is full." in lines


def test_a_device_is_for_a_daemon_of_ones_own() -> None:
    got = CliRunner().invoke(app, ["--server", "http://127.0.0.1:9", "--device", "cpu", "doctor"])
    assert (got.exit_code, "--device is for a daemon" in got.stderr) == (2, True)
    assert CliRunner().invoke(app, ["--device", "tpu", "doctor"]).exit_code == 2
