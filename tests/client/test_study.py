"""The study with the real daemon on tiny scenes of its own: from start to end, killed and taken up again."""

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from PIL import Image
from raywalk.errors import RaywalkError
from raywalk.models import Bounds, Scene
from raywalk.places import checkout, daemon_program
from raywalk.study.measure import Measurer, grid_options, modes_of
from raywalk.study.parameters import SCENES, parameters_of
from raywalk.study.plan import plan, resolutions
from raywalk.study.run import Run
from raywalk.study.store import Store, differing

from tests.client.study_parts import figures_of

NAMES = ("robots", "bunny", "office")  # robots has a figure over resolution; bunny no secondary rays in the paper
STEPS = 3 * 2 + 5
LIMIT_S = 240


def has_daemon() -> bool:
    try:
        return bool(daemon_program())
    except RaywalkError:
        return False


needs_daemon = pytest.mark.skipif(not has_daemon(), reason="raywalkd is not built")


@pytest.fixture
def program(tmp_path: Path) -> Path:
    """A daemon whose catalogue has scenes of the study's names and a few hundred triangles."""
    shelf = tmp_path / "scenes"
    shutil.copytree(checkout() / "scenes" / "common", shelf / "common")
    for name in NAMES:
        manifest = json.loads((checkout() / "scenes" / "soup" / "scene.json").read_text())
        manifest["title"] = f"A tiny {name}"
        manifest["source"] = {"generator": {"name": "soup", "triangles": 300}}
        manifest["materials"][0]["reflection"] = [0.5, 0.5, 0.5]
        (shelf / name).mkdir()
        (shelf / name / "scene.json").write_text(json.dumps(manifest))
    wrapper = tmp_path / "raywalkd"
    wrapper.write_text(f'#!/bin/sh\nexec "{daemon_program()}" --scenes "{shelf}" --data "{shelf}" "$@"\n')
    wrapper.chmod(0o755)
    return wrapper


def command(out: Path, *words: str) -> list[str]:
    start = [sys.executable, "-c", "from raywalk.cli import main; main()"]
    own = [] if "--server" in words else ["--device", "cpu"]
    place = [*words[:2], "study"] if "--server" in words else ["study", *words]
    named = () if "--scenes" in words else ("--scenes", ",".join(NAMES))
    return [*start, *own, *place, *named, "--size", "24x16", "--frames", "2", "--out", str(out)]


def environment(program: Path) -> dict[str, str]:
    kept = {key: value for key, value in os.environ.items() if key not in ("RAYWALK_SERVER", "RAYWALK_SCENE_DATA")}
    return kept | {"RAYWALKD": str(program)}


def study(program: Path, out: Path, *words: str) -> subprocess.CompletedProcess:
    return subprocess.run(
        command(out, *words), env=environment(program), capture_output=True, text=True, timeout=LIMIT_S, check=False
    )


def begun(program: Path, out: Path, *words: str) -> subprocess.Popen:
    """A study that has finished at least one step."""
    process = subprocess.Popen(
        command(out, *words), env=environment(program), stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True
    )
    deadline = time.monotonic() + LIMIT_S
    while not steps(out):
        assert process.poll() is None and time.monotonic() < deadline, process.communicate()[1]
        time.sleep(0.002)
    return process


def steps(out: Path) -> dict[str, int]:
    """Finished steps with the time of their file."""
    return {path.name: path.stat().st_mtime_ns for path in (out / "steps").glob("*.json")}


@needs_daemon
def test_from_start_to_end(program: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    done = study(program, out)
    assert done.returncode == 0, done.stderr
    assert len(steps(out)) == STEPS
    assert done.stderr.count(", ") and f"{STEPS}/{STEPS} office: image" in done.stderr
    for words in ("Table 1", "Table 2a", "Table 2c", "pairs of scene and rays", "of the paper's 8 conclusions"):
        assert words in done.stdout, words
    for name in ("table1.md", "table2.tex", "table2.csv", "figure2.svg", "figure3.png", "FINDINGS.md", "report.html"):
        assert (out / name).is_file(), name
    assert not (out / "table3.md").exists()
    assert Image.open(out / "images/office.png").size == (72, 48)
    assert "A tiny robots" in (out / "report.html").read_text()
    kept = json.loads((out / "steps/robots-measure.json").read_text())["results"][0]
    assert {row["mode"] for row in kept["rows"]} == {"primary", "shadow", "whitted"}
    assert not list(out.glob("**/*.partial"))

    before = steps(out)
    again = study(program, out)
    assert again.returncode == 0, again.stderr
    assert f"{STEPS} of {STEPS} steps were finished before" in again.stderr
    assert "triangles" not in again.stderr  # nothing was loaded
    assert steps(out) == before

    other = study(program, out, "--modes", "primary")
    assert other.returncode == 1
    assert "holds another study: parameters modes is primary,shadow,whitted there and primary now" in other.stderr
    assert "--fresh" in other.stderr
    assert steps(out) == before

    fresh = study(program, out, "--modes", "primary", "--fresh", "--scenes", "office")
    assert fresh.returncode == 0, fresh.stderr
    assert set(steps(out)) == {"office-measure.json", "office-image.json"}


@needs_daemon
def test_killed_and_started_again(program: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    process = begun(program, out)
    process.send_signal(signal.SIGKILL)
    process.communicate()
    before = steps(out)
    assert 0 < len(before) < STEPS
    again = study(program, out)
    assert again.returncode == 0, again.stderr
    assert f"{len(before)} of {STEPS} steps were finished before" in again.stderr
    ran = [line for line in again.stderr.splitlines() if line.endswith(" s") and f"/{STEPS} " in line]
    assert len(ran) == STEPS - len(before)
    after = steps(out)
    assert len(after) == STEPS
    assert {name: after[name] for name in before} == before


@needs_daemon
def test_interrupted_leaves_a_report(program: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    process = begun(program, out)
    process.send_signal(signal.SIGINT)
    _, told = process.communicate(timeout=LIMIT_S)
    assert process.returncode == 130, told
    assert "interrupted" in told and "Traceback" not in told
    assert f"of {STEPS} steps are finished" in (out / "report.html").read_text()


@needs_daemon
def test_the_daemon_killed_in_between(program: Path, tmp_path: Path) -> None:
    out, port = tmp_path / "out", tmp_path / "port"
    flags = ["--port", "0", "--port-file", str(port), "--state", str(tmp_path / "state"), "--device", "cpu"]
    with subprocess.Popen([str(program), *flags], stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL) as daemon:
        try:
            deadline = time.monotonic() + 30
            while not (port.is_file() and port.read_text().strip()):
                assert time.monotonic() < deadline
                time.sleep(0.02)
            process = begun(program, out, "--server", f"http://127.0.0.1:{int(port.read_text())}")
        finally:
            daemon.kill()
    _, told = process.communicate(timeout=LIMIT_S)
    assert process.returncode == 1
    assert "Traceback" not in told
    before = steps(out)
    assert 0 < len(before) < STEPS
    assert f"{len(before)} of {STEPS} steps are finished" in (out / "FINDINGS.md").read_text()
    again = study(program, out)
    assert again.returncode == 0, again.stderr
    assert {name: steps(out)[name] for name in before} == before


@needs_daemon
def test_unknown_scenes_are_told(program: Path, tmp_path: Path) -> None:
    done = study(program, tmp_path / "out", "--scenes", "bunny,hare")
    assert done.returncode == 1
    assert "there is no scene 'hare'; known: bunny, office, robots" in done.stderr
    assert not (tmp_path / "out/study.json").exists()


class Shelf:
    """A client of which one scene cannot be loaded, and of which robots was loaded before."""

    def __init__(self) -> None:
        self.evicted: list[str] = []

    def get_scene(self, name: str) -> Scene:
        return scene_with(name, [1.0, 1.0, 1.0]).model_copy(update={"loaded": name == "robots"})

    def load_scene(self, name: str) -> Scene:
        if name == "bunny":
            raise RaywalkError("bunny.ply, line 3: no number")
        return self.get_scene(name)

    def delete_scene(self, name: str) -> None:
        self.evicted.append(name)


def test_a_broken_scene_is_left_out_and_others_evicted(monkeypatch, tmp_path: Path) -> None:
    monkeypatch.setattr(Measurer, "run", lambda *_: {})
    store, shelf = Store(tmp_path), Shelf()
    asked = parameters_of(["robots", "bunny", "office"], None, None, None, False)
    store.open({})
    run = Run(shelf, store, asked, gpu=False)
    run.run()
    assert run.failures == {"bunny": "bunny.ply, line 3: no number"}
    assert len(steps(tmp_path)) == 2 * 2 + 5
    assert shelf.evicted == ["bunny", "office"]  # robots was there before


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--scenes", "bunny,bunny"), "scene bunny is named twice"),
        (("--scenes", ","), "no scene is named"),
        (("--modes", "primary,trace"), "there is no mode 'trace' in the study; known: primary, shadow, whitted"),
        (("--modes", "primary,primary"), "mode primary is named twice"),
        (("--size", "64"), "'64' is no size"),
        (("--frames", "0"), "--frames"),
        (("--out", "/proc/none"), "cannot be written"),
    ],
)
def test_bad_input(raywalk, daemon, tmp_path: Path, words, message) -> None:
    out = () if "--out" in words else ("--out", tmp_path / "out")
    done = raywalk("study", *words, *out)
    assert done.exit_code in (1, 2)
    assert message in " ".join(done.stderr.replace("│", " ").split())
    assert not daemon.requests


def test_one_study_at_a_time(raywalk, daemon, tmp_path: Path) -> None:
    with Store(tmp_path).locked():
        done = raywalk("study", "--out", tmp_path)
    assert done.exit_code == 1 and "another study is running" in done.stderr


def test_another_device_is_refused_and_nothing_is_lost(tmp_path: Path) -> None:
    one = {"device": {"name": "A processor", "threads": 2}, "parameters": {"scenes": ["bunny"]}}
    store = Store(tmp_path)
    store.open(one)
    store.save(plan(parameters_of(["bunny"], None, None, None, False), False)[0], {"seconds": 1})
    other = {"device": {"name": "A GPU", "threads": 2}, "parameters": {"scenes": ["bunny"]}}
    with pytest.raises(RaywalkError, match="device name is A processor there and A GPU now. Nothing was changed"):
        store.open(other)
    assert len(steps(tmp_path)) == 1
    (tmp_path / "mine.txt").write_text("kept")
    store.open(other, fresh=True)
    assert not steps(tmp_path) and (tmp_path / "mine.txt").is_file()
    store.open(other)
    assert differing({"a": 1}, {"a": 1, "b": None}) == []


def test_a_damaged_identity_is_told(tmp_path: Path) -> None:
    (tmp_path / "study.json").write_text("{")
    with pytest.raises(RaywalkError, match=r"study.json cannot be read .* --fresh"):
        Store(tmp_path).open({})


def test_the_plan_keeps_a_scene_together() -> None:
    asked = parameters_of(None, None, None, None, gpu=True)
    steps_ = plan(asked, gpu=True)
    order = list(dict.fromkeys(step.scene for step in steps_))
    assert tuple(order) == SCENES
    assert [step.scene for step in steps_] == sorted((step.scene for step in steps_), key=order.index)
    assert len({step.key for step in steps_}) == len(steps_)
    assert [step.scene for step in steps_ if step.kind == "kernels"] == ["robots", "museum", "kitchen"]
    assert not [step for step in plan(asked, gpu=False) if step.kind == "kernels"]


def test_defaults_of_the_devices() -> None:
    cpu, gpu = (parameters_of(None, None, None, None, device) for device in (False, True))
    assert (gpu.size, gpu.frames, gpu.time_limit_s) == ("1024x1024", 400, None)
    assert (cpu.size, cpu.time_limit_s, cpu.command) == ("256x256", 25.0, "raywalk study --size 256x256")
    own = parameters_of(["bunny"], ["shadow", "primary"], 7, (300, 200), False)
    assert own.command == "raywalk study --scenes bunny --frames 7 --size 300x200 --modes primary,shadow"
    assert (own.image_width, own.image_height) == (768, 512)
    assert own.time_limit_s is None
    large = parameters_of(["bunny"], None, None, (8192, 4096), False)
    assert (large.image_width, large.image_height) == (8192, 4096)
    assert max(resolutions(large)) == (8192, 4096)
    assert resolutions(parameters_of(["bunny"], None, None, (1, 1), False)) == [(1, 1), (2, 2)]


def scene_with(name: str, hi: list[float]) -> Scene:
    scene = {"name": name, "title": name, "triangles": 1, "lights": 1, "fidelity": "original", "loaded": True}
    paper = {"table1": {"grid_cells": [10, 20, 30]}, "table2": figures_of("bunny").model_dump()["table2"]}
    made = Scene.model_validate(scene | {"warnings": [], "paper": paper})
    made.bounds = Bounds(lo=[0.0, 0.0, 0.0], hi=hi)
    return made


def test_the_grid_has_the_papers_cells_where_they_are_cubes() -> None:
    assert grid_options(scene_with("bunny", [1.0, 2.05, 3.0])) == {
        "resolution_x": 10.0,
        "resolution_y": 20.0,
        "resolution_z": 30.0,
    }
    lying = grid_options(scene_with("bunny", [3.0, 1.0, 2.0]))
    assert lying == {"resolution_x": 30.0, "resolution_y": 10.0, "resolution_z": 20.0}
    assert grid_options(scene_with("bunny", [1.0, 1.0, 1.0])) is None
    assert grid_options(scene_with("bunny", [1.0, 2.0, 0.0])) is None


def test_objects_have_no_secondary_rays_unless_nothing_else_is_asked_for() -> None:
    bunny = scene_with("bunny", [1.0, 1.0, 1.0])
    assert modes_of(bunny, ("primary", "shadow", "whitted")) == ["primary", "shadow"]
    assert modes_of(bunny, ("whitted",)) == ["whitted"]
    assert modes_of(bunny.model_copy(update={"paper": None}), ("shadow", "whitted")) == ["shadow", "whitted"]
