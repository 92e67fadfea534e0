"""Requests made from the contract, good and bad: no answer may break it."""

import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.api.conftest import ROOT, Daemon, running_daemon

SEED = "20260101"


@pytest.fixture
def fresh_daemon(tmp_path: Path) -> Iterator[Daemon]:
    """Its own, because these requests evict scenes and submit jobs at will."""
    with running_daemon(tmp_path) as daemon:
        yield daemon


def run(daemon: Daemon, examples: int, phases: str) -> None:
    daemon.load("soup", triangles=200)
    daemon.build("soup", "bvh")
    command = [sys.executable, "-c", "from schemathesis.cli import schemathesis; schemathesis()"]
    command += ["--config-file", str(ROOT / "tests" / "api" / "schemathesis.toml")]
    command += ["run", str(ROOT / "proto" / "openapi.yaml"), "--url", f"http://127.0.0.1:{daemon.port}"]
    command += ["--max-examples", str(examples), "--phases", phases, "--seed", SEED, "--generation-deterministic"]
    command += ["--request-timeout", "30", "--no-color"]
    environment = {**os.environ, "NO_COLOR": "1", "COLUMNS": "160"}
    ended = subprocess.run(command, capture_output=True, text=True, timeout=900, env=environment, cwd=ROOT / "proto")
    assert ended.returncode == 0, ended.stdout[-8000:] + ended.stderr[-2000:]
    assert daemon.client.get("/livez").status_code == 200


def test_contract_holds(fresh_daemon: Daemon) -> None:
    run(fresh_daemon, 10, "coverage,fuzzing")


@pytest.mark.slow
def test_contract_holds_for_many_requests(fresh_daemon: Daemon) -> None:
    run(fresh_daemon, 30, "coverage,fuzzing,stateful")
