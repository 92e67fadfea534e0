"""Jobs of accuracy: from submission to result, refusals, cancelling, a restart."""

import csv
import io
from pathlib import Path
from typing import Any

from tests.api.conftest import Daemon, pointers, running_daemon

CLASSES = ["primary", "shadow", "diffuse", "random", "edge", "vertex"]
SMALL = {
    "scene": "soup",
    "hard_cases": False,
    "rays": 512,
    "quick": True,
    "techniques": [{"structure": "bvh", "traversal": "while-while"}, {"structure": "embree", "traversal": "intersect"}],
    "knob_sets": [{}, {"intersector": "moeller-trumbore"}, {"spawn": "none"}],
}
LONG = {**SMALL, "rays": 10_000_000, "quick": False, "classes": ["random"]}


def submit(daemon: Daemon, spec: dict[str, Any], status: int = 202) -> dict[str, Any]:
    return daemon.json("POST", "/v1/jobs", status, {"kind": "accuracy", "spec": spec})


def test_sweep_to_result(daemon: Daemon, soup: str) -> None:
    job = submit(daemon, SMALL)
    assert (job["kind"], job["spec"]["seed"], job["spec"]["classes"]) == ("accuracy", 1, CLASSES)
    done = daemon.finish(job)
    assert (done["state"], done["progress"], done["error"]) == ("succeeded", 1, None), done
    result = daemon.json("GET", f"/v1/results/{done['result']}", 200)
    assert (result["kind"], result["stop_reason"], result["cases"]) == ("accuracy", "completed", [])
    assert result["scene"]["triangles"] == 1000
    assert {row["class"] for row in result["rows"]} == set(CLASSES)
    for row in result["rows"]:
        check_row(row)
    of_class = {name: [row for row in result["rows"] if row["class"] == name] for name in CLASSES}
    # {} and moeller-trumbore of the BVH and {} of Embree; one more offset of the BVH where rays leave a surface
    assert [len(of_class[name]) for name in CLASSES] == [3, 4, 4, 3, 3, 3]
    assert {cost["structure"] for cost in result["invalid_costs"]} == {"bvh", "embree"}
    table = daemon.client.get(f"/v1/results/{done['result']}", headers={"Accept": "text/csv"})
    assert table.headers["content-type"] == "text/csv"
    assert len(list(csv.DictReader(io.StringIO(table.text)))) == len(result["rows"])


def check_row(row: dict[str, Any]) -> None:
    error = row["error"]
    assert row["mrays_per_s_ci95_low"] <= row["mrays_per_s"] <= row["mrays_per_s_ci95_high"]
    assert row["worst_over_median"] >= 1
    assert error["judged"] == row["rays"] > 0
    assert (error["self_hits"] is not None) == (row["class"] in ("shadow", "diffuse"))
    assert (error["double_hits"] is not None) == (row["class"] in ("edge", "vertex"))
    assert (row["steps_per_ray"] is None) == (row["structure"] == "embree" or row["class"] == "shadow")
    assert (error["brute_mismatches"] is None) == (row["structure"] == "embree")
    for name, rate in error.items():
        if isinstance(rate, dict) and "ppm" in rate:
            assert 0 <= rate["count"] <= rate["of"], name
            assert rate["ppm"] < rate["ppm_upper95"] <= 1e6, name
    if row["strict"]:
        for name in ("leaks", "false_misses", "false_hits", "wrong_ids", "nan_outputs", "brute_mismatches"):
            assert error[name]["count"] == 0, (row["class"], name)
        for name in ("double_hits", "self_hits"):
            assert error[name] is None or error[name]["count"] == 0, (row["class"], name)


def test_the_same_seed_gives_the_same_figures(daemon: Daemon, soup: str) -> None:
    spec = {**SMALL, "classes": ["edge"], "techniques": SMALL["techniques"][:1]}
    first, second = (daemon.finish(submit(daemon, {**spec, "seed": 7})) for _ in range(2))
    rows = [daemon.json("GET", f"/v1/results/{one['result']}", 200)["rows"] for one in (first, second)]
    assert [row["error"] for row in rows[0]] == [row["error"] for row in rows[1]]


def refused(daemon: Daemon, spec: dict[str, Any], status: int, code: str) -> set[str]:
    return pointers(daemon.problem("POST", "/v1/jobs", status, code, json={"kind": "accuracy", "spec": spec}))


def test_bad_requests_are_told_with_their_place(daemon: Daemon, soup: str) -> None:
    techniques = [{"structure": "bvh", "traversal": "sideways"}]
    assert refused(daemon, {"scene": "nowhere"}, 404, "unknown_scene") == {"/spec/scene"}
    place = {"/spec/techniques/0/traversal"}
    assert refused(daemon, {**SMALL, "techniques": techniques}, 404, "unknown_traversal") == place
    sets = [{}, {"intersector": "guess"}]
    assert refused(daemon, {**SMALL, "knob_sets": sets}, 422, "invalid_option") == {"/spec/knob_sets/1/intersector"}
    place = {"/spec/knob_sets/0/speed"}
    assert refused(daemon, {**SMALL, "knob_sets": [{"speed": 9}]}, 422, "unknown_option") == place
    assert refused(daemon, {"hard_cases": False}, 422, "nothing_to_do") == {"/spec/hard_cases"}
    assert refused(daemon, {**SMALL, "classes": ["side"]}, 422, "invalid_request") == {"/spec/classes/0"}
    assert refused(daemon, {**SMALL, "frames": 3}, 422, "invalid_request") == {"/spec/frames"}
    body = {"kind": "guess", "spec": SMALL}
    problem = daemon.problem("POST", "/v1/jobs", 422, "invalid_request", json=body)
    assert pointers(problem) == {"/kind"}
    assert "benchmark, accuracy" in problem["detail"]


def test_cancel(daemon: Daemon, soup: str) -> None:
    job = submit(daemon, LONG)
    daemon.wait(f"/v1/jobs/{job['id']}", lambda j: j["stage"].startswith("measuring"))
    daemon.json("POST", f"/v1/jobs/{job['id']}/cancel", 200)
    assert daemon.finish(job)["state"] == "cancelled"
    daemon.problem("GET", f"/v1/results/{job['id']}", 409, "no_result")


def test_jobs_of_accuracy_outlive_the_daemon(tmp_path: Path) -> None:
    with running_daemon(tmp_path) as first:
        first.load("soup", triangles=200)
        job = submit(first, {**SMALL, "classes": ["random"]})
        done = first.finish(job)
        result = first.json("GET", f"/v1/results/{done['result']}", 200)
    with running_daemon(tmp_path) as second:
        kept = second.json("GET", f"/v1/jobs/{job['id']}", 200)
        assert (kept["kind"], kept["spec"], kept["state"]) == ("accuracy", done["spec"], "succeeded")
        assert second.json("GET", f"/v1/results/{job['id']}", 200) == result
