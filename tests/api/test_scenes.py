"""Scenes: the catalogue, loading, uploads, eviction."""

import gzip
from concurrent.futures import ThreadPoolExecutor

import pytest

from tests.api.conftest import Daemon, ply, pointers

BINARY = {"Content-Type": "application/octet-stream"}


def test_catalogue(daemon: Daemon) -> None:
    scenes = {scene["name"]: scene for scene in daemon.json("GET", "/v1/scenes", 200)["scenes"]}
    assert {"bunny", "organic", "room", "city", "soup"} <= scenes.keys()
    assert scenes["bunny"]["triangles"] == 69_451
    assert scenes["bunny"]["paper"]
    assert scenes["soup"]["fidelity"] == "procedural"


def test_loading_is_once(daemon: Daemon) -> None:
    daemon.client.delete("/v1/scenes/organic")
    with ThreadPoolExecutor(8) as pool:
        answers = list(
            pool.map(lambda _: daemon.client.post("/v1/scenes", json={"name": "organic", "triangles": 2000}), range(8))
        )
    assert sorted(answer.status_code for answer in answers) == [200] * 7 + [201]
    assert len({answer.json()["hash"] for answer in answers}) == 1
    assert answers[0].json()["triangles"] == 2000


def test_another_count_replaces_and_a_bad_one_does_not(daemon: Daemon) -> None:
    daemon.load("organic", triangles=500)
    assert daemon.build("organic", "bvh")["references"] == 500
    daemon.load("organic", triangles=600)
    daemon.problem("GET", "/v1/structures/organic.bvh", 404, "unknown_structure")
    problem = daemon.problem("POST", "/v1/scenes", 422, "invalid_request", json={"name": "organic", "triangles": 0})
    assert pointers(problem) == {"/triangles"}
    assert daemon.json("GET", "/v1/scenes/organic", 200)["triangles"] == 600


def test_unknown_scene_names_the_known(daemon: Daemon) -> None:
    for problem in (
        daemon.problem("GET", "/v1/scenes/nowhere", 404, "unknown_scene"),
        daemon.problem("DELETE", "/v1/scenes/nowhere", 404, "unknown_scene"),
        daemon.problem("GET", "/v1/scenes/nowhere/cameras", 404, "unknown_scene"),
        daemon.problem("POST", "/v1/scenes", 404, "unknown_scene", json={"name": "nowhere"}),
        daemon.problem("POST", "/v1/structures", 404, "unknown_scene", json={"scene": "nowhere", "kind": "bvh"}),
    ):
        assert "soup" in problem["known"]


def test_bodies_that_name_an_unknown_scene_are_pointed_at(daemon: Daemon) -> None:
    for path, body, where in (
        ("/v1/scenes", {"name": "nowhere"}, "/name"),
        ("/v1/structures", {"scene": "nowhere", "kind": "bvh"}, "/scene"),
    ):
        assert pointers(daemon.problem("POST", path, 404, "unknown_scene", json=body)) == {where}


def test_warnings_do_not_tell_where_uploads_lie(daemon: Daemon) -> None:
    warnings = daemon.client.put("/v1/scenes/warned", content=ply(0), headers=BINARY).json()["warnings"]
    assert any(warning.startswith("upload: ") for warning in warnings), warnings
    assert daemon.client.delete("/v1/scenes/warned").status_code == 204


def test_cameras(daemon: Daemon, soup: str) -> None:
    assert len(daemon.json("GET", f"/v1/scenes/{soup}/cameras", 200)["cameras"]) == 400
    cameras = daemon.json("GET", f"/v1/scenes/{soup}/cameras?frames=4", 200)["cameras"]
    assert len({tuple(camera["eye"]) for camera in cameras}) == 4
    for query in ("frames=0", "frames=1.5", "frames=x", "frames=1&frames=2", "frames=1000000"):
        problem = daemon.problem("GET", f"/v1/scenes/{soup}/cameras?{query}", 400, "invalid_parameter")
        assert pointers(problem) == {"?frames"}
    problem = daemon.problem("GET", f"/v1/scenes/{soup}/cameras?frame=3", 400, "invalid_parameter")
    assert pointers(problem) == {"?frame"}


def test_cameras_need_a_loaded_scene(daemon: Daemon) -> None:
    daemon.client.delete("/v1/scenes/city")
    daemon.problem("GET", "/v1/scenes/city/cameras", 409, "scene_not_loaded")


@pytest.mark.parametrize("triangles", [0, 1, 3])
@pytest.mark.parametrize("packed", [False, True])
def test_small_uploads_render(daemon: Daemon, triangles: int, packed: bool) -> None:
    data = ply(triangles)
    answer = daemon.client.put("/v1/scenes/tiny", content=gzip.compress(data) if packed else data, headers=BINARY)
    assert answer.status_code == 201, answer.text
    scene = answer.json()
    assert (scene["triangles"], scene["fidelity"], scene["loaded"]) == (triangles, "uploaded", True)
    assert ("bounds" in scene) == (triangles > 0)
    kinds = [kind["name"] for kind in daemon.json("GET", "/v1/kinds", 200)["kinds"]]
    for kind in kinds:
        structure = daemon.build("tiny", kind)
        assert structure["state"] == "ready", structure
    for kind, traversal in (
        ("bvh", "while-while"),
        ("grid", "dda"),
        ("kdtree", "short-stack-3"),
        ("embree", "intersect"),
    ):
        frame = daemon.frame("tiny", kind, traversal)
        assert frame.status_code == 200, frame.text
    assert daemon.client.delete("/v1/scenes/tiny").status_code == 204
    daemon.problem("GET", "/v1/scenes/tiny", 404, "unknown_scene")


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"not a mesh",
        ply(3)[:-5],
        ply(3, declared=1000),
        ply(1).replace(b"face 1", b"face -1"),
        gzip.compress(ply(3))[:-20],
    ],
    ids=["empty", "text", "truncated", "lying", "negative", "truncated gzip"],
)
def test_bad_uploads(daemon: Daemon, data: bytes) -> None:
    problem = daemon.problem("PUT", "/v1/scenes/broken", 422, "bad_mesh", content=data, headers=BINARY)
    assert "upload" in problem["detail"]
    assert "/tmp" not in problem["detail"]
    daemon.problem("GET", "/v1/scenes/broken", 404, "unknown_scene")


def test_upload_rules(daemon: Daemon) -> None:
    data = ply(1)
    daemon.problem("PUT", "/v1/scenes/bunny", 409, "scene_name_taken", content=data, headers=BINARY)
    daemon.problem(
        "PUT", "/v1/scenes/x", 415, "unsupported_media_type", content=data, headers={"Content-Type": "text/plain"}
    )
    daemon.problem("PUT", "/v1/scenes/Upper", 400, "invalid_parameter", content=data, headers=BINARY)
    assert daemon.client.put("/v1/scenes/twice", content=data, headers=BINARY).json()["triangles"] == 1
    assert daemon.client.put("/v1/scenes/twice", content=ply(2), headers=BINARY).json()["triangles"] == 2
    assert daemon.client.delete("/v1/scenes/twice").status_code == 204


def test_an_upload_may_be_told_by_the_extension_of_its_name(daemon: Daemon) -> None:
    api = daemon.client
    triangle = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
    headers = {"Content-Type": "application/octet-stream"}
    path = "/v1/scenes/told-by-name"
    refused = api.put(path, content=triangle, headers=headers)
    assert refused.status_code == 422
    assert "OBJ" in refused.json()["detail"]
    taken = api.put(path, content=triangle, headers=headers, params={"extension": "obj"})
    assert (taken.status_code, taken.json()["triangles"]) == (201, 1)
    assert api.put(path, content=triangle, headers=headers, params={"extension": "../x"}).status_code == 400
    named = api.put(path, content=b"mtllib /etc/hostname\n" + triangle, headers=headers, params={"extension": "obj"})
    assert named.status_code == 201
    assert any("outside" in warning for warning in named.json()["warnings"])
    api.delete(path)
