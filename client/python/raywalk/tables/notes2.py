"""What stands below Table 2, and the words that it shares with the table."""

import math
from collections.abc import Sequence

from raywalk.gate import gate_notes
from raywalk.models import BenchmarkResult, ResultRow
from raywalk.tables.gpu import gpu_notes
from raywalk.tables.paper import PAPER_DEVICE, PAPER_FRAMES, PAPER_SIZE, Paper
from raywalk.tables.runs import compared_of, differing

MODES = {
    "trace": "traversal alone",
    "primary": "primary rays",
    "shadow": "these and a shadow ray a light",
    "whitted": "these and secondary rays",
}
# What is 100 %, as in the paper: its BVH for primary rays, kdt-2 for the others.
BVH, KDT2 = "bvh/packet", "kdtree/short-stack-2"
BASE = {"trace": BVH, "primary": BVH, "shadow": KDT2, "whitted": KDT2}


def technique(row: ResultRow) -> str:
    return f"{row.structure}/{row.traversal}"


def is_bound(row: ResultRow) -> bool:
    """A bare loop only says what is possible."""
    return row.traversal.startswith("loop-")


def notes(results: Sequence[BenchmarkResult]) -> list[str]:
    said = [
        f"100 % is {BVH} for primary rays and {KDT2} for the others, as in the paper (else the fastest); "
        "the fastest of each group is set off."
    ]
    modes = {row.mode for result in results for row in result.rows}
    said.append("Modes: " + "; ".join(f"{mode}: {prose}" for mode, prose in MODES.items() if mode in modes) + ".")
    said += error_note(results) + gate_notes(results)
    if any(Paper(result.scene.paper).has_times for result in results):
        said.append(f"{PAPER_DEVICE}: the paper's times, {PAPER_SIZE}, {PAPER_FRAMES} frames of its own walkthroughs.")
    if any(is_bound(row) for result in results for row in result.rows):
        said.append("embree/loop-1 and loop-8 are bare loops over one ray and eight: they bound what is possible.")
    if any(row.frame_ms.unstable for result in results for row in result.rows):
        said.append("* unstable: repeats of the same frame spread by more than 3.5 %.")
    said += gpu_notes(results)
    own = [f"{result.scene.name}: {note}" for result in results for note in notes_of(result)]
    return said + list(dict.fromkeys(own))


def error_note(results: Sequence[BenchmarkResult]) -> list[str]:
    """What each kind of technique is compared with, and on how many frames."""
    rows = [row for result in results for row in result.rows]
    if not rows:
        return []
    sides = {
        "ours": [row for row in rows if row.structure != "embree"],
        "Embree itself": [row for row in rows if row.structure == "embree"],
    }
    clauses = []
    for side, compared in sides.items():
        references = dict.fromkeys(row.error.reference for row in compared)
        if references:
            clauses.append(f"{side} against {' or '.join(reference_name(name) for name in references)}")
    frames = compared_of(results[0])
    on = "as many frames as column `compared` says" if differing(results, ["compared"]) else count_of(frames, "frame")
    return [
        f"Errors: {', '.join(clauses)}, on {on}: primary rays that hit another triangle (ppm, with the upper end of "
        "the 95 % interval); of the images RMSE of sRGB values in 0..1 and mean FLIP (0 to 1, at 67 pixels a degree)."
    ]


def reference_name(name: str) -> str:
    if not name.startswith("embree/"):
        return name
    return f"watertight Embree ({name})" if "robust=on" in name else f"Embree ({name})"


def count_of(count: int | None, what: str) -> str:
    return f"{count} {what}" if count == 1 else f"{count} {what}s"


def notes_of(result: BenchmarkResult) -> list[str]:
    """The notes of one result; what the daemon says of an early stop is not said again."""
    said = []
    if result.scene.fidelity == "stand-in":
        said.append(f"a generated stand-in with {result.scene.triangles} triangles.")
    if nothing_bounces(result):
        said.append("nothing in view reflects or refracts: whitted traces the rays of shadow, in about the same time.")
    if result.stop_reason != "completed" and not any("time limit" in note for note in result.notes):
        said.append(f"measuring stopped early ({result.stop_reason}).")
    return said + result.notes


def nothing_bounces(result: BenchmarkResult) -> bool:
    """True when bounces were allowed and every technique traced as many rays with them as without."""
    rays = {(technique(row), row.mode): row.rays_per_frame for row in result.rows}
    pairs = [
        (rays[name, "whitted"], rays[name, "shadow"])
        for name, mode in rays
        if mode == "whitted" and (name, "shadow") in rays
    ]
    return bool(result.spec.depth and pairs) and all(math.isclose(one, other) for one, other in pairs)
