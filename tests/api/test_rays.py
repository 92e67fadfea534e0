"""Binary rays in, binary hits out."""

import socket

import numpy as np
import pytest

from tests.api.conftest import Daemon, pointers

RAY = np.dtype([("o", "<f4", 3), ("tmin", "<f4"), ("d", "<f4", 3), ("tmax", "<f4")])
HIT = np.dtype([("t", "<f4"), ("id", "<u4"), ("u", "<f4"), ("v", "<f4")])
MISS = 0xFFFFFFFF
BINARY = {"Content-Type": "application/octet-stream"}


def rays(count: int, seed: int = 1) -> np.ndarray:
    random = np.random.default_rng(seed)
    out = np.zeros(count, RAY)
    out["o"] = random.uniform(-3, 3, (count, 3))
    out["d"] = random.uniform(-1, 1, (count, 3)) - out["o"]
    out["tmax"] = 1e30
    return out


def query(daemon: Daemon, structure: str, traversal: str, data: bytes, kind: str | None = None):
    parameters = {"scene": "soup", "structure": structure, "traversal": traversal} | ({"query": kind} if kind else {})
    return daemon.client.post("/v1/rays", params=parameters, content=data, headers=BINARY)


def test_closest_agrees_with_brute_force(daemon: Daemon, soup: str) -> None:
    data = rays(2000).tobytes()
    expected = query(daemon, "brute", "loop", data)
    assert expected.status_code == 200, expected.text
    hits = np.frombuffer(expected.content, HIT)
    assert 0 < (hits["id"] != MISS).sum() < len(hits)
    assert query(daemon, "bvh", "while-while", data).content == expected.content
    occluded = np.frombuffer(query(daemon, "bvh", "while-while", data, "any").content, "u1")
    assert (occluded.astype(bool) == (hits["id"] != MISS)).all()


def test_invalid_rays_miss_and_are_counted(daemon: Daemon, soup: str) -> None:
    bad = rays(6)
    bad["o"][0] = np.nan
    bad["d"][1] = 0
    bad["d"][2, 0] = np.inf
    bad["tmin"][3] = np.nan
    bad["tmax"][4] = -np.inf
    for structure, traversal in (("bvh", "while-while"), ("embree", "intersect"), ("brute", "loop")):
        answer = query(daemon, structure, traversal, bad.tobytes())
        assert answer.headers["x-invalid-rays"] == "5"
        assert (np.frombuffer(answer.content, HIT)["id"][:5] == MISS).all()


def test_an_infinite_tmax_is_unbounded(daemon: Daemon, soup: str) -> None:
    bounded, unbounded = rays(500), rays(500)
    unbounded["tmax"] = np.inf
    daemon.build(soup, "grid")
    daemon.build(soup, "kdtree")
    for structure, traversal in (
        ("brute", "loop"),
        ("bvh", "while-while"),
        ("grid", "dda"),
        ("kdtree", "short-stack-3"),
        ("embree", "intersect"),
    ):
        answer = query(daemon, structure, traversal, unbounded.tobytes())
        assert answer.headers["x-invalid-rays"] == "0"
        hits = np.frombuffer(answer.content, HIT)
        missed = hits["id"] == MISS
        assert (hits["t"][missed] == np.finfo(np.float32).max).all()
        expected = np.frombuffer(query(daemon, structure, traversal, bounded.tobytes()).content, HIT)
        assert (hits[~missed] == expected[~missed]).all(), structure
        assert ((expected["id"] == MISS) == missed).all(), structure


def test_no_rays(daemon: Daemon, soup: str) -> None:
    answer = query(daemon, "bvh", "while-while", b"")
    assert (answer.status_code, answer.content) == (200, b"")


@pytest.mark.parametrize(
    ("change", "status", "code", "where"),
    [
        ({"query": "all"}, 400, "invalid_parameter", {"?query"}),
        ({"scene": ""}, 400, "invalid_parameter", {"?scene"}),
        ({"extra": "1"}, 400, "invalid_parameter", {"?extra"}),
        ({"structure": "soup.bvh.00000000"}, 409, "structure_not_built", {"?structure"}),
        ({"traversal": "none"}, 404, "unknown_traversal", {"?traversal"}),
        ({"scene": "nowhere"}, 404, "unknown_scene", {"?scene"}),
    ],
)
def test_parameters(daemon: Daemon, soup: str, change: dict, status: int, code: str, where: set[str]) -> None:
    parameters = {"scene": soup, "structure": "bvh", "traversal": "while-while", **change}
    problem = daemon.problem("POST", "/v1/rays", status, code, params=parameters, content=b"", headers=BINARY)
    assert pointers(problem) == where


def test_missing_parameters_are_named(daemon: Daemon) -> None:
    parameters = {"scene": "soup"}
    problem = daemon.problem(
        "POST", "/v1/rays", 400, "invalid_parameter", params=parameters, content=b"", headers=BINARY
    )
    assert pointers(problem) == {"?structure", "?traversal"}


def test_half_a_ray(daemon: Daemon, soup: str) -> None:
    assert query(daemon, "bvh", "while-while", b"x" * 33).json()["code"] == "bad_rays"


def test_too_many_rays_by_length(daemon: Daemon, soup: str) -> None:
    """The length alone is enough to refuse; the body is never sent."""
    with socket.create_connection(("127.0.0.1", daemon.port), timeout=20) as connection:
        target = "/v1/rays?scene=soup&structure=bvh&traversal=while-while"
        head = f"POST {target} HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Type: application/octet-stream\r\n"
        connection.sendall((head + f"Content-Length: {1 << 30}\r\nConnection: close\r\n\r\n").encode())
        assert connection.recv(4096).startswith(b"HTTP/1.1 413 ")
