"""Which techniques are measured when none are named, and how bare loops get their own job."""

import json

import httpx2
import pytest
from raywalk.cli.bench import measure
from raywalk.models import BenchmarkSpec, KindList
from raywalk.techniques import bare_loops, measured

from tests.client.test_client import JOB

BASELINE = {"name": "loop-8", "help": "h", "baseline": True}
KINDS = {
    "kinds": [
        {"name": "brute", "help": "h", "options": [], "traversals": [{"name": "linear", "help": "h"}]},
        {"name": "bvh", "help": "h", "options": [], "traversals": [{"name": "packet", "help": "h"}]},
        {"name": "embree", "help": "h", "options": [], "traversals": [{"name": "intersect", "help": "h"}, BASELINE]},
    ]
}


def test_defaults() -> None:
    kinds = KindList.model_validate(KINDS).kinds
    assert [(one.structure, one.traversal) for one in measured(kinds)] == [("bvh", "packet"), ("embree", "intersect")]
    assert [(one.structure, one.traversal) for one in bare_loops(kinds)] == [("embree", "loop-8")]


@pytest.mark.parametrize(
    ("spec", "traversals"),
    [
        ({"modes": ["trace", "primary"]}, ["packet", "intersect", "loop-8"]),
        ({"modes": ["primary"]}, ["packet", "intersect"]),
        ({"modes": ["trace"], "techniques": [("embree", "loop-8"), ("bvh", "packet")]}, ["loop-8", "packet"]),
        ({"modes": ["primary"], "techniques": [("brute", "linear")]}, ["linear"]),
    ],
)
def test_one_job_measures_all_in_turns(client, daemon, result, spec, traversals) -> None:
    daemon.on("GET", "/v1/kinds", KINDS)
    daemon.on("POST", "/v1/jobs", JOB)
    ended = json.dumps(JOB | {"state": "succeeded", "result": "r1"})
    headers = {"Content-Type": "text/event-stream"}
    stream = f"event: job\ndata: {ended}\n\n"
    daemon.on("GET", "/v1/jobs/j1/events", lambda _: httpx2.Response(200, content=stream, headers=headers))
    daemon.on("GET", "/v1/results/r1", result.model_dump(mode="json"))
    if "techniques" in spec:
        spec = spec | {"techniques": [{"structure": s, "traversal": t} for s, t in spec["techniques"]]}
    got = measure(client, BenchmarkSpec.model_validate({"scene": "bunny"} | spec), lambda _: None)
    sent = [json.loads(one.content)["spec"] for one in daemon.requests if one.url.path == "/v1/jobs"]
    assert [[one["traversal"] for one in job["techniques"]] for job in sent] == [traversals]
    assert got.rows == result.rows
