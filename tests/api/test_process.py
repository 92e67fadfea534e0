"""The daemon as a process: flags, start, stop."""

import json
import signal
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

import httpx2
import pytest

from tests.api.conftest import find_daemon, wait_for_port

Starter = Callable[..., subprocess.Popen[str]]


def said(process: subprocess.Popen[str]) -> tuple[int, str]:
    _, errors = process.communicate(timeout=20)
    return process.returncode, errors


def test_port_file_and_clean_stop(starter: Starter, tmp_path: Path) -> None:
    for stop in (signal.SIGTERM, signal.SIGINT):
        process = starter("--port", "0", "--port-file", str(tmp_path / "port"))
        port = wait_for_port(process)
        assert int((tmp_path / "port").read_text()) == port
        assert httpx2.get(f"http://127.0.0.1:{port}/livez").status_code == 200
        begin = time.monotonic()
        process.send_signal(stop)
        assert said(process)[0] == 0
        assert time.monotonic() - begin < 5


def test_stop_while_a_benchmark_and_a_stream_run(starter: Starter) -> None:
    process = starter("--port", "0")
    client = httpx2.Client(base_url=f"http://127.0.0.1:{wait_for_port(process)}", timeout=30)
    spec = {"scene": "soup", "frames": 100_000, "width": 128, "height": 128}
    job = client.post("/v1/jobs", json={"kind": "benchmark", "spec": spec}).json()
    with client.stream("GET", f"/v1/jobs/{job['id']}/events") as stream:
        next(stream.iter_lines())
        begin = time.monotonic()
        process.send_signal(signal.SIGTERM)
        code, errors = said(process)
    assert code == 0, errors
    assert time.monotonic() - begin < 10


def test_port_in_use(starter: Starter) -> None:
    port = wait_for_port(starter("--port", "0"))
    code, errors = said(starter("--port", str(port)))
    assert code == 4
    assert f"Port {port} is in use" in errors
    assert errors.count("\n") <= 2, errors


@pytest.mark.parametrize(
    ("flags", "code", "words"),
    [
        (["--host", "0.0.0.0"], 2, "loopback"),
        (["--state", "/proc/nothing"], 2, "cannot be written"),
        (["--scenes", "/nothing"], 2, "no folder of scenes"),
        (["--device", "abacus"], 2, "--device"),
        (["--port", "70000"], 2, "--port"),
        (["--nonsense"], 2, "--nonsense"),
    ],
)
def test_bad_settings_say_one_sentence(tmp_path: Path, flags: list[str], code: int, words: str) -> None:
    state = [] if "--state" in flags else ["--state", str(tmp_path)]
    ended = subprocess.run([find_daemon(), "--port", "0", *state, *flags], capture_output=True, text=True, timeout=20)
    assert ended.returncode == code
    assert words in ended.stderr + ended.stdout


@pytest.mark.parametrize("variable", ["RAYWALK_LIBCUDA", "CUDA_VISIBLE_DEVICES"])
def test_no_gpu_is_one_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, variable: str) -> None:
    """No driver at all, or one that shows no device."""
    monkeypatch.setenv(variable, "/nothing/libcuda.so.1" if variable == "RAYWALK_LIBCUDA" else "")
    command = [find_daemon(), "--port", "0", "--state", str(tmp_path), "--device", "cuda"]
    ended = subprocess.run(command, capture_output=True, text=True, timeout=20)
    assert ended.returncode == 3
    assert ended.stderr.startswith("raywalkd: --device cuda cannot be had. "), ended.stderr
    assert ended.stderr.count("\n") == 1, ended.stderr


def test_auto_falls_back_and_says_so(starter: Starter) -> None:
    port = wait_for_port(starter("--port", "0", "--device", "auto", "--threads", "1"))
    system = httpx2.get(f"http://127.0.0.1:{port}/v1/system").json()
    assert system["device"]["requested"] == "auto"
    if reason := system["device"]["no_cuda"]:
        assert system["device"]["kind"] == "cpu"
        assert any(warning.endswith(reason) for warning in system["warnings"])
    else:
        assert system["device"]["kind"] == "cuda"
    assert system["machine"]["threads"] == 1


def test_json_log(starter: Starter) -> None:
    process = starter("--port", "0", "--log-json")
    wait_for_port(process)
    process.send_signal(signal.SIGTERM)
    code, errors = said(process)
    assert code == 0
    messages = [json.loads(line)["message"] for line in errors.splitlines()]
    assert any("stopp" in message for message in messages)


def test_version() -> None:
    ended = subprocess.run([find_daemon(), "--version"], capture_output=True, text=True, timeout=20)
    assert ended.stdout.startswith("raywalkd ")
