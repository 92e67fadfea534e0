"""Rows of a sweep as points of speed and error, and which of them nothing beats."""

from collections.abc import Sequence
from dataclasses import dataclass

from raywalk.models import AccuracyResult, SweepRow

CLASSES = ("primary", "shadow", "diffuse", "random", "edge", "vertex")
# Of the knobs: short for charts, the strict choice first.
INTERSECTORS = {"watertight": "W", "moeller-trumbore": "M", "exact": "E", "double": "D", "baldwin-weber": "B"}
SLABS = ("padded", "ize", "plain")
SPAWNS = ("error-bound", "integer", "constant", "none")


@dataclass(frozen=True)
class Point:
    """`ppm` is of wrong rays, `bound` the upper end of its 95 % interval: all that is known where none was wrong."""

    structure: str
    traversal: str
    knobs: dict[str, float | str]
    strict: bool
    mrays: float
    ppm: float
    bound: float
    bytes_per_triangle: float

    @property
    def technique(self) -> str:
        return f"{self.structure}/{self.traversal}"

    @property
    def intersector(self) -> str:
        return str(self.knobs.get("intersector", ""))

    @property
    def letter(self) -> str:
        """Of the intersector; its first letter where it has no other; empty where the technique has no choice."""
        return INTERSECTORS.get(self.intersector, self.intersector[:1].upper())

    @property
    def slab(self) -> str:
        return str(self.knobs.get("slab", SLABS[0]))

    @property
    def spawn(self) -> str:
        return str(self.knobs.get("spawn", SPAWNS[0]))

    @property
    def said(self) -> str:
        """The knobs that are not strict, for people."""
        return setting_text(self.knobs, self.strict)

    @property
    def error_text(self) -> str:
        return error_text(self.ppm, self.bound)


def setting_text(knobs: dict[str, float | str], strict: bool) -> str:
    """A technique without knobs of ours is neither strict nor fast."""
    return knobs_text(knobs) or ("strict" if strict else "as it is")


def knobs_text(knobs: dict[str, float | str]) -> str:
    """What differs from the strict choices."""
    strict = {"intersector": next(iter(INTERSECTORS)), "slab": SLABS[0], "spawn": SPAWNS[0], "stack_entries": 4}
    return ", ".join(str(value) for name, value in knobs.items() if name in strict and value != strict[name])


def error_text(ppm: float, bound: float) -> str:
    """`0 (<300)`: none was wrong and the rate is below 300 ppm; else `12 (<19)`."""
    return f"{rounded(ppm)} (<{rounded(bound)})"


def rounded(value: float) -> str:
    if value >= 100:
        return f"{value:.0f}"
    return f"{value:.2g}"


def point_of(row: SweepRow) -> Point:
    wrong = row.error.wrong
    return Point(
        row.structure,
        row.traversal,
        dict(row.knobs),
        row.strict,
        row.mrays_per_s,
        wrong.ppm,
        wrong.ppm_upper95,
        row.bytes_per_triangle,
    )


def points_of(result: AccuracyResult) -> dict[str, list[Point]]:
    """By class of rays, in their order; classes without rows are missing."""
    found: dict[str, list[Point]] = {name: [] for name in CLASSES}
    for row in result.rows:
        found[row.class_].append(point_of(row))
    return {name: points for name, points in found.items() if points}


def pareto(points: Sequence[Point]) -> list[Point]:
    """Those that no other beats in speed without being more often wrong, the fastest first; of equals the first."""
    front: list[Point] = []
    for point in sorted(points, key=lambda one: (-one.mrays, one.ppm)):
        if not front or point.ppm < front[-1].ppm:
            front.append(point)
    return front
