"""The paper's conclusions, each as times to compare and what they must show for it to hold."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from raywalk.study.compare import Ratio, Times, ratio
from raywalk.study.figures import Figures
from raywalk.study.names import BVH, GRID, KDT2, KDT3
from raywalk.study.parameters import UNIFORM_SCENES


@dataclass(frozen=True)
class Comparison:
    """One piece of evidence: `ratio` above 1 speaks for the conclusion."""

    scene: str
    mode: str
    ratio: Ratio


@dataclass(frozen=True)
class Conclusion:
    """`words` is the statement; `asks` what is compared, `scenes` how many scenes the paper had for it. `least` is the
    ratio that the mean must reach, where a statement is about how much and not about which."""

    name: str
    words: str
    source: str
    asks: str
    scenes: int
    compare: Callable[[Figures], list[Comparison]]
    least: float = 1.0


def pairs(
    figures: Figures, modes: Sequence[str], slow: Callable[..., Times | None], fast: Callable[..., Times | None]
) -> Iterator[Comparison]:
    """Every scene and mode that has both times."""
    for scene in figures.scenes:
        for mode in modes:
            over, under = slow(figures, scene, mode), fast(figures, scene, mode)
            if over and under:
                yield Comparison(scene, mode, ratio(over, under))


def technique(name: str) -> Callable[[Figures, str, str], Times | None]:
    return lambda figures, scene, mode: figures.times(scene, mode, name)


def chosen(pick: Callable[..., Times]) -> Callable[[Figures, str, str], Times | None]:
    """The slower (max) or faster (min) of kd-tree and BVH."""

    def of(figures: Figures, scene: str, mode: str) -> Times | None:
        both = [figures.times(scene, mode, KDT2), figures.times(scene, mode, BVH)]
        known = [one for one in both if one]
        return pick(known, key=lambda one: one.mean) if len(known) == len(both) else None

    return of


def faster(slow: str, fast: str, *modes: str) -> Callable[[Figures], list[Comparison]]:
    return lambda figures: list(pairs(figures, modes, technique(slow), technique(fast)))


def uniform(scene: str) -> bool:
    return scene in UNIFORM_SCENES


def grid_slower(figures: Figures) -> list[Comparison]:
    found = pairs(figures, ("primary", "shadow", "whitted"), technique(GRID), chosen(max))
    return [one for one in found if not uniform(one.scene)]


def grid_keeps_up(figures: Figures) -> list[Comparison]:
    found = pairs(figures, ("primary", "shadow"), chosen(max), technique(GRID))
    return [one for one in found if uniform(one.scene)]


def sensitive(figures: Figures) -> list[Comparison]:
    """How far kdt-2 and kdt-3 are apart, whichever is the faster."""
    found = pairs(figures, ("primary", "shadow", "whitted"), technique(KDT3), technique(KDT2))
    return [one if one.ratio.value >= 1 else Comparison(one.scene, one.mode, turned(one.ratio)) for one in found]


def turned(one: Ratio) -> Ratio:
    return Ratio(1 / one.value, 1 / one.high, 1 / one.low)


def smaller(figures: Figures) -> list[Comparison]:
    found = []
    for scene in figures.scenes:
        large, small = figures.megabytes(scene, "kdtree"), figures.megabytes(scene, "bvh")
        if large and small:
            found.append(Comparison(scene, "", Ratio(large / small, large / small, large / small)))
    return found


CONCLUSIONS = (
    Conclusion(
        "coherent",
        "For coherent rays the BVH is faster than the kd-tree.",
        "abstract and section 5",
        "primary rays, kdt-2's time over the packet BVH's",
        9,
        faster(KDT2, BVH, "primary"),
    ),
    Conclusion(
        "shadow",
        "The BVH has the higher performance for shadow rays, too.",
        "section 4",
        "primary and shadow rays, kdt-2's time over the packet BVH's",
        9,
        faster(KDT2, BVH, "shadow"),
    ),
    Conclusion(
        "incoherent",
        "For incoherent rays the kd-tree is faster than the BVH.",
        "abstract and section 5",
        "primary, shadow and secondary rays, the packet BVH's time over kdt-2's, where something reflects or refracts",
        5,
        faster(BVH, KDT2, "whitted"),
    ),
    Conclusion(
        "grid",
        "The uniform grid is slower than both, except in uniformly populated scenes.",
        "abstract",
        "all rays, other scenes than bunny, dragon and buddha, the grid's time over the slower of kdt-2 and packet BVH",
        6,
        grid_slower,
    ),
    Conclusion(
        "uniform",
        "In uniformly populated scenes the grid keeps up.",
        "abstract and section 4",
        "primary and shadow rays, bunny, dragon and buddha, the slower of kdt-2 and packet BVH over the grid's time",
        3,
        grid_keeps_up,
    ),
    Conclusion(
        "short stack",
        "Two values on the kd-tree's short stack are faster than three.",
        "sections 3.2 and 4",
        "all rays, kdt-3's time over kdt-2's",
        9,
        faster(KDT3, KDT2, "primary", "shadow", "whitted"),
    ),
    Conclusion(
        "details",
        "Performance is highly sensitive to details of the implementation on kd-trees.",
        "abstract",
        "all rays, the slower of kdt-2 and kdt-3 over the faster; at least 1.10x on average counts as highly",
        9,
        sensitive,
        1.10,
    ),
    Conclusion(
        "storage",
        "The storage of the BVH is smaller than the kd-tree's.",
        "section 3.3",
        "the kd-tree's bytes over the BVH's",
        9,
        smaller,
    ),
)
