"""Benchmark jobs: from submission to result, cancelling, events."""

import csv
import io
import time

import pytest

from tests.api.conftest import Daemon, events_of, pointers

SMALL = {"scene": "soup", "width": 64, "height": 64, "frames": 6, "warmup": 1, "error_frames": 2}
LONG = {
    **SMALL,
    "frames": 100_000,
    "modes": ["primary"],
    "techniques": [{"structure": "bvh", "traversal": "while-while"}],
}


def test_job_to_result(daemon: Daemon, soup: str) -> None:
    job = daemon.submit({**SMALL, "repeats": 3, "modes": ["trace", "primary", "shadow", "whitted"]})
    assert (job["spec"]["time_limit_s"], job["spec"]["batch"]) == (3600, 16)
    names = {f"{t['structure']}/{t['traversal']}" for t in job["spec"]["techniques"]}
    assert {"grid/dda", "bvh/packet", "embree/intersect"} <= names
    assert not any(name.startswith("brute/") for name in names)
    done = daemon.finish(job)
    assert (done["state"], done["progress"], done["error"]) == ("succeeded", 1, None), done
    result = daemon.json("GET", f"/v1/results/{done['result']}", 200)
    assert (result["stop_reason"], result["telemetry"]) == ("completed", None)
    assert result["machine"]["device"] == result["machine"]["cpu"]
    assert result["scene"]["triangles"] == 1000
    assert len(result["rows"]) == 4 * len(names)
    for row in result["rows"]:
        name = f"{row['structure']}/{row['traversal']}"
        expected = "bvh/while-while" if row["structure"] == "embree" else "embree/intersect"
        assert row["error"]["reference"].split()[0] == expected, name
        assert row["error"]["pixels"] == 2 * 64 * 64
        assert row["error"]["id_mismatch_ppm"] < 1000, name
        assert row["error"]["image_rmse"] < 0.05, name
        check_image_figures(row["mode"], row["error"])
        times = row["frame_ms"]
        assert times["min"] <= times["median"] <= times["p95"] <= times["p99"]
        assert times["ci95_low"] <= times["median"] <= times["ci95_high"]
        assert times["samples"] == 18
        assert (row["kernel"], row["throughput"]) == (None, None)  # the CPU takes one frame at a time
        assert len(row["frame_times_ms"]) == 6
        assert (row["steps_per_ray"] is None) == (row["structure"] == "embree")
        if row["mode"] in ("trace", "primary"):
            assert row["rays_per_frame"] == 64 * 64
        else:
            assert row["rays_per_frame"] > 64 * 64
        assert row["mrays_per_s"] == pytest.approx(row["rays_per_frame"] / times["mean"] / 1e3)
    table = daemon.client.get(f"/v1/results/{done['result']}", headers={"Accept": "text/csv"})
    assert table.headers["content-type"] == "text/csv"
    assert len(list(csv.DictReader(io.StringIO(table.text)))) == len(result["rows"])


def check_image_figures(mode: str, error: dict) -> None:
    names = ("image_ssim", "image_flip_mean", "image_flip_p99", "image_flip_max", "changed_pixels_ppm")
    ssim, mean, p99, most, changed = (error[name] for name in names)
    if mode == "trace":
        assert (ssim, mean, p99, most, changed) == (None,) * 5
        return
    assert 0.95 < ssim <= 1
    assert 0 <= mean <= most <= 1
    assert p99 <= most
    assert most > 0 or changed == 0
    if error["image_rmse"] == 0:
        assert (ssim, mean, p99, most, changed) == (1, 0, 0, 0, 0)


def test_kernel_options_are_checked_when_the_job_is_submitted(daemon: Daemon, soup: str) -> None:
    techniques = [{"structure": "bvh", "traversal": "packet", "kernel": kernel} for kernel in ({}, {"registers": 40})]
    body = {"kind": "benchmark", "spec": {**SMALL, "techniques": techniques}}
    problem = daemon.problem("POST", "/v1/jobs", 422, "unknown_option", json=body)
    assert pointers(problem) == {"/spec/techniques/1/kernel/registers"}
    assert "bvh/packet" in problem["detail"]


def test_idempotency_key(daemon: Daemon, soup: str) -> None:
    spec = {**SMALL, "modes": ["trace"], "techniques": [{"structure": "bvh", "traversal": "packet"}]}
    first = daemon.submit(spec, **{"Idempotency-Key": "once"})
    again = daemon.submit(spec, 200, **{"Idempotency-Key": "once"})
    assert again["id"] == first["id"]
    assert daemon.finish(first)["state"] == "succeeded"
    body = {"kind": "benchmark", "spec": {**spec, "frames": 5}}
    headers = {"Idempotency-Key": "once"}
    daemon.problem("POST", "/v1/jobs", 409, "idempotency_key_reused", json=body, headers=headers)


def test_stages_are_announced(daemon: Daemon, soup: str) -> None:
    techniques = [{"structure": "kdtree", "traversal": "short-stack-3", "options": {"traversal_cost": 7}}]
    job = daemon.submit({**SMALL, "warmup": 30, "modes": ["primary"], "techniques": techniques})
    with daemon.client.stream("GET", f"/v1/jobs/{job['id']}/events") as stream:
        jobs = [job for _, job in events_of(stream.iter_lines())]
    assert jobs[-1]["state"] == "succeeded"
    stages = [job["stage"] for job in jobs]
    # The stream tells the newest state alone, so a stage of no duration may be skipped; their order is fixed.
    order = ["starting", "loading", "building", "waiting", "warming", "measuring", "comparing", "done"]
    places = [order.index(stage.split()[0]) for stage in stages if stage != "waiting"]
    assert places == sorted(places), stages


def test_cancel_in_the_warm_up(daemon: Daemon, soup: str) -> None:
    spec = {**LONG, "warmup": 1000, "width": 1024, "height": 1024}
    job = daemon.submit(spec)
    path = f"/v1/jobs/{job['id']}"
    assert daemon.problem("GET", f"/v1/results/{job['id']}", 409, "no_result")["retryable"]
    warm = daemon.wait(path, lambda j: j["frames_done"] > 2)
    assert warm["stage"] == "warming up bvh/while-while"
    assert warm["progress"] > 0
    daemon.json("POST", f"{path}/cancel", 200)
    ended = daemon.finish(job)
    assert (ended["state"], ended["frames_done"] < 1000) == ("cancelled", True)
    assert not daemon.problem("GET", f"/v1/results/{job['id']}", 409, "no_result")["retryable"]


def test_time_limit(daemon: Daemon, soup: str) -> None:
    done = daemon.finish(daemon.submit({**LONG, "time_limit_s": 1}))
    result = daemon.json("GET", f"/v1/results/{done['result']}", 200)
    assert result["stop_reason"] == "time_limit"
    assert 0 < len(result["rows"][0]["frame_times_ms"]) < 100_000


def test_cancel_running_and_queued(daemon: Daemon, soup: str) -> None:
    running, queued = daemon.submit(LONG), daemon.submit(LONG)
    assert queued["position"] == 1
    daemon.wait(f"/v1/jobs/{running['id']}", lambda j: j["frames_done"] > 0)
    busy = daemon.json("GET", f"/v1/jobs/{running['id']}", 200)
    assert busy["state"] == "running"
    assert busy["eta_s"] > 0
    assert daemon.json("POST", f"/v1/jobs/{queued['id']}/cancel", 200)["state"] == "cancelled"
    begin = time.monotonic()
    daemon.json("POST", f"/v1/jobs/{running['id']}/cancel", 200)
    assert daemon.finish(running)["state"] == "cancelled"
    assert time.monotonic() - begin < 1.0
    daemon.problem("GET", f"/v1/results/{running['id']}", 409, "no_result")
    assert daemon.json("POST", f"/v1/jobs/{running['id']}/cancel", 200)["state"] == "cancelled"
    assert [job["id"] for job in daemon.json("GET", "/v1/jobs", 200)["jobs"]][:2] == [queued["id"], running["id"]]


def test_events(daemon: Daemon, soup: str) -> None:
    job = daemon.submit({**LONG, "frames": 2000, "modes": ["trace"]})
    path = f"/v1/jobs/{job['id']}/events"
    with daemon.client.stream("GET", path) as stream:
        assert stream.headers["content-type"] == "text/event-stream"
        events = list(events_of(stream.iter_lines()))
    assert events[-1][1]["state"] == "succeeded"
    numbers = [number for number, _ in events]
    assert numbers == sorted(set(numbers))
    progress = [job["progress"] for _, job in events]
    assert progress == sorted(progress)
    assert len(progress) >= 3
    with daemon.client.stream("GET", path, headers={"Last-Event-ID": str(numbers[-1])}) as stream:
        assert [job["state"] for _, job in events_of(stream.iter_lines())] == ["succeeded"]


@pytest.mark.parametrize(
    ("change", "status", "code", "where"),
    [
        ({"scene": "nowhere"}, 404, "unknown_scene", {"/spec/scene"}),
        ({"frames": 0}, 422, "invalid_request", {"/spec/frames"}),
        ({"modes": []}, 422, "invalid_request", {"/spec/modes"}),
        ({"modes": ["fast"]}, 422, "invalid_request", {"/spec/modes/0"}),
        ({"techniques": [{"structure": "bvh"}]}, 422, "invalid_request", {"/spec/techniques/0"}),
        ({"techniques": [{"structure": "octree", "traversal": "x"}]}, 404, "unknown_kind",
         {"/spec/techniques/0/structure"}),
        ({"techniques": [{"structure": "bvh", "traversal": "x"}]}, 404, "unknown_traversal",
         {"/spec/techniques/0/traversal"}),
        ({"techniques": [{"structure": "bvh", "traversal": "packet", "options": {"x": 1}}]}, 422, "unknown_option",
         {"/spec/techniques/0/options/x"}),
    ],
)  # fmt: skip
def test_bad_specs(daemon: Daemon, soup: str, change: dict, status: int, code: str, where: set[str]) -> None:
    body = {"kind": "benchmark", "spec": {**SMALL, **change}}
    assert pointers(daemon.problem("POST", "/v1/jobs", status, code, json=body)) == where


def test_baselines_trace_only(daemon: Daemon, soup: str) -> None:
    kinds = daemon.json("GET", "/v1/kinds", 200)["kinds"]
    name = next(t["name"] for k in kinds if k["name"] == "embree" for t in k["traversals"] if t["baseline"])
    spec = {**SMALL, "techniques": [{"structure": "embree", "traversal": name}]}
    body = {"kind": "benchmark", "spec": spec}
    daemon.problem("POST", "/v1/jobs", 422, "baseline_only_traces", json=body)
    assert daemon.finish(daemon.submit({**spec, "modes": ["trace"]}))["state"] == "succeeded"
    assert daemon.frame("soup", "embree", name).status_code == 422


def test_unknown_job(daemon: Daemon) -> None:
    for method, path in (("GET", ""), ("POST", "/cancel"), ("GET", "/events")):
        daemon.problem(method, f"/v1/jobs/nothing{path}", 404, "unknown_job")
    daemon.problem("GET", "/v1/results/nothing", 404, "unknown_job")


def test_frames_wait_while_a_benchmark_measures(daemon: Daemon, soup: str) -> None:
    job = daemon.submit({**LONG, "time_limit_s": 2})
    daemon.wait(f"/v1/jobs/{job['id']}", lambda j: j["frames_done"] > 0)
    begin = time.monotonic()
    answer = daemon.frame(soup, "bvh", "while-while")
    assert answer.status_code == 200
    assert time.monotonic() - begin > 0.5
    assert daemon.finish(job)["state"] == "succeeded"
