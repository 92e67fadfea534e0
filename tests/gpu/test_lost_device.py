"""A GPU that fails in mid-job: the job fails with its cause, the daemon starts again, results stay as they are.

On the fake driver always, on a real one where there is one: there the daemon launches a kernel that traps."""

import ctypes
import os
import signal
import time
from pathlib import Path

import httpx2
import pytest

from tests.api.conftest import START_LIMIT_S, Daemon
from tests.api.test_restart import RESTART_LIMIT_S, child_of, result_bytes, supervised

SPEC = {"scene": "soup", "width": 32, "height": 32, "frames": 2, "warmup": 0, "error_frames": 1, "batch": 0}
SPEC |= {"modes": ["primary"], "techniques": [{"structure": "bvh", "traversal": "while-while"}]}
FAILING_LAUNCH = 200  # later than the small jobs of one daemon reach


@pytest.fixture(params=["fake driver", "real driver"])
def fault(request: pytest.FixtureRequest, fake_driver: Path, monkeypatch: pytest.MonkeyPatch) -> tuple[str, ...]:
    """Flags of a daemon whose GPU fails at launch FAILING_LAUNCH."""
    if request.param == "fake driver":
        monkeypatch.setenv("RAYWALK_LIBCUDA", str(fake_driver))
        monkeypatch.setenv("FAKE_CUDA_FAIL_LAUNCH", str(FAILING_LAUNCH))
        return ("--device", "cuda")
    try:
        ctypes.CDLL("libcuda.so.1")
    except OSError as error:
        pytest.skip(f"no NVIDIA driver: {error}")
    return ("--device", "cuda", "--fault-after", str(FAILING_LAUNCH))


def wait_until_restarted(daemon: Daemon, job: str) -> dict:
    """The job once a new daemon tells its end; connections fail meanwhile."""
    end = time.monotonic() + RESTART_LIMIT_S
    while time.monotonic() < end:
        try:
            if daemon.client.get("/readyz").status_code == 200:
                state = daemon.json("GET", f"/v1/jobs/{job}", 200)
                if state["state"] in ("failed", "succeeded"):
                    return state
        except httpx2.TransportError:
            pass
        time.sleep(0.05)
    pytest.fail("the daemon did not come back with the job's end")


def test_a_fault_in_mid_job(tmp_path: Path, fault: tuple[str, ...]) -> None:
    with supervised(tmp_path, *fault) as daemon:
        assert daemon.json("GET", "/v1/system", 200)["device"]["kind"] == "cuda"
        daemon.load("soup", triangles=1000)
        before = daemon.finish(daemon.submit(SPEC))
        assert before["state"] == "succeeded", before
        kept = result_bytes(daemon, before["id"])

        failing = daemon.submit({**SPEC, "frames": 100_000})
        failed = wait_until_restarted(daemon, failing["id"])
        assert (failed["state"], failed["error"]["code"]) == ("failed", "device_lost"), failed
        assert "CUDA_ERROR" in failed["error"]["detail"]

        assert result_bytes(daemon, before["id"]) == kept
        after = daemon.finish(daemon.submit(SPEC))
        assert after["state"] == "succeeded", after

        daemon.process.terminate()
        _, errors = daemon.process.communicate(timeout=START_LIMIT_S)
        assert daemon.process.returncode == 0, errors
        assert "exit code 5" in errors, errors


def test_a_gpu_that_is_gone_is_not_replaced_by_the_cpu(
    tmp_path: Path, fake_driver: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Jobs that waited for the GPU would be measured on something else."""
    driver = tmp_path / "libcuda.so"
    driver.symlink_to(fake_driver)
    monkeypatch.setenv("RAYWALK_LIBCUDA", str(driver))
    with supervised(tmp_path / "state", "--device", "auto") as daemon:
        assert daemon.json("GET", "/v1/system", 200)["device"]["kind"] == "cuda"
        driver.unlink()
        child = child_of(daemon.process)
        assert child is not None
        os.kill(child, signal.SIGKILL)
        _, errors = daemon.process.communicate(timeout=RESTART_LIMIT_S)
        assert daemon.process.returncode == 3, errors
        assert "used a GPU; --device cpu goes on without it" in errors, errors
    with supervised(tmp_path / "state", "--device", "cpu") as daemon:
        assert daemon.json("GET", "/v1/system", 200)["device"]["kind"] == "cpu"
