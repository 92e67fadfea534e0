"""Tiers and the gate, on the real daemon: which knobs a tier means, which rows are closed."""

import csv
import io
from typing import Any

import numpy as np
import pytest

from tests.api.conftest import Daemon, check_problem, pointers
from tests.api.test_rays import BINARY, rays

RAW = "application/octet-stream"
SMALL = {"scene": "soup", "width": 96, "height": 96, "frames": 4, "warmup": 1, "error_frames": 2}
STRICT = {"intersector": "watertight", "slab": "padded", "spawn": "error-bound"}
FAST = {"intersector": "moeller-trumbore", "slab": "plain", "spawn": "error-bound"}


def technique(**more: Any) -> dict[str, Any]:
    return {"structure": "bvh", "traversal": "while-while", **more}


def result_of(daemon: Daemon, spec: dict[str, Any]) -> dict[str, Any]:
    done = daemon.finish(daemon.submit(spec))
    assert done["state"] == "succeeded", done
    return daemon.json("GET", f"/v1/results/{done['result']}", 200)


def test_rows_have_the_knobs_of_their_tier(daemon: Daemon, soup: str) -> None:
    techniques = [
        technique(),
        technique(tier="fast"),
        technique(tier="fast", kernel={"slab": "ize"}),
        {"structure": "embree", "traversal": "intersect", "tier": "fast"},
    ]
    result = result_of(daemon, {**SMALL, "modes": ["shadow"], "techniques": techniques})
    assert [one["tier"] for one in result["spec"]["techniques"]] == ["strict", "fast", "fast", "fast"]
    strict, fast, custom, engine = result["rows"]
    assert strict["kernel_options"].items() >= STRICT.items()
    assert fast["kernel_options"].items() >= FAST.items()
    assert custom["kernel_options"].items() >= (FAST | {"slab": "ize"}).items()
    assert engine["kernel_options"] == {}
    assert [row["gate"]["tier"] for row in result["rows"]] == ["strict", "fast", "custom", None]
    assert [row["gate"]["limit_ppm"] for row in result["rows"]] == [0, 1, 1, None]


def test_a_strict_row_is_closed_with_its_error(daemon: Daemon, soup: str) -> None:
    modes = ["trace", "primary", "shadow", "whitted"]
    techniques = [technique(), {"structure": "grid", "traversal": "dda"}]
    done = daemon.finish(daemon.submit({**SMALL, "modes": modes, "techniques": techniques}))
    result = daemon.json("GET", f"/v1/results/{done['result']}", 200)
    for row in result["rows"]:
        gate, primary, shadow = row["gate"], row["error"]["primary_rays"], row["error"]["shadow_rays"]
        assert (gate["status"], gate["wrong"], gate["choice"]) == ("closed", 0, None), gate
        assert primary["rays"] == row["error"]["pixels"] == 2 * 96 * 96
        assert primary["judged"] == row["error"]["id_mismatches"]
        assert (shadow is None) == (row["mode"] in ("trace", "primary"))
        assert gate["rays"] == primary["rays"] + (shadow["rays"] if shadow else 0)
        if shadow:
            assert shadow["rays"] > 0
            assert shadow["self_hits"] == 0
        assert gate["wrong_ppm_upper95"] == pytest.approx(3e6 / gate["rays"])
        assert gate["reason"].startswith("0 wrong of ")
    assert not any("open" in note for note in result["notes"])
    table = daemon.client.get(f"/v1/results/{done['result']}", headers={"Accept": "text/csv"})
    lines = list(csv.DictReader(io.StringIO(table.text)))
    assert [(line["tier"], line["gate"], line["wrong"]) for line in lines] == [("strict", "closed", "0")] * 8
    assert [line["gate_reason"] for line in lines] == [row["gate"]["reason"] for row in result["rows"]]


def test_rays_that_meet_the_surface_they_leave_open_a_row(daemon: Daemon, soup: str) -> None:
    techniques = [technique(kernel={"spawn": "none"}), technique()]
    result = result_of(daemon, {**SMALL, "modes": ["primary", "shadow"], "techniques": techniques})
    rows = {(row["kernel_options"]["spawn"], row["mode"]): row for row in result["rows"]}
    bad = rows["none", "shadow"]
    assert bad["error"]["shadow_rays"]["self_hits"] > 0
    assert (bad["gate"]["tier"], bad["gate"]["status"]) == ("custom", "open")
    assert "self-hits of shadow rays" in bad["gate"]["reason"]
    assert rows["none", "primary"]["gate"]["status"] == "closed"  # nothing leaves a surface there
    assert rows["error-bound", "shadow"]["gate"]["status"] == "closed"
    assert any(note.startswith("1 of 4 rows are open") for note in result["notes"])


def test_auto_measures_and_says_why(daemon: Daemon, soup: str) -> None:
    kinds = daemon.json("GET", "/v1/kinds", 200)["kinds"]
    traversals = next(kind["traversals"] for kind in kinds if kind["name"] == "bvh")
    known = {o["name"]: o["choices"] for o in traversals[0]["options"] if o["name"] in ("intersector", "slab")}
    techniques = [technique(tier="auto"), technique(tier="auto", kernel=FAST)]
    result = result_of(daemon, {**SMALL, "modes": ["primary"], "techniques": techniques})
    free, fixed = result["rows"]
    assert (free["gate"]["tier"], free["gate"]["limit_ppm"], free["gate"]["status"]) == ("auto", 0, "closed")
    choice = free["gate"]["choice"]
    chosen = choice["candidates"][choice["chosen"]]
    assert chosen["kernel"] == free["kernel_options"]
    assert (chosen["wrong"], chosen["rays"]) == (0, 2 * 96 * 96)
    assert "strict" in [one["name"] for one in choice["candidates"]]
    times = [one["frame_ms"] for one in choice["candidates"]]
    assert times == sorted(times)
    for one in choice["candidates"]:
        assert all(one["kernel"][name] in choices for name, choices in known.items())
    assert choice["reason"].startswith(chosen["name"] + ":")
    assert [one["name"] for one in fixed["gate"]["choice"]["candidates"]] == ["as given"]  # nothing is left to choose
    assert fixed["kernel_options"].items() >= FAST.items()


def test_frames_in_tiers(daemon: Daemon, soup: str) -> None:
    def pixels(**more: Any) -> np.ndarray:
        answer = daemon.frame(soup, "bvh", "while-while", RAW, output="id", **more)
        assert answer.status_code == 200, answer.text
        return np.frombuffer(answer.content, "<f4")

    strict, fast = pixels(tier="strict"), pixels(tier="fast")
    assert (pixels() == strict).all()
    assert (strict == fast).mean() > 0.99
    assert daemon.frame(soup, "embree", "intersect", tier="fast").status_code == 200  # nothing to it


def test_bad_tiers_of_frames(daemon: Daemon, soup: str) -> None:
    refused = check_problem(daemon.frame(soup, "bvh", "while-while", tier="auto"), 422, "tier_needs_benchmark")
    assert pointers(refused) == {"/tier"}
    assert "benchmark" in refused["detail"]
    unknown = daemon.frame(soup, "bvh", "while-while", tier="exact")
    assert unknown.status_code == 422
    assert pointers(unknown.json()) == {"/tier"}


def test_bad_tiers_of_benchmarks(daemon: Daemon, soup: str) -> None:
    body = {"kind": "benchmark", "spec": {**SMALL, "techniques": [technique(), technique(tier="exact")]}}
    answer = daemon.client.post("/v1/jobs", json=body)
    assert answer.status_code == 422
    assert "/spec/techniques/1/tier" in pointers(answer.json())


def test_rays_in_tiers(daemon: Daemon, soup: str) -> None:
    data = rays(500).tobytes()

    def ask(**more: str) -> Any:
        query = {"scene": "soup", "structure": "bvh", "traversal": "while-while"} | more
        return daemon.client.post("/v1/rays", params=query, content=data, headers=BINARY)

    assert ask().content == ask(tier="strict").content
    fast = ask(tier="fast")
    assert fast.status_code == 200
    assert len(fast.content) == len(ask().content)
    assert pointers(check_problem(ask(tier="auto"), 422, "tier_needs_benchmark")) == {"?tier"}
    refused = ask(tier="exact")
    assert refused.status_code == 400
    assert pointers(refused.json()) == {"?tier"}
