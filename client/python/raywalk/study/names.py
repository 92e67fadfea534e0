"""How techniques are called in the study, and which belong to which structure."""

from collections.abc import Iterable

from raywalk.models import BenchmarkResult, ResultRow

GRID, KDT3, KDT2, BVH = "grid/dda", "kdtree/short-stack-3", "kdtree/short-stack-2", "bvh/packet"
PER_RAY, EMBREE = "bvh/while-while", "embree/intersect"
STUDIED = (GRID, KDT3, KDT2, BVH)  # the columns of the paper's Table 2
NAMES = {
    GRID: "grid",
    KDT3: "kdt-3",
    KDT2: "kdt-2",
    BVH: "BVH",
    PER_RAY: "per-ray BVH",
    EMBREE: "Embree",
}
FAMILIES = {"grid": (GRID,), "kd-tree": (KDT3, KDT2), "BVH": (BVH, PER_RAY)}
RAYS = {"primary": "primary rays", "shadow": "primary and shadow rays", "whitted": "primary, shadow, secondary rays"}
BASES = {"primary": BVH, "shadow": KDT2, "whitted": KDT2}  # what is 100 %, as in the paper


def row_of(result: BenchmarkResult, mode: str, technique: str) -> ResultRow | None:
    for row in result.rows:
        if row.mode == mode and f"{row.structure}/{row.traversal}" == technique:
            return row
    return None


def techniques_in(results: Iterable[BenchmarkResult]) -> list[str]:
    """The named techniques that were measured anywhere."""
    found = {f"{row.structure}/{row.traversal}" for result in results for row in result.rows}
    return [technique for technique in NAMES if technique in found]


def family_of(technique: str) -> str | None:
    return next((family for family, members in FAMILIES.items() if technique in members), None)
