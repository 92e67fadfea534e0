"""Results of accuracy made by hand: rows and hard cases with the figures that a test cares for."""

from typing import Any

from raywalk.models import AccuracyResult, BenchmarkResult

STRICT = {"intersector": "watertight", "slab": "padded", "spawn": "error-bound"}
FAST = STRICT | {"intersector": "moeller-trumbore"}
STATISTICS = ("median", "mean", "sd", "mad", "min", "p5", "p95", "p99", "ci95_low", "ci95_high")


def rate(count: int, of: int) -> dict[str, Any]:
    return {"count": count, "of": of, "ppm": 1e6 * count / of, "ppm_upper95": 1e6 * max(3, 2 * count) / of}


def row(class_: str, mrays: float, wrong: int, knobs: dict[str, Any] | None = None, **more: Any) -> dict[str, Any]:
    knobs = STRICT if knobs is None else knobs
    rays = 10_000
    none = rate(0, rays)
    ulps = {"hits": rays, "p50": 0.25, "p999": 1.5, "max": 9.0}
    error = dict.fromkeys(("false_misses", "false_hits", "wrong_ids", "near", "boundary", "ties", "nan_outputs"), none)
    error |= {"judged": rays, "wrong": rate(wrong, rays), "leaks": rate(wrong, rays), "self_hits": None}
    error |= {"double_hits": none if class_ in ("edge", "vertex") else None, "brute_mismatches": rate(0, 300)}
    error |= {"t_ulps": ulps | {"well_conditioned": ulps}}
    times = dict.fromkeys(STATISTICS, 1.0) | {"samples": 5, "discarded": 0, "failed": 0, "unstable": False}
    speed = {"mrays_per_s": mrays, "mrays_per_s_ci95_low": mrays, "mrays_per_s_ci95_high": mrays}
    made = {"structure": "bvh", "traversal": "while-while", "structure_id": "bunny.bvh", "knobs": knobs}
    made |= {"strict": knobs == STRICT, "class": class_, "rays": rays, "launch_ms": times, "worst_over_median": 1.1}
    return made | speed | {"bytes_per_triangle": 70.0, "steps_per_ray": 12.0, "error": error} | more


def case(number: int, failures: int = 0, knobs: dict[str, Any] | None = None, **more: Any) -> dict[str, Any]:
    knobs = STRICT if knobs is None else knobs
    made = {"number": number, "title": f"case {number}", "structure": "bvh", "traversal": "packet", "options": {}}
    made |= {"knobs": knobs, "strict": knobs == STRICT, "rays": 1000, "failures": failures, "nan_outputs": 0}
    made |= {"first_failure": "ray 0x1p0" if failures else None, "why_not": None, "ms": 2.0}
    return made | more


def accuracy_result(like: BenchmarkResult, rows: list[dict], cases: list[dict] | None = None) -> AccuracyResult:
    """With the machine and scene of a benchmark."""
    base = like.model_dump(mode="json")
    made = {"schema_version": 1, "kind": "accuracy", "id": "j0", "created_at": "2026-11-22T10:00:00Z"}
    made |= {"machine": base["machine"], "scene": base["scene"] if rows else None, "spec": {"quick": True}}
    made |= {"structures": [], "rows": rows, "cases": cases or [], "stop_reason": "completed", "notes": []}
    made |= {"invalid_costs": [{"structure": "bvh", "traversal": "while-while", "ratio": 0.8}] if rows else []}
    return AccuracyResult.model_validate(made)
