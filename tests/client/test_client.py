"""Every method of the client against a daemon made of answers."""

import httpx2
import numpy as np
import pytest
import raywalk
from raywalk import models
from raywalk.client import Client
from raywalk.errors import RaywalkError
from raywalk.payload import HIT, MISS, pack_rays, server_timing

from tests.client.conftest import JOB

SCENE = {"name": "bunny", "title": "Bunny", "triangles": 3, "lights": 1, "fidelity": "original"}
SCENE |= {"loaded": True, "warnings": []}
STRUCTURE = {"id": "s1", "scene": "bunny", "kind": "bvh", "options": {}, "state": "ready"}
MACHINE = {"fingerprint": "f", "hostname": "h", "os": "o", "kernel": "k", "cpu": "c", "cores": 2, "threads": 2}
MACHINE |= {"memory_bytes": 1, "governor": "g", "device": "d", "compiler": "c", "build_type": "Release"}
MACHINE |= {"build_flags": "", "version": "0", "git_commit": "unknown", "libraries": {}}
LIMITS = dict.fromkeys(models.Limits.model_fields, 1)
MEMORY = {"total_bytes": 0, "free_bytes": 0, "resident_bytes": 0}
DEVICE = {"name": "d", "kind": "cpu", "requested": "auto", "no_cuda": None, "details": {}, "memory": MEMORY}
SYSTEM = {"machine": MACHINE, "device": DEVICE, "limits": LIMITS}
SYSTEM |= {"resident": {"scenes": 0, "structures": 0, "bytes": 0}, "uptime_s": 1.5, "warnings": []}


def test_public_exports() -> None:
    expected = ["Client", "Frame", "LocalDaemon", "ProblemError", "RayHits", "RaywalkError", "UnreachableError"]
    assert sorted(raywalk.__all__) == [*expected, "pack_rays"]
    assert all(hasattr(raywalk, name) for name in raywalk.__all__)


@pytest.mark.parametrize(
    ("call", "method", "path", "answer", "check"),
    [
        (lambda c: c.get_livez(), "GET", "/livez", "ok", lambda got: got == "ok"),
        (lambda c: c.get_readyz(), "GET", "/readyz", "ok", lambda got: got == "ok"),
        (lambda c: c.get_metrics(), "GET", "/metrics", "a 1\n", lambda got: got == "a 1\n"),
        (lambda c: c.get_openapi(), "GET", "/v1/openapi.json", {"openapi": "3.1.0"}, lambda got: "openapi" in got),
        (lambda c: c.get_system(), "GET", "/v1/system", SYSTEM, lambda got: got.device.kind == "cpu"),
        (lambda c: c.get_kinds(), "GET", "/v1/kinds", {"kinds": []}, lambda got: got == []),
        (lambda c: c.list_scenes(), "GET", "/v1/scenes", {"scenes": [SCENE]}, lambda got: got[0].name == "bunny"),
        (lambda c: c.load_scene("bunny"), "POST", "/v1/scenes", SCENE, lambda got: got.loaded),
        (lambda c: c.get_scene("bunny"), "GET", "/v1/scenes/bunny", SCENE, lambda got: got.lights == 1),
        (lambda c: c.upload_scene("mine", b"ply"), "PUT", "/v1/scenes/mine", SCENE, lambda got: got.triangles == 3),
        (lambda c: c.delete_scene("mine"), "DELETE", "/v1/scenes/mine", httpx2.Response(204), lambda got: got is None),
        (lambda c: c.list_structures(), "GET", "/v1/structures", {"structures": []}, lambda got: got == []),
        (lambda c: c.build_structure("bunny", "bvh"), "POST", "/v1/structures", STRUCTURE, lambda got: got.id == "s1"),
        (lambda c: c.get_structure("s1"), "GET", "/v1/structures/s1", STRUCTURE, lambda got: got.state == "ready"),
        (lambda c: c.delete_structure("s1"), "DELETE", "/v1/structures/s1", httpx2.Response(204), lambda _: True),
        (lambda c: c.list_jobs(), "GET", "/v1/jobs", {"jobs": [JOB]}, lambda got: got[0].stage == "measuring"),
        (lambda c: c.get_job("j1"), "GET", "/v1/jobs/j1", JOB, lambda got: got.progress == 0.5),
        (lambda c: c.cancel_job("j1"), "POST", "/v1/jobs/j1/cancel", JOB, lambda got: got.id == "j1"),
        (lambda c: c.get_result_csv("j1"), "GET", "/v1/results/j1", "a,b\n", lambda got: got == "a,b\n"),
    ],
)
def test_method(client, daemon, call, method, path, answer, check) -> None:
    daemon.on(method, path, answer)
    assert check(call(client))
    assert len(daemon.requests) == 1


def test_names_stay_one_segment(client, daemon) -> None:
    with pytest.raises(raywalk.ProblemError):
        client.get_scene("../jobs?x")
    assert daemon.requests[0].url.raw_path == b"/v1/scenes/..%2Fjobs%3Fx"


def test_absent_fields_are_left_to_the_daemon(client, daemon) -> None:
    daemon.on("POST", "/v1/scenes", SCENE)
    client.load_scene("bunny")
    assert daemon.sent() == {"name": "bunny"}
    daemon.on("POST", "/v1/structures", STRUCTURE)
    client.build_structure("bunny", "bvh", {"bins": 8})
    assert daemon.sent() == {"scene": "bunny", "kind": "bvh", "options": {"bins": 8}}


def test_cameras(client, daemon) -> None:
    daemon.on("GET", "/v1/scenes/bunny/cameras", {"cameras": [{"eye": [0, 0, 1], "target": [0, 0, 0]}]})
    assert len(client.list_cameras("bunny", 1)) == 1
    assert daemon.requests[0].url.params["frames"] == "1"


def test_frame(client, daemon) -> None:
    pixels = np.arange(24, dtype="<f4")
    headers = {
        "Content-Type": "application/octet-stream",
        "ETag": '"e"',
        "Server-Timing": "queue;dur=0.1, trace;dur=2.5",
    }
    daemon.on("POST", "/v1/frames", httpx2.Response(200, content=pixels.tobytes(), headers=headers))
    request = models.FrameRequest(scene="bunny", structure="bvh", traversal="packet", width=4, height=2)
    frame = client.render_frame(request, "application/octet-stream")
    assert daemon.requests[0].headers["Accept"] == "application/octet-stream"
    assert frame.timing_ms == {"queue": 0.1, "trace": 2.5}
    assert frame.etag == '"e"'
    assert frame.array().shape == (2, 4, 3)
    assert frame.array()[1, 3, 2] == 23


def test_packed_rays_are_finite() -> None:
    rays = np.frombuffer(pack_rays([(0, 0, 1)], (0, 0, -1)), "<f4")
    assert np.isfinite(rays).all()
    assert rays[7] == np.finfo(np.float32).max


def test_frame_of_the_wrong_length(client, daemon) -> None:
    headers = {"Content-Type": "application/octet-stream"}
    daemon.on("POST", "/v1/frames", httpx2.Response(200, content=b"1234", headers=headers))
    request = models.FrameRequest(scene="bunny", structure="bvh", traversal="packet", width=4, height=2)
    with pytest.raises(RaywalkError, match="no raw frame"):
        client.render_frame(request).array()


def test_rays(client, daemon) -> None:
    hits = np.array([(1.5, 7, 0.25, 0.5), (np.inf, MISS, 0, 0)], HIT)
    daemon.on("POST", "/v1/rays", httpx2.Response(200, content=hits.tobytes(), headers={"X-Invalid-Rays": "1"}))
    rays = pack_rays([(0, 0, 1), (0, 0, 2)], (0, 0, -1), tmax=[1, 2])
    answer = client.trace_rays("bunny", "bvh", "packet", rays)
    assert answer.invalid == 1
    assert answer.hits["id"].tolist() == [7, MISS]
    sent = np.frombuffer(daemon.requests[0].content, "<f4").reshape(2, 8)
    assert sent[1].tolist() == [0, 0, 2, 0, 0, 0, -1, 2]
    assert daemon.requests[0].url.params["query"] == "closest"


def test_occlusion(client, daemon) -> None:
    daemon.on("POST", "/v1/rays", b"\x01\x00")
    answer = client.trace_rays("bunny", "bvh", "packet", np.zeros((2, 8)), query="any")
    assert answer.hits.tolist() == [True, False]


@pytest.mark.parametrize("rays", [b"123", np.zeros((2, 6)), np.zeros(8)])
def test_misshapen_rays(client, daemon, rays) -> None:
    with pytest.raises(RaywalkError):
        client.trace_rays("bunny", "bvh", "packet", rays)
    assert daemon.requests == []


def test_submit_job_sends_one_key(client, daemon) -> None:
    daemon.on("POST", "/v1/jobs", httpx2.ReadError("lost"), JOB)
    assert client.submit_job(models.BenchmarkSpec(scene="bunny")).id == "j1"
    assert len({request.headers["Idempotency-Key"] for request in daemon.requests}) == 1
    assert daemon.sent() == {"kind": "benchmark", "spec": {"scene": "bunny"}}


def test_result(client, daemon, result) -> None:
    daemon.on("GET", "/v1/results/j1", result.model_dump(mode="json"))
    assert client.get_result("j1") == result


def test_job_events(client, daemon) -> None:
    body = "".join(
        f"event: job\ndata: {models.Job.model_validate(JOB | more).model_dump_json()}\n\n" for more in EVENTS
    )
    stream = httpx2.Response(200, content=": ping\n\n" + body, headers={"Content-Type": "text/event-stream"})
    daemon.on("GET", "/v1/jobs/j1/events", stream)
    assert [job.state for job in client.stream_job_events("j1")] == ["running", "succeeded"]


EVENTS = [{"state": "running"}, {"state": "succeeded", "progress": 1.0, "result": "j1"}]


def test_an_answer_that_breaks_the_contract(client, daemon) -> None:
    daemon.on("GET", "/v1/scenes/bunny", SCENE | {"lights": "many"})
    with pytest.raises(RaywalkError, match="no Scene: /lights"):
        client.get_scene("bunny")


@pytest.mark.parametrize("url", ["daemon:80", "ftp://daemon", "http://", "nonsense"])
def test_bad_address(url) -> None:
    with pytest.raises(RaywalkError, match="no address of a daemon"):
        Client(url)


def test_server_timing() -> None:
    assert server_timing("queue;dur=0.5, trace;desc=x;dur=1e1,encode;dur=2") == {"queue": 0.5, "trace": 10, "encode": 2}
    assert server_timing("") == {}
