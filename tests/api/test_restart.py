"""What outlives the daemon: a crash under the supervisor, a stop in good order, a second daemon on the same folder."""

import os
import re
import signal
import socket
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import httpx2
import pytest

from tests.api.conftest import START_LIMIT_S, Daemon, find_daemon, ply, start, wait_for_port
from tests.api.test_jobs import LONG, SMALL

RESTART_LIMIT_S = 30.0


@contextmanager
def supervised(state: Path, *flags: str) -> Iterator[Daemon]:
    """A daemon under a supervisor; `process` is the supervisor."""
    process = start(state, "--port", "0", "--supervise", *flags)
    try:
        port = wait_for_port(process)
        with httpx2.Client(base_url=f"http://127.0.0.1:{port}", timeout=60.0) as client:
            yield Daemon(process, port, client)
    finally:
        if process.poll() is None:
            process.kill()
        process.communicate()


def child_of(supervisor: subprocess.Popen[str]) -> int | None:
    """The process id of the daemon that runs now."""
    children = Path(f"/proc/{supervisor.pid}/task/{supervisor.pid}/children").read_text().split()
    return int(children[0]) if children else None


def crash(daemon: Daemon) -> None:
    """Kills the child and waits until another one answers on the same port."""
    before = child_of(daemon.process)
    assert before is not None
    os.kill(before, signal.SIGKILL)
    end = time.monotonic() + RESTART_LIMIT_S
    while time.monotonic() < end:
        if child_of(daemon.process) not in (before, None):
            try:
                if daemon.client.get("/readyz").status_code == 200:
                    return
            except httpx2.TransportError:
                pass
        time.sleep(0.02)
    pytest.fail("the daemon did not come back")


def result_bytes(daemon: Daemon, job: str) -> tuple[bytes, bytes]:
    answers = [
        daemon.client.get(f"/v1/results/{job}", headers={"Accept": kind}) for kind in ("application/json", "text/csv")
    ]
    assert [answer.status_code for answer in answers] == [200, 200], answers[0].text
    assert answers[1].headers["content-type"] == "text/csv"
    return answers[0].content, answers[1].content


def words_of(process: int) -> list[str]:
    """The command line."""
    return Path(f"/proc/{process}/cmdline").read_text().split("\0")[:-1]


def resident(daemon: Daemon) -> dict[str, int]:
    """Triangles of the loaded scenes."""
    scenes = daemon.json("GET", "/v1/scenes", 200)["scenes"]
    return {scene["name"]: scene["triangles"] for scene in scenes if scene["loaded"]}


def test_crash_in_mid_job(tmp_path: Path) -> None:
    with supervised(tmp_path) as daemon:
        port = daemon.port
        daemon.load("soup", triangles=1000)
        bvh = daemon.build("soup", "bvh", {"max_leaf": 2})
        daemon.build("soup", "grid")
        assert daemon.client.delete("/v1/structures/soup.grid").status_code == 204
        daemon.client.put("/v1/scenes/mine", content=ply(3), headers={"Content-Type": "application/octet-stream"})
        spec = {**SMALL, "modes": ["trace"], "techniques": [{"structure": "bvh", "traversal": "packet"}]}
        done = daemon.finish(daemon.submit(spec, **{"Idempotency-Key": "done"}))
        assert done["state"] == "succeeded", done
        bytes_before = result_bytes(daemon, done["id"])
        running = daemon.submit(LONG, **{"Idempotency-Key": "running"})
        queued = [daemon.submit({**spec, "frames": frames}) for frames in (3, 4)]
        daemon.wait(f"/v1/jobs/{running['id']}", lambda j: j["frames_done"] > 0)

        crash(daemon)

        assert daemon.port == port
        failed = daemon.json("GET", f"/v1/jobs/{running['id']}", 200)
        assert (failed["state"], failed["attempt"], failed["result"]) == ("failed", 1, None)
        assert failed["error"]["code"] == "daemon_crashed"
        assert "measuring" in failed["error"]["detail"]
        assert not failed["error"]["retryable"]
        assert daemon.json("GET", f"/v1/jobs/{done['id']}", 200) == done
        assert result_bytes(daemon, done["id"]) == bytes_before
        ends = [daemon.finish(job) for job in queued]
        assert [(job["state"], job["attempt"]) for job in ends] == [("succeeded", 2)] * 2, ends
        assert ends[0]["ended_at"] <= ends[1]["started_at"], "their order is kept"
        result = daemon.json("GET", f"/v1/results/{queued[0]['id']}", 200)
        assert result["scene"]["triangles"] == 1000, "a queued job finds the scene that was resident"
        assert resident(daemon) == {"soup": 1000}
        again = daemon.wait(f"/v1/structures/{bvh['id']}", lambda s: s["state"] == "ready")
        assert again["options"] == bvh["options"]
        assert again["options"]["max_leaf"] == 2
        daemon.problem("GET", "/v1/structures/soup.grid", 404, "unknown_structure")
        assert daemon.submit(spec, 200, **{"Idempotency-Key": "done"})["id"] == done["id"]
        assert daemon.submit(LONG, 200, **{"Idempotency-Key": "running"})["state"] == "failed"

        daemon.process.send_signal(signal.SIGTERM)
        _, errors = daemon.process.communicate(timeout=START_LIMIT_S)
        assert daemon.process.returncode == 0, errors
        assert re.search(r"ended by signal 9 \(Killed\); it is started again", errors), errors

    with supervised(tmp_path) as daemon:
        for job in (done, failed, *ends):
            assert daemon.json("GET", f"/v1/jobs/{job['id']}", 200) == job
        assert result_bytes(daemon, done["id"]) == bytes_before


def test_stop_in_good_order(tmp_path: Path) -> None:
    with supervised(tmp_path) as daemon:
        daemon.load("soup", triangles=1000)
        running, queued = daemon.submit(LONG), daemon.submit(SMALL)
        daemon.wait(f"/v1/jobs/{running['id']}", lambda j: j["frames_done"] > 0)
        child = child_of(daemon.process)
        daemon.process.send_signal(signal.SIGTERM)
        assert daemon.process.wait(timeout=START_LIMIT_S) == 0
        assert not Path(f"/proc/{child}").exists()
        with pytest.raises(httpx2.TransportError):
            daemon.client.get("/livez")
    with supervised(tmp_path) as daemon:
        interrupted = daemon.json("GET", f"/v1/jobs/{running['id']}", 200)
        assert (interrupted["state"], interrupted["error"]) == ("interrupted", None)
        assert daemon.json("GET", f"/v1/jobs/{queued['id']}", 200)["attempt"] == 1
        daemon.json("POST", f"/v1/jobs/{queued['id']}/cancel", 200)


def test_nothing_is_restored_after_a_stop(tmp_path: Path) -> None:
    for expected in ({}, {}):
        with supervised(tmp_path) as daemon:
            assert resident(daemon) == expected
            daemon.load("soup", triangles=500)
            assert resident(daemon) == {"soup": 500}
            daemon.process.send_signal(signal.SIGINT)
            assert daemon.process.wait(timeout=START_LIMIT_S) == 0


@pytest.mark.parametrize("flag", ["--supervise=true", "--supervise"])
def test_the_child_is_no_supervisor(tmp_path: Path, flag: str) -> None:
    with supervised(tmp_path, flag) as daemon:
        child = child_of(daemon.process)
        assert child is not None
        with_children = Path(f"/proc/{child}/task").glob("*/children")
        assert [path.read_text() for path in with_children if path.read_text()] == []
        daemon.process.send_signal(signal.SIGTERM)
        assert daemon.process.wait(timeout=START_LIMIT_S) == 0


@pytest.mark.parametrize("flags", [["--fault-after=1000"], ["--fault-after", "1000"]])
def test_a_fault_on_purpose_comes_once(tmp_path: Path, flags: list[str]) -> None:
    with supervised(tmp_path, *flags) as daemon:
        first = child_of(daemon.process)
        assert first is not None
        assert "--fault-after=0" not in words_of(first)
        for _ in range(2):
            crash(daemon)
            child = child_of(daemon.process)
            assert child is not None
            assert [word for word in words_of(child) if "fault" in word][-1] == "--fault-after=0"


def test_a_start_that_fails_keeps_what_was_resident(tmp_path: Path) -> None:
    first = start(tmp_path, "--port", "0", "--device", "cpu")
    port = wait_for_port(first)
    with httpx2.Client(base_url=f"http://127.0.0.1:{port}", timeout=60.0) as client:
        Daemon(first, port, client).load("soup", triangles=500)
    first.kill()
    first.communicate()
    with socket.create_server(("127.0.0.1", port)):
        failed = start(tmp_path, "--port", str(port), "--device", "cpu")
        _, errors = failed.communicate(timeout=START_LIMIT_S)
    assert failed.returncode == 4, errors
    with supervised(tmp_path, "--device", "cpu") as daemon:
        end = time.monotonic() + RESTART_LIMIT_S
        while not resident(daemon) and time.monotonic() < end:
            time.sleep(0.02)
        assert resident(daemon) == {"soup": 500}


def test_a_crash_loop_gives_up(tmp_path: Path) -> None:
    with supervised(tmp_path) as daemon:
        children: list[int] = []
        end = time.monotonic() + 60
        while daemon.process.poll() is None and time.monotonic() < end:
            child = child_of(daemon.process) if daemon.process.poll() is None else None
            if child is not None and child not in children:
                children.append(child)
                os.kill(child, signal.SIGKILL)
            time.sleep(0.01)
        _, errors = daemon.process.communicate(timeout=START_LIMIT_S)
    assert daemon.process.returncode == 1
    assert len(children) == 6
    assert errors.splitlines()[-1].startswith("raywalkd: The daemon crashed 6 times within 60 s"), errors


def test_the_daemon_ends_with_its_supervisor(tmp_path: Path) -> None:
    with supervised(tmp_path) as daemon:
        child = child_of(daemon.process)
        daemon.process.kill()
        end = time.monotonic() + START_LIMIT_S
        while Path(f"/proc/{child}").exists() and time.monotonic() < end:
            time.sleep(0.02)
        assert not Path(f"/proc/{child}").exists()


@pytest.mark.parametrize("flags", [[], ["--supervise"]])
def test_one_daemon_a_state_folder(tmp_path: Path, flags: list[str]) -> None:
    with supervised(tmp_path) as daemon:
        command = [find_daemon(), "--port", "0", "--state", str(tmp_path), *flags]
        ended = subprocess.run(command, capture_output=True, text=True, timeout=START_LIMIT_S)
        assert ended.returncode == 2
        assert ended.stderr.count("Another daemon uses the state folder") == 1
        assert ended.stderr.count("\n") == 1, ended.stderr
        assert daemon.client.get("/livez").status_code == 200


def test_settings_end_the_supervisor(tmp_path: Path) -> None:
    with supervised(tmp_path) as daemon:
        for flags, code in ((["--port", str(daemon.port)], 4), (["--port", "0", "--scenes", "/nothing"], 2)):
            command = [find_daemon(), "--supervise", "--state", str(tmp_path / "other"), *flags]
            ended = subprocess.run(command, capture_output=True, text=True, timeout=START_LIMIT_S)
            assert ended.returncode == code, ended.stderr
            assert ended.stderr.count("\n") == 1, ended.stderr
