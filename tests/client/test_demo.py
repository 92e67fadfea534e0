"""The demo from start to end with the real daemon, on a tiny walkthrough."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from PIL import Image
from raywalk.errors import RaywalkError
from raywalk.models import BenchmarkResult
from raywalk.places import daemon_program

TECHNIQUES = {"grid/dda", "kdtree/short-stack-3", "kdtree/short-stack-2", "bvh/packet", "bvh/while-while"}


def has_daemon() -> bool:
    try:
        return bool(daemon_program())
    except RaywalkError:
        return False


@pytest.mark.skipif(not has_daemon(), reason="raywalkd is not built")
def test_demo(tmp_path: Path) -> None:
    command = [sys.executable, "-c", "from raywalk.cli import main; main()", "demo", "--scene", "bunny"]
    command += ["--frames", "2", "--size", "48x32", "--out", str(tmp_path / "out")]
    environment = {
        key: value for key, value in os.environ.items() if key not in ("RAYWALK_SERVER", "RAYWALK_SCENE_DATA")
    }
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    assert "Table 2" in done.stdout
    assert "bvh/while-while" in done.stdout

    out = tmp_path / "out"
    names = {path.name for path in out.iterdir()}
    assert names == {"table1.md", "table2.md", "results.json", "frames", "contact-sheet.png"}
    assert len(list((out / "frames").glob("*.png"))) == 2
    assert Image.open(out / "frames/0000.png").size == (48, 32)
    assert Image.open(out / "contact-sheet.png").width > 1000

    result = BenchmarkResult.model_validate(json.loads((out / "results.json").read_text()))
    assert {f"{row.structure}/{row.traversal}" for row in result.rows} >= TECHNIQUES
    assert {row.mode for row in result.rows} == {"primary", "shadow", "whitted"}
    ours = [row for row in result.rows if row.structure != "embree"]  # whose default test leaks at edges
    assert all(row.error.id_mismatches == 0 for row in ours)
    assert "error ids ppm" in (out / "table2.md").read_text()


@pytest.mark.skipif(not has_daemon(), reason="raywalkd is not built")
def test_doctor_finds_nothing_wrong() -> None:
    command = [sys.executable, "-c", "from raywalk.cli import main; main()", "doctor"]
    environment = {key: value for key, value in os.environ.items() if key != "RAYWALK_SERVER"}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "fail" not in [line.split()[0] for line in done.stdout.splitlines()]
