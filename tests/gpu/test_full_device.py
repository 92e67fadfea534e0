"""A device whose memory is too small: typed errors with both figures, and the daemon goes on."""

from pathlib import Path

import pytest

from tests.api.test_restart import supervised

MIB = 1 << 20


def test_builds_and_frames_that_do_not_fit(tmp_path: Path, fake_driver: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RAYWALK_LIBCUDA", str(fake_driver))
    with supervised(tmp_path, "--device", "cuda", "--device-memory-mib", "2") as daemon:
        daemon.load("soup", triangles=100_000)
        failed = daemon.build("soup", "bvh")
        assert failed["state"] == "failed"
        assert failed["needed_bytes"] > 2 * MIB >= failed["free_bytes"], failed

        refused = daemon.frame("soup", "bvh", "while-while")
        assert refused.status_code == 503
        problem = refused.json()
        assert (problem["code"], problem["retryable"]) == ("out_of_device_memory", False)
        assert (problem["needed_bytes"], problem["free_bytes"]) == (failed["needed_bytes"], failed["free_bytes"])

        daemon.load("soup", triangles=1000)
        assert daemon.build("soup", "bvh")["state"] == "ready"
        assert daemon.frame("soup", "bvh", "while-while").status_code == 200
        too_large = daemon.frame("soup", "bvh", "while-while", width=1024, height=1024)
        assert too_large.json()["code"] == "out_of_device_memory"
        assert too_large.json()["needed_bytes"] > 12 * MIB
        assert daemon.frame("soup", "bvh", "while-while").status_code == 200, "it goes on"
        memory = daemon.json("GET", "/v1/system", 200)["device"]["memory"]
        assert 0 < memory["resident_bytes"] <= 2 * MIB
