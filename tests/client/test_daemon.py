"""A daemon of one's own, played by small scripts."""

import os
import signal
import stat
import subprocess
import sys
import textwrap
import time
from pathlib import Path

import pytest
from raywalk import nvrtc
from raywalk.client import Client
from raywalk.daemon import LocalDaemon
from raywalk.errors import RaywalkError, UnreachableError
from raywalk.places import daemon_program

SERVER = """
import http.server, os, sys
class Handler(http.server.BaseHTTPRequestHandler):
    def do_GET(self):
        self.send_response(200); self.end_headers(); self.wfile.write(b"ok")
    def log_message(self, *_): pass
server = http.server.HTTPServer(("127.0.0.1", 0), Handler)
flags = dict(zip(sys.argv[1::2], sys.argv[2::2]))
assert flags["--port"] == "0" and flags["--state"] and flags["--kernel-cache"].endswith("raywalk/kernels")
if "PID_FILE" in os.environ: open(os.environ["PID_FILE"], "w").write(str(os.getpid()))
open(flags["--port-file"], "w").write(str(server.server_address[1]))
server.serve_forever()
"""


def script(folder: Path, body: str) -> Path:
    path = folder / "raywalkd"
    path.write_text(f"#!{sys.executable}\n" + textwrap.dedent(body))
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return path


def is_alive(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return True


def test_starts_and_stops(tmp_path) -> None:
    with LocalDaemon(script(tmp_path, SERVER)) as daemon:
        assert daemon.base_url.startswith("http://127.0.0.1:")
        pid = daemon._process.pid
        assert is_alive(pid)
    assert not is_alive(pid)


TELLS = "import os, pathlib; pathlib.Path(os.environ['TOLD']).write_text(os.environ.get('RAYWALK_NVRTC', 'none'))\n"


@pytest.mark.parametrize(
    ("variable", "wheels", "told"),
    [
        (None, ["/w/libnvrtc.so.13"], "/w/libnvrtc.so.13"),
        (None, ["/w/libnvrtc.so.13", "/w/libnvrtc.so.12"], "/w/libnvrtc.so.13:/w/libnvrtc.so.12"),
        ("/own.so", ["/w/libnvrtc.so.13"], "/own.so"),
        (None, [], "none"),
    ],
)
def test_names_the_kernel_compiler_of_python(tmp_path, monkeypatch, variable, wheels, told) -> None:
    monkeypatch.setenv("TOLD", str(tmp_path / "told"))
    monkeypatch.setattr(nvrtc, "wheel_libraries", lambda: [Path(wheel) for wheel in wheels])
    monkeypatch.setenv("RAYWALK_NVRTC", variable) if variable else monkeypatch.delenv("RAYWALK_NVRTC", raising=False)
    with LocalDaemon(script(tmp_path, TELLS + SERVER)):
        assert (tmp_path / "told").read_text() == told


def test_finds_the_kernel_compiler_of_python(monkeypatch) -> None:
    libraries = nvrtc.wheel_libraries()
    assert libraries and all(path.is_file() and path.name.startswith("libnvrtc.so.") for path in libraries)
    monkeypatch.setattr(nvrtc, "WHEELS", ("no-such-wheel",))
    assert nvrtc.wheel_libraries() == []


def test_stops_after_an_exception(tmp_path) -> None:
    with pytest.raises(ZeroDivisionError), LocalDaemon(script(tmp_path, SERVER)) as daemon:
        pid = daemon._process.pid
        raise ZeroDivisionError
    assert not is_alive(pid)


def test_says_why_it_did_not_start(tmp_path) -> None:
    failing = script(tmp_path, 'import sys; sys.exit("raywalkd: the port 80 is in use")')
    with pytest.raises(RaywalkError, match="(?s)ended at its start with code 1.*the port 80 is in use"):
        LocalDaemon(failing).__enter__()


def test_a_program_that_cannot_be_started(tmp_path) -> None:
    (tmp_path / "raywalkd").write_bytes(b"\x7fELF nonsense")
    (tmp_path / "raywalkd").chmod(0o755)
    with pytest.raises(RaywalkError, match="could not be started"):
        LocalDaemon(tmp_path / "raywalkd").__enter__()


def test_says_at_once_when_it_ended(tmp_path) -> None:
    pauses: list[float] = []
    with LocalDaemon(script(tmp_path, 'print("about to fail", flush=True)' + "\n" + SERVER)) as daemon:
        client = Client(daemon.base_url, sleep=pauses.append, on_lost=daemon.check_alive)
        assert client.get_livez() == "ok"
        daemon._process.kill()
        with pytest.raises(UnreachableError, match=r"(?s)started ended \(signal 9\).*about to fail"), client:
            client.get_livez()
    assert pauses == []


def test_a_living_daemon_is_tried_again(tmp_path) -> None:
    with LocalDaemon(script(tmp_path, SERVER)) as daemon:
        daemon.check_alive()


def test_finds_the_program(tmp_path, monkeypatch) -> None:
    program = script(tmp_path, SERVER)
    monkeypatch.setenv("RAYWALKD", str(program))
    assert daemon_program() == program
    monkeypatch.setenv("RAYWALKD", str(tmp_path / "none"))
    with pytest.raises(RaywalkError, match="raywalkd was not found"):
        daemon_program()


@pytest.mark.parametrize("stop", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_stops_both(tmp_path, stop) -> None:
    pid_file = tmp_path / "pid"
    environment = os.environ | {"PID_FILE": str(pid_file)}
    code = "import signal, sys, time, raywalk, pathlib\n"
    code += "signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))\n"
    code += f"with raywalk.LocalDaemon(pathlib.Path({str(script(tmp_path, SERVER))!r})): time.sleep(60)"
    parent = subprocess.Popen([sys.executable, "-c", code], env=environment, stderr=subprocess.DEVNULL)
    deadline = time.monotonic() + 20
    while not pid_file.is_file() or not pid_file.read_text():
        assert time.monotonic() < deadline
        time.sleep(0.02)
    time.sleep(0.3)
    parent.send_signal(stop)
    parent.wait(20)
    assert not is_alive(int(pid_file.read_text()))
