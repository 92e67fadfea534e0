"""Structures: builds, options, states, eviction."""

from concurrent.futures import ThreadPoolExecutor

import pytest

from tests.api.conftest import Daemon, ply, pointers


def test_build_has_figures(daemon: Daemon, soup: str) -> None:
    structure = daemon.build(soup, "grid")
    assert structure["id"] == "soup.grid"
    assert len(structure["resolution"]) == 3
    assert structure["references_per_triangle"] == pytest.approx(structure["references"] / 1000)
    assert structure["size_bytes"] > 0
    assert structure["build_ms"] > 0


def test_options_make_another_id(daemon: Daemon, soup: str) -> None:
    sampled = daemon.build(soup, "kdtree", {"sah": "sampled"})
    assert sampled["id"].startswith("soup.kdtree.")
    assert sampled["options"]["sah"] == "sampled"
    default = daemon.build(soup, "kdtree", {"sah": "exact"})
    assert default["id"] == "soup.kdtree"
    ids = {structure["id"] for structure in daemon.json("GET", "/v1/structures", 200)["structures"]}
    assert {sampled["id"], default["id"]} <= ids


@pytest.mark.parametrize(
    ("options", "code", "pointer"),
    [
        ({"sah": "wrong"}, "invalid_option", "/options/sah"),
        ({"sah": 1}, "invalid_option", "/options/sah"),
        ({"traversal_cost": -1}, "invalid_option", "/options/traversal_cost"),
        ({"traversal_cost": "much"}, "invalid_option", "/options/traversal_cost"),
        ({"magic": 1}, "unknown_option", "/options/magic"),
        ({"sah": True}, "invalid_request", "/options/sah"),
        ({"sah": [1]}, "invalid_request", "/options/sah"),
    ],
)
def test_bad_options(daemon: Daemon, soup: str, options: dict, code: str, pointer: str) -> None:
    body = {"scene": soup, "kind": "kdtree", "options": options}
    assert pointers(daemon.problem("POST", "/v1/structures", 422, code, json=body)) == {pointer}


def test_unknown_kind_names_the_known(daemon: Daemon, soup: str) -> None:
    problem = daemon.problem("POST", "/v1/structures", 404, "unknown_kind", json={"scene": soup, "kind": "octree"})
    assert {"bvh", "grid"} <= set(problem["known"])


def test_scene_must_be_loaded(daemon: Daemon) -> None:
    daemon.client.delete("/v1/scenes/city")
    problem = daemon.problem("POST", "/v1/structures", 409, "scene_not_loaded", json={"scene": "city", "kind": "bvh"})
    assert "POST /v1/scenes" in problem["detail"]
    assert pointers(problem) == {"/scene"}


def test_one_build_a_key(daemon: Daemon) -> None:
    daemon.load("organic", triangles=3000)
    body = {"scene": "organic", "kind": "kdtree"}
    with ThreadPoolExecutor(8) as pool:
        answers = list(pool.map(lambda _: daemon.client.post("/v1/structures", json=body), range(8)))
    assert {answer.status_code for answer in answers} <= {200, 202}
    assert daemon.build("organic", "kdtree")["state"] == "ready"


def test_eviction(daemon: Daemon) -> None:
    daemon.load("organic", triangles=700)
    daemon.build("organic", "bvh")
    assert daemon.client.delete("/v1/structures/organic.bvh").status_code == 204
    daemon.problem("DELETE", "/v1/structures/organic.bvh", 404, "unknown_structure")
    frame = daemon.frame("organic", "bvh", "while-while")
    assert frame.status_code == 409
    assert "POST /v1/structures" in frame.json()["detail"]
    daemon.build("organic", "bvh")
    assert daemon.client.delete("/v1/scenes/organic").status_code == 204
    daemon.problem("GET", "/v1/structures/organic.bvh", 404, "unknown_structure")


def test_what_is_pinned_stays(daemon: Daemon) -> None:
    daemon.load("organic", triangles=3000)
    daemon.build("organic", "bvh")
    assert daemon.client.put("/v1/structures/organic.bvh/pin").status_code == 204
    assert daemon.json("GET", "/v1/structures/organic.bvh", 200)["pinned"]
    daemon.problem("DELETE", "/v1/structures/organic.bvh", 409, "pinned")
    daemon.problem("DELETE", "/v1/scenes/organic", 409, "pinned")  # would take the structure with it
    daemon.problem("POST", "/v1/scenes", 409, "pinned", json={"name": "organic", "triangles": 4000})
    daemon.load("organic", triangles=3000)  # there already
    assert daemon.client.delete("/v1/structures/organic.bvh/pin").status_code == 204
    assert daemon.client.delete("/v1/structures/organic.bvh").status_code == 204

    assert daemon.client.put("/v1/scenes/organic/pin").status_code == 204
    assert daemon.client.put("/v1/scenes/organic/pin").status_code == 204
    assert daemon.json("GET", "/v1/scenes/organic", 200)["pinned"]
    daemon.problem("DELETE", "/v1/scenes/organic", 409, "pinned")
    assert daemon.client.delete("/v1/scenes/organic/pin").status_code == 204
    assert not daemon.json("GET", "/v1/scenes/organic", 200)["pinned"]
    assert daemon.client.delete("/v1/scenes/organic").status_code == 204


def test_a_pinned_upload_is_not_replaced(daemon: Daemon) -> None:
    headers = {"Content-Type": "application/octet-stream"}
    assert daemon.client.put("/v1/scenes/kept", content=ply(2), headers=headers).status_code == 201
    assert daemon.client.put("/v1/scenes/kept/pin").status_code == 204
    daemon.problem("PUT", "/v1/scenes/kept", 409, "pinned", content=ply(3), headers=headers)
    assert daemon.json("GET", "/v1/scenes/kept", 200)["triangles"] == 2
    assert daemon.client.delete("/v1/scenes/kept/pin").status_code == 204
    assert daemon.client.delete("/v1/scenes/kept").status_code == 204


def test_what_is_not_there_cannot_be_pinned(daemon: Daemon) -> None:
    daemon.problem("PUT", "/v1/scenes/nowhere/pin", 404, "unknown_scene")
    daemon.problem("PUT", "/v1/scenes/dragon/pin", 409, "scene_not_loaded")
    daemon.problem("PUT", "/v1/structures/soup.nothing/pin", 404, "unknown_structure")
    daemon.problem("DELETE", "/v1/scenes/nowhere/pin", 404, "unknown_scene")
