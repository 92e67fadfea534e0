"""A daemon of one's own: started on a free port, stopped afterwards."""

import os
import subprocess
import tempfile
import time
from pathlib import Path
from typing import Self

from raywalk import nvrtc
from raywalk.client import Client
from raywalk.errors import RaywalkError, UnreachableError
from raywalk.places import daemon_program, kernel_cache_dir

START_LIMIT_S = 30.0
STOP_LIMIT_S = 10.0
END_LIMIT_S = 0.5  # from the loss of its connections until a process counts as ended
LOG_LINES = 12


class LocalDaemon:
    """Context manager: runs raywalkd on a free port of the loopback address until the block ends, however it ends.

    Its state is kept in a folder of its own and dropped with it; compiled GPU kernels are kept. It compiles them with
    the NVRTC of the Python environment, unless RAYWALK_NVRTC names another. Throws RaywalkError with the daemon's last
    words when it does not come up."""

    def __init__(self, program: Path | None = None, arguments: tuple[str, ...] = (), log: Path | None = None):
        self._program = program
        self._arguments = arguments
        self._log = log
        self._process: subprocess.Popen[bytes] | None = None
        self.base_url = ""

    def __enter__(self) -> Self:
        program = self._program or daemon_program()
        self._folder = tempfile.TemporaryDirectory(prefix="raywalk-")
        folder = Path(self._folder.name)
        self._log = self._log or folder / "log"
        port_file = folder / "port"
        flags = ["--port", "0", "--port-file", str(port_file), "--state", str(folder / "state")]
        flags += ["--kernel-cache", str(kernel_cache_dir())]
        try:
            # A session of its own: Ctrl-C reaches this process, which then stops the daemon in good order.
            with self._log.open("wb") as log:
                self._process = subprocess.Popen(
                    [str(program), *flags, *self._arguments, "--die-with-parent"],
                    env=nvrtc.environment(dict(os.environ)),
                    stdin=subprocess.DEVNULL,
                    stdout=log,
                    stderr=subprocess.STDOUT,
                    start_new_session=True,
                )
            self._await_ready(port_file)
        except OSError as error:
            self.stop()
            raise RaywalkError(f"{program} could not be started: {error.strerror or error}") from error
        except BaseException:
            self.stop()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        self.stop()

    def stop(self) -> None:
        """Ends the daemon in good order, by force if that takes too long. Again does nothing."""
        if self._process is not None and self._process.poll() is None:
            self._process.terminate()
            try:
                self._process.wait(STOP_LIMIT_S)
            except subprocess.TimeoutExpired:
                self._process.kill()
                self._process.wait()
        self._process = None
        self._folder.cleanup()

    def check_alive(self) -> None:
        """Throws UnreachableError with the daemon's last words when it has ended; meant for lost connections."""
        if self._process is None:
            raise UnreachableError("the daemon that raywalk started was stopped")
        try:
            code = self._process.wait(END_LIMIT_S)
        except subprocess.TimeoutExpired:
            return
        how = f"signal {-code}" if code < 0 else f"exit code {code}"
        words = self.last_words()
        tail = f"; the end of its log:\n{words}" if words else ""
        raise UnreachableError(f"the daemon that raywalk started ended ({how}){tail}")

    def last_words(self) -> str:
        """The end of the daemon's log."""
        text = self._log.read_text(errors="replace") if self._log and self._log.is_file() else ""
        return "\n".join(text.strip().splitlines()[-LOG_LINES:])

    def _await_ready(self, port_file: Path) -> None:
        deadline = time.monotonic() + START_LIMIT_S
        while not (text := port_file.read_text().strip() if port_file.is_file() else ""):
            self._check_alive(deadline)
            time.sleep(0.02)
        self.base_url = f"http://127.0.0.1:{int(text)}"
        with Client(self.base_url, timeout=2.0, retries=0) as client:
            while True:
                try:
                    client.get_readyz()
                    return
                except RaywalkError:
                    self._check_alive(deadline)
                    time.sleep(0.05)

    def _check_alive(self, deadline: float) -> None:
        if self._process is None or (code := self._process.poll()) is not None:
            raise RaywalkError(f"raywalkd ended at its start with code {code}:\n{self.last_words()}")
        if time.monotonic() > deadline:
            raise RaywalkError(f"raywalkd was not ready after {START_LIMIT_S:.0f} s:\n{self.last_words()}")
