"""Which techniques a benchmark measures when none are named."""

from collections.abc import Iterable, Sequence

from raywalk.kernel_options import offered
from raywalk.models import Kind, Technique

# The study's four, the per-ray BVH and Embree, by their wire names.
STANDARD = (
    "grid/dda",
    "kdtree/short-stack-3",
    "kdtree/short-stack-2",
    "bvh/packet",
    "bvh/while-while",
    "embree/intersect",
)
KNOB = "intersector"  # every traversal with knobs has it
ORACLE = "brute"  # the linear loop: right, and a thousand times too slow for a walkthrough


def measured(kinds: Iterable[Kind]) -> list[Technique]:
    """Every structure and traversal but bare loops and the oracle."""
    return [technique for kind in kinds if kind.name != ORACLE for technique in techniques_of(kind, baseline=False)]


def bare_loops(kinds: Iterable[Kind]) -> list[Technique]:
    """Bare loops that bound what is possible; mode trace only."""
    return [technique for kind in kinds for technique in techniques_of(kind, baseline=True)]


def in_tiers(kinds: Sequence[Kind], techniques: Iterable[Technique], tiers: Sequence[str]) -> list[Technique]:
    """Each technique in each tier; one without knobs once."""
    return [
        technique.model_copy(update={"tier": tier})
        for technique in techniques
        for tier in (tiers if KNOB in offered(kinds, technique) else tiers[:1])
    ]


def techniques_of(kind: Kind, baseline: bool) -> list[Technique]:
    chosen = [traversal for traversal in kind.traversals if bool(traversal.baseline) == baseline]
    return [Technique(structure=kind.name, traversal=traversal.name) for traversal in chosen]
