"""Health, machine, kinds, metrics, and what HTTP itself answers."""

import http.client
import json
import re
import socket

import pytest

from tests.api.conftest import Daemon, check_problem


def test_health(daemon: Daemon) -> None:
    for path in ("/livez", "/readyz"):
        answer = daemon.client.get(path)
        assert (answer.status_code, answer.headers["content-type"]) == (200, "text/plain")


def test_machine_record(daemon: Daemon) -> None:
    system = daemon.json("GET", "/v1/system", 200)
    machine = system["machine"]
    assert machine["cores"] >= machine["threads"] >= 1
    assert machine["memory_bytes"] > 1 << 28
    assert re.fullmatch(r"[0-9a-f]{16}", machine["fingerprint"])
    assert "-ffp-contract=off" in machine["build_flags"]
    assert machine["libraries"]["embree"]
    assert system["limits"]["json_bytes"] == 1 << 20
    assert system["device"] == {
        "name": machine["device"],
        "kind": "cpu",
        "requested": "cpu",
        "no_cuda": None,
        "details": {},
        "memory": {"total_bytes": 0, "free_bytes": 0, "resident_bytes": 0},
    }
    assert system["warnings"] == []


def test_kinds_name_the_required_techniques(daemon: Daemon) -> None:
    kinds = daemon.json("GET", "/v1/kinds", 200)["kinds"]
    names = {f"{kind['name']}/{t['name']}" for kind in kinds for t in kind["traversals"]}
    required = {"grid/dda", "kdtree/short-stack-3", "kdtree/short-stack-2", "bvh/packet", "bvh/while-while"}
    assert required | {"embree/intersect"} <= names
    options = [option for kind in kinds for holder in (kind, *kind["traversals"]) for option in holder["options"]]
    for option in options:
        assert option["help"]
        if "choices" in option:
            assert option["default"] in option["choices"]
        else:
            assert option["minimum"] <= option["default"] <= option["maximum"]


def test_kinds_list_the_knobs_with_their_meaning(daemon: Daemon) -> None:
    kinds = daemon.json("GET", "/v1/kinds", 200)["kinds"]
    knobs = {f"{kind['name']}/{t['name']}": t["options"] for kind in kinds for t in kind["traversals"]}
    names = {technique: [option["name"] for option in options] for technique, options in knobs.items()}
    assert names["bvh/while-while"] == names["bvh/packet"] == ["intersector", "slab", "spawn"]
    assert names["grid/dda"] == ["intersector", "spawn"]
    assert names["kdtree/short-stack-2"] == ["intersector", "stack_entries", "spawn"]
    assert names["embree/intersect"] == []  # an engine of its own
    for option in knobs["bvh/while-while"]:
        assert option["default"] == option["choices"][0]  # the strict one
        assert all(f"{choice}: " in option["help"] for choice in option["choices"])


def test_contract_is_served(daemon: Daemon) -> None:
    document = daemon.json("GET", "/v1/openapi.json", 200)
    assert document["openapi"].startswith("3.1")
    assert "/v1/frames" in document["paths"]


def test_metrics_count_requests(daemon: Daemon) -> None:
    series = re.compile(r'raywalk_requests_total\{method="GET",route="/v1/kinds",status="200"\} (\d+)')
    daemon.json("GET", "/v1/kinds", 200)
    before = int(series.search(daemon.client.get("/metrics").text).group(1))
    daemon.json("GET", "/v1/kinds", 200)
    assert int(series.search(daemon.client.get("/metrics").text).group(1)) == before + 1


def test_metrics_tell_device_memory(daemon: Daemon) -> None:
    assert 'raywalk_device_memory_bytes{what="free"} 0' in daemon.client.get("/metrics").text


def test_unknown_path_and_method(daemon: Daemon) -> None:
    daemon.problem("GET", "/v1/nothing", 404, "not_found")
    answer = daemon.client.delete("/v1/system")
    check_problem(answer, 405, "method_not_allowed")
    assert answer.headers["allow"] == "GET, HEAD"


def test_head_has_no_body(daemon: Daemon) -> None:
    answer = daemon.client.head("/v1/kinds")
    assert (answer.status_code, answer.content) == (200, b"")


@pytest.mark.parametrize("host", ["example.com", "example.com:80", "127.0.0.1.example.com", "127.0.0.1:x"])
def test_foreign_hosts_are_refused(daemon: Daemon, host: str) -> None:
    daemon.problem("GET", "/livez", 403, "foreign_host", headers={"Host": host})


@pytest.mark.parametrize("origin", ["null", "http://example.com", "file://", "http://localhost.example.com"])
def test_foreign_origins_are_refused(daemon: Daemon, origin: str) -> None:
    daemon.problem("GET", "/livez", 403, "foreign_origin", headers={"Origin": origin})


def test_own_origin_is_allowed(daemon: Daemon) -> None:
    for origin in (f"http://127.0.0.1:{daemon.port}", "http://localhost:5173"):
        assert daemon.client.get("/livez", headers={"Origin": origin}).status_code == 200


def test_request_ids_differ(daemon: Daemon) -> None:
    ids = {daemon.client.get("/livez").headers["x-request-id"] for _ in range(5)}
    assert len(ids) == 5


@pytest.mark.parametrize(
    "raw",
    [
        b"GET /livez HTTP/9.9\r\n\r\n",
        b"nonsense\r\n\r\n",
        b"GET /livez HTTP/1.1\r\nHost: 127.0.0.1\r\nno colon here\r\n\r\n",
        b"GET /" + b"a" * 9000 + b" HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
        b"GET /%0d%0aforged HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
    ],
)
def test_unreadable_requests_disturb_nothing(daemon: Daemon, raw: bytes) -> None:
    with socket.create_connection(("127.0.0.1", daemon.port), timeout=10) as connection:
        connection.sendall(raw)
        answer = connection.recv(4096)
    assert re.match(rb"HTTP/1.1 4\d\d ", answer), answer
    assert daemon.client.get("/livez").status_code == 200


@pytest.mark.parametrize("target", ["GET /livez", "PUT /v1/scenes/x", "POST /v1/frames"])
def test_hopelessly_large_bodies_are_refused_unsent(daemon: Daemon, target: str) -> None:
    for length in (536_870_913, 1 << 62, 10**30):
        connection = http.client.HTTPConnection("127.0.0.1", daemon.port, timeout=20)
        method, path = target.split()
        connection.putrequest(method, path)
        for name, value in (("Expect", "100-continue"), ("Content-Length", str(length))):
            connection.putheader(name, value)
        connection.endheaders()
        answer = connection.getresponse()
        assert (answer.status, answer.headers["Content-Type"]) == (413, "application/problem+json")
        assert json.loads(answer.read())["code"] == "body_too_large"
        connection.close()
    assert daemon.client.get("/livez").status_code == 200


def test_a_chunked_upload_ends_at_its_limit(daemon: Daemon) -> None:
    """A byte more than the limit; no length says so beforehand."""
    limit = daemon.json("GET", "/v1/system", 200)["limits"]["upload_bytes"]
    piece = bytes(1 << 20)
    connection = http.client.HTTPConnection("127.0.0.1", daemon.port, timeout=60)
    headers = {"Content-Type": "application/octet-stream"}
    pieces = [piece] * (limit // len(piece)) + [b"x"]
    connection.request("PUT", "/v1/scenes/endless", iter(pieces), headers, encode_chunked=True)
    answer = connection.getresponse()
    assert (answer.status, json.loads(answer.read())["code"]) == (413, "body_too_large")


@pytest.mark.parametrize("path", ["/v1/frames", "/v1/jobs", "/v1/scenes", "/v1/structures"])
@pytest.mark.parametrize("kind", ["multipart/form-data; boundary=x", "multipart/form-data"])
def test_forms_are_refused(daemon: Daemon, path: str, kind: str) -> None:
    form = b'--x\r\nContent-Disposition: form-data; name="a"\r\n\r\n1\r\n--x--\r\n'
    daemon.problem("POST", path, 415, "unsupported_media_type", content=form, headers={"Content-Type": kind})


@pytest.mark.parametrize("asked", ["bytes=0-3", "bytes=1000000-", "bytes=0-1,3-4", "lines=1", "bytes=9-1"])
def test_ranges_are_ignored(daemon: Daemon, asked: str) -> None:
    whole = daemon.client.get("/v1/kinds")
    answer = daemon.client.get("/v1/kinds", headers={"Range": asked})
    assert (answer.status_code, answer.content) == (200, whole.content)
    for head in (daemon.client.head("/v1/kinds"), answer):
        assert not {"accept-ranges", "content-range"} & set(head.headers)
