"""Starts the real daemon on a free port; tests talk HTTP to it."""

import json
import os
import signal
import struct
import subprocess
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import httpx2
import pytest

ROOT = Path(__file__).resolve().parents[2]
START_LIMIT_S = 20.0
LOAD_SLACK_S = 60.0


def find_daemon() -> Path:
    """The binary of $RAYWALKD, else the newest one of the build folders."""
    if named := os.environ.get("RAYWALKD"):
        return Path(named)
    built = sorted(ROOT.glob("build/*/server/raywalkd"), key=lambda path: path.stat().st_mtime)
    if not built:
        pytest.fail("raywalkd is not built; run ./run build")
    return built[-1]


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line("markers", "slow: takes long; run with ./run test --slow")


def start(state: Path, *flags: str) -> subprocess.Popen[str]:
    command = [str(find_daemon()), "--state", str(state), "--die-with-parent", *flags]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


@dataclass
class Daemon:
    process: subprocess.Popen[str]
    port: int
    client: httpx2.Client

    def json(self, method: str, path: str, status: int, body: Any = None, **more: Any) -> Any:
        """The JSON of an answer whose status must be `status`."""
        answer = self.client.request(method, path, json=body, **more)
        assert answer.status_code == status, answer.text
        return answer.json()

    def problem(self, method: str, path: str, status: int, code: str, **more: Any) -> dict[str, Any]:
        """The problem of a refused request, which must be well formed."""
        answer = self.client.request(method, path, **more)
        return check_problem(answer, status, code)

    def load(self, name: str, **more: Any) -> dict[str, Any]:
        answer = self.client.post("/v1/scenes", json={"name": name, **more})
        assert answer.status_code in (200, 201), answer.text
        return answer.json()

    def build(self, scene: str, kind: str, options: dict[str, Any] | None = None) -> dict[str, Any]:
        """The structure once it is ready."""
        answer = self.client.post("/v1/structures", json={"scene": scene, "kind": kind, "options": options or {}})
        assert answer.status_code in (200, 202), answer.text
        return self.wait(f"/v1/structures/{answer.json()['id']}", lambda s: s["state"] != "building")

    def wait(self, path: str, until: Callable[[dict[str, Any]], bool], limit_s: float = LOAD_SLACK_S) -> dict[str, Any]:
        end = time.monotonic() + limit_s
        while time.monotonic() < end:
            value = self.json("GET", path, 200)
            if until(value):
                return value
            time.sleep(0.02)
        pytest.fail(f"{path} did not get there: {value}")

    def frame(
        self, scene: str, structure: str, traversal: str, accept: str = "image/jpeg", **more: Any
    ) -> httpx2.Response:
        body = {"scene": scene, "structure": structure, "traversal": traversal, "width": 64, "height": 48, **more}
        return self.client.post("/v1/frames", json=body, headers={"Accept": accept})

    def submit(self, spec: dict[str, Any], status: int = 202, **headers: str) -> dict[str, Any]:
        return self.json("POST", "/v1/jobs", status, {"kind": "benchmark", "spec": spec}, headers=headers)

    def finish(self, job: dict[str, Any]) -> dict[str, Any]:
        """The job once it has ended."""
        ended = ("succeeded", "failed", "cancelled", "interrupted")
        return self.wait(f"/v1/jobs/{job['id']}", lambda j: j["state"] in ended)


def check_problem(answer: httpx2.Response, status: int, code: str) -> dict[str, Any]:
    assert answer.status_code == status, answer.text
    assert answer.headers["content-type"] == "application/problem+json"
    problem = answer.json()
    assert problem["code"] == code, problem
    assert problem["status"] == status
    assert problem["request_id"] == answer.headers["x-request-id"]
    assert problem["detail"]
    return problem


def pointers(problem: dict[str, Any]) -> set[str]:
    return {error["pointer"] for error in problem["errors"]}


@pytest.fixture
def starter(tmp_path: Path) -> Iterator[Callable[..., subprocess.Popen[str]]]:
    """Starts daemons with any flags; those that still run are ended."""
    started: list[subprocess.Popen[str]] = []

    def launch(*flags: str) -> subprocess.Popen[str]:
        started.append(start(tmp_path / f"state{len(started)}", *flags))
        return started[-1]

    yield launch
    for process in started:
        if process.poll() is None:
            process.kill()
        process.communicate()


def wait_for_port(process: subprocess.Popen[str]) -> int:
    assert process.stdout is not None
    line = process.stdout.readline()
    if not line.startswith("listening on http://127.0.0.1:"):
        pytest.fail(f"the daemon did not start: {line}{process.communicate()[1]}")
    return int(line.rsplit(":", 1)[1])


@contextmanager
def running_daemon(state: Path) -> Iterator[Daemon]:
    """A daemon on the CPU, whatever the machine has; it must stop cleanly at the end."""
    process = start(state, "--port", "0", "--device", "cpu", "--log-level", "warn")
    port = wait_for_port(process)
    with httpx2.Client(base_url=f"http://127.0.0.1:{port}", timeout=60.0) as client:
        yield Daemon(process, port, client)
    process.send_signal(signal.SIGTERM)
    _, errors = process.communicate(timeout=START_LIMIT_S)
    assert process.returncode == 0, errors


@pytest.fixture(scope="session")
def daemon(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Daemon]:
    """One daemon for all tests: each must cope with what others leave in it."""
    with running_daemon(tmp_path_factory.mktemp("state")) as daemon:
        yield daemon


@pytest.fixture(scope="session")
def soup(daemon: Daemon) -> str:
    """A loaded scene of a thousand triangles with three structures."""
    daemon.load("soup", triangles=1000)
    for kind in ("brute", "bvh", "embree"):
        assert daemon.build("soup", kind)["state"] == "ready"
    return "soup"


def ply(triangles: int, declared: int | None = None) -> bytes:
    """A binary PLY of separate triangles in the plane z = 0; `declared` is the face count that its header names."""
    count = triangles if declared is None else declared
    header = (
        f"ply\nformat binary_little_endian 1.0\nelement vertex {3 * count}\nproperty float x\nproperty float y\n"
        f"property float z\nelement face {count}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    vertices = b"".join(struct.pack("<9f", 2 * i, 0, 0, 2 * i + 1, 0, 0, 2 * i, 1, 0) for i in range(triangles))
    faces = b"".join(struct.pack("<B3i", 3, 3 * i, 3 * i + 1, 3 * i + 2) for i in range(triangles))
    return header.encode() + vertices + faces


def events_of(lines: Iterator[str]) -> Iterator[tuple[int, dict[str, Any]]]:
    """(id, job) of each event of a stream."""
    number = 0
    for line in lines:
        if line.startswith("id: "):
            number = int(line[4:])
        elif line.startswith("data: "):
            yield number, json.loads(line[6:])
