"""Frames: formats, outputs, errors, concurrency."""

import io
import re
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from PIL import Image

from tests.api.conftest import Daemon, check_problem, pointers

RAW = "application/octet-stream"
TIMING = re.compile(r"queue;dur=([\d.]+), trace;dur=([\d.]+), readback;dur=([\d.]+), encode;dur=([\d.]+)")


def raw(daemon: Daemon, structure: str, traversal: str, channels: int, **more: object) -> np.ndarray:
    answer = daemon.frame("soup", structure, traversal, RAW, **more)
    assert answer.status_code == 200, answer.text
    return np.frombuffer(answer.content, "<f4").reshape(48, 64, channels)


@pytest.mark.parametrize(
    ("accept", "media_type", "magic"),
    [
        ("image/jpeg", "image/jpeg", b"\xff\xd8\xff"),
        ("*/*", "image/jpeg", b"\xff\xd8\xff"),
        ("image/*", "image/jpeg", b"\xff\xd8\xff"),
        ("image/jpeg;q=0.5, image/png", "image/png", b"\x89PNG"),
        ("text/html, image/x-exr;q=0.1", "image/x-exr", b"\x76\x2f\x31\x01"),
        (RAW, RAW, b""),
    ],
)
def test_formats(daemon: Daemon, soup: str, accept: str, media_type: str, magic: bytes) -> None:
    answer = daemon.frame(soup, "bvh", "while-while", accept)
    assert answer.status_code == 200, answer.text
    assert answer.headers["content-type"] == media_type
    assert answer.content.startswith(magic)
    assert TIMING.fullmatch(answer.headers["server-timing"])
    if media_type in ("image/jpeg", "image/png"):
        image = Image.open(io.BytesIO(answer.content))
        assert image.size == (64, 48)
        assert np.asarray(image).std() > 5  # there is something in it
    if media_type == RAW:
        assert len(answer.content) == 64 * 48 * 3 * 4


def test_png_is_srgb_of_raw(daemon: Daemon, soup: str) -> None:
    linear = np.clip(raw(daemon, "bvh", "while-while", 3), 0, 1)
    encoded = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    png = np.asarray(Image.open(io.BytesIO(daemon.frame(soup, "bvh", "while-while", "image/png").content)))
    assert np.abs(png.astype(float) - 255 * encoded).max() <= 1.0


def test_not_acceptable(daemon: Daemon, soup: str) -> None:
    check_problem(daemon.frame(soup, "bvh", "while-while", "text/html"), 406, "not_acceptable")
    check_problem(daemon.frame(soup, "bvh", "while-while", "image/jpeg;q=0"), 406, "not_acceptable")


@pytest.mark.parametrize(("output", "channels"), [("color", 3), ("normal", 3), ("depth", 1), ("id", 1), ("steps", 2)])
def test_outputs(daemon: Daemon, soup: str, output: str, channels: int) -> None:
    values = raw(daemon, "bvh", "while-while", channels, output=output)
    hit = raw(daemon, "bvh", "while-while", 1, output="id")[..., 0] >= 0
    assert 0 < hit.sum() <= hit.size
    if output == "depth":
        assert (np.isfinite(values[..., 0]) == hit).all()
    if output == "id":
        assert values.max() < 1000
    if output == "normal":
        assert np.linalg.norm(values[hit], axis=-1) == pytest.approx(1.0, abs=1e-3)
    for accept in ("image/jpeg", "image/png", "image/x-exr"):
        assert daemon.frame(soup, "bvh", "while-while", accept, output=output).status_code == 200


def test_fewer_lights(daemon: Daemon, soup: str) -> None:
    plain = raw(daemon, "bvh", "while-while", 3)
    dark = raw(daemon, "bvh", "while-while", 3, lights=0)
    assert (dark <= plain).all() and (dark < plain).any()
    assert (raw(daemon, "embree", "intersect", 3, lights=0) != raw(daemon, "embree", "intersect", 3)).any()
    assert (raw(daemon, "bvh", "while-while", 3, lights=1_000_000) == plain).all()


def test_all_structures_see_the_same_triangles(daemon: Daemon, soup: str) -> None:
    for kind in ("grid", "kdtree"):
        daemon.build(soup, kind)
    expected = raw(daemon, "brute", "loop", 1, output="id")
    others = ["bvh/while-while", "bvh/packet", "grid/dda", "kdtree/short-stack-3", "kdtree/short-stack-2"]
    for structure, traversal in (name.split("/") for name in others):
        assert (raw(daemon, structure, traversal, 1, output="id") == expected).all(), (structure, traversal)


def test_structure_by_id_and_camera_forms(daemon: Daemon, soup: str) -> None:
    plain = daemon.frame(soup, "bvh", "while-while").content
    assert daemon.frame(soup, "soup.bvh", "while-while").content == plain
    assert daemon.frame(soup, "bvh", "while-while", camera={"frame": 0}).content == plain
    pose = daemon.json("GET", "/v1/scenes/soup/cameras?frames=1", 200)["cameras"][0]
    assert daemon.frame(soup, "bvh", "while-while", camera=pose).content == plain
    assert daemon.frame(soup, "bvh", "while-while", camera={"frame": 100}).content != plain


@pytest.mark.parametrize(
    ("change", "status", "code", "where"),
    [
        ({"width": 0}, 422, "invalid_request", {"/width"}),
        ({"width": 8193}, 422, "invalid_request", {"/width"}),
        ({"height": 1e9}, 422, "invalid_request", {"/height"}),
        ({"width": "64"}, 422, "invalid_request", {"/width"}),
        ({"width": 1.5, "height": None}, 422, "invalid_request", {"/width", "/height"}),
        ({"depth": 17}, 422, "invalid_request", {"/depth"}),
        ({"lights": -1}, 422, "invalid_request", {"/lights"}),
        ({"lights": 0.5}, 422, "invalid_request", {"/lights"}),
        ({"mode": "trace"}, 422, "invalid_request", {"/mode"}),
        ({"kernel": {"registers": 40}}, 422, "unknown_option", {"/kernel/registers"}),
        ({"kernel": {"registers": [40]}}, 422, "invalid_request", {"/kernel/registers"}),
        ({"kernel": 40}, 422, "invalid_request", {"/kernel"}),
        ({"colour": 1}, 422, "invalid_request", {"/colour"}),
        ({"a/b~c": 1}, 422, "invalid_request", {"/a~1b~0c"}),
        ({"camera": {"eye": [0, 0, "NaN"], "target": [0, 0]}}, 422, "invalid_request",
         {"/camera/eye/2", "/camera/target"}),
        ({"camera": {"eye": [0, 0, 0]}}, 422, "invalid_request", {"/camera"}),
        ({"camera": {"eye": [0, 0, 1e38], "target": [0, 0, 0]}}, 422, "invalid_request", {"/camera/eye/2"}),
        ({"camera": {"frame": 5, "of": 5}}, 422, "invalid_camera", {"/camera/frame"}),
        ({"camera": {"eye": [1, 2, 3], "target": [1, 2, 3]}}, 422, "invalid_camera", {"/camera"}),
        ({"camera": {"eye": [0, 5, 0], "target": [0, 0, 0]}}, 422, "invalid_camera", {"/camera"}),
        ({"camera": {"eye": [0, 0, 5], "target": [0, 0, 0], "vertical_fov_deg": 180}}, 422, "invalid_request",
         {"/camera/vertical_fov_deg"}),
        ({"structure": "octree"}, 404, "unknown_kind", {"/structure"}),
        ({"structure": "bvh.x"}, 422, "foreign_structure", {"/structure"}),
        ({"structure": "soup.bvh.00000000"}, 409, "structure_not_built", {"/structure"}),
        ({"traversal": "fastest"}, 404, "unknown_traversal", {"/traversal"}),
        ({"scene": "nowhere"}, 404, "unknown_scene", {"/scene"}),
        ({"scene": 5}, 422, "invalid_request", {"/scene"}),
    ],
)  # fmt: skip
def test_refusals(daemon: Daemon, soup: str, change: dict, status: int, code: str, where: set[str]) -> None:
    body = {"scene": soup, "structure": "bvh", "traversal": "while-while", **change}
    assert pointers(daemon.problem("POST", "/v1/frames", status, code, json=body)) == where


def test_missing_fields_point_at_their_parent(daemon: Daemon) -> None:
    problem = daemon.problem("POST", "/v1/frames", 422, "invalid_request", json={"scene": "soup"})
    assert pointers(problem) == {""}
    assert {"structure", "traversal"} == {re.search("'(.*)'", error["detail"]).group(1) for error in problem["errors"]}


@pytest.mark.parametrize(
    "body",
    [b"", b"{", b'{"width": 1e999}', b'{"width": NaN}', b"\xff\xfe", b"[" * 100_000, b'{"scene": "\\ud800"}'],
    ids=["nothing", "half", "infinite", "nan", "no utf-8", "deep", "lone surrogate"],
)
def test_malformed_json(daemon: Daemon, body: bytes) -> None:
    daemon.problem(
        "POST", "/v1/frames", 400, "malformed_json", content=body, headers={"Content-Type": "application/json"}
    )


def test_a_field_that_comes_twice(daemon: Daemon) -> None:
    body = b'{"scene": "soup", "structure": "bvh", "camera": {"frame": 1, "frame": 2}, "traversal": "packet"}'
    headers = {"Content-Type": "application/json"}
    problem = daemon.problem("POST", "/v1/frames", 400, "duplicate_field", content=body, headers=headers)
    assert pointers(problem) == {"/camera/frame"}


def test_wrong_content_type(daemon: Daemon) -> None:
    daemon.problem(
        "POST", "/v1/frames", 415, "unsupported_media_type", content=b"{}", headers={"Content-Type": "text/plain"}
    )


@pytest.mark.parametrize("chunked", [False, True])
def test_oversized_json(daemon: Daemon, chunked: bool) -> None:
    blank = b" " * (1 << 16)
    content = (blank for _ in range(40)) if chunked else blank * 40
    headers = {"Content-Type": "application/json"}
    daemon.problem("POST", "/v1/frames", 413, "body_too_large", content=content, headers=headers)
    assert daemon.client.get("/livez").status_code == 200


def test_parallel_frames_are_equal(daemon: Daemon, soup: str) -> None:
    bodies = [{"camera": {"frame": 7 * (i % 4)}, "mode": "shadow"} for i in range(48)]
    alone = [daemon.frame(soup, "bvh", "while-while", "image/png", **body).content for body in bodies[:4]]
    with ThreadPoolExecutor(16) as pool:
        answers = list(pool.map(lambda body: daemon.frame(soup, "bvh", "while-while", "image/png", **body), bodies))
    for i, answer in enumerate(answers):
        assert answer.status_code == 200, answer.text
        assert answer.content == alone[i % 4]


def test_eviction_does_not_disturb_running_frames(daemon: Daemon) -> None:
    def one(i: int) -> int:
        if i % 6 == 5:
            daemon.client.delete("/v1/scenes/organic")
            daemon.load("organic", triangles=900)
            return daemon.client.post("/v1/structures", json={"scene": "organic", "kind": "bvh"}).status_code
        return daemon.frame("organic", "bvh", "while-while", width=256, height=256).status_code

    daemon.load("organic", triangles=900)
    daemon.build("organic", "bvh")
    with ThreadPoolExecutor(8) as pool:
        statuses = list(pool.map(one, range(60)))
    assert set(statuses) <= {200, 202, 409}
    assert daemon.client.get("/livez").status_code == 200


@pytest.mark.parametrize(("width", "height"), [(64, 64), (100, 65), (333, 257), (17, 640)])
def test_jpeg_of_many_strips_is_the_image(daemon: Daemon, soup: str, width: int, height: int) -> None:
    size = {"width": width, "height": height}
    jpeg, png = (daemon.frame(soup, "bvh", "while-while", accept, **size) for accept in ("image/jpeg", "image/png"))
    lossy, exact = (np.asarray(Image.open(io.BytesIO(image.content)), dtype=float) for image in (jpeg, png))
    assert lossy.shape == exact.shape == (height, width, 3)
    # By rows of blocks: a strip out of place would stand out.
    for row in range(0, height, 16):
        luma = [rows[row : row + 16] @ (0.299, 0.587, 0.114) for rows in (lossy, exact)]
        assert np.sqrt(np.mean((luma[0] - luma[1]) ** 2)) < 8, row


def test_an_intersector_needs_its_records(daemon: Daemon, soup: str) -> None:
    kernel = {"intersector": "baldwin-weber"}
    answer = daemon.frame(soup, "bvh", "while-while", "image/png", kernel=kernel)
    problem = check_problem(answer, 422, "unfit_structure")
    assert [error["pointer"] for error in problem["errors"]] == ["/kernel/intersector"]
    assert "transforms" in problem["detail"]
    built = daemon.build(soup, "bvh", {"triangles": "transforms"})
    expected = raw(daemon, "bvh", "while-while", 1, output="id")
    values = raw(daemon, built["id"], "while-while", 1, output="id", kernel=kernel)
    assert (values != expected).mean() < 0.01
    check_problem(daemon.frame(soup, built["id"], "while-while", "image/png"), 422, "unfit_structure")
