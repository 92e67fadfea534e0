"""Whether the paper's conclusions hold here: a plain verdict with the figures that decide it."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from raywalk.models import BenchmarkResult
from raywalk.study.compare import NOISE, Ratio, overall
from raywalk.study.conclusions import CONCLUSIONS, Comparison, Conclusion
from raywalk.study.figures import Figures, Measured, Published

Verdict = Literal["holds", "does not hold", "undecided"]


@dataclass(frozen=True)
class Ruling:
    """`why` are the figures; `mean` is None where nothing could be compared."""

    verdict: Verdict
    why: str
    mean: Ratio | None
    evidence: tuple[Comparison, ...]


@dataclass(frozen=True)
class Finding:
    """A conclusion with its ruling here, and by the paper's own table for the same scenes."""

    conclusion: Conclusion
    here: Ruling
    paper: Ruling


def findings(results: Sequence[BenchmarkResult]) -> list[Finding]:
    here, paper = Measured(results), Published(results)
    return [Finding(one, ruling(one, here), ruling(one, paper)) for one in CONCLUSIONS]


def ruling(conclusion: Conclusion, figures: Figures) -> Ruling:
    evidence = tuple(conclusion.compare(figures))
    scenes = {one.scene for one in evidence}
    if not scenes:
        return Ruling("undecided", "there is nothing to compare", None, ())
    mean = overall([one.ratio for one in evidence])
    why = figures_of(evidence, mean)
    if 2 * len(scenes) < conclusion.scenes:
        few = f"{len(scenes)} scene is" if len(scenes) == 1 else f"{len(scenes)} scenes are"
        return Ruling("undecided", f"{few} too few where the paper had {conclusion.scenes}; {why}", mean, evidence)
    if conclusion.least > 1:
        return Ruling(by_amount(conclusion.least, mean), why, mean, evidence)
    verdict, reason = by_side(evidence, mean)
    return Ruling(verdict, f"{reason}; {why}" if reason else why, mean, evidence)


def by_amount(least: float, mean: Ratio) -> Verdict:
    """Sensitive enough, too little, or the interval holds the bound."""
    if mean.low == mean.high or not mean.low < least < mean.high:
        return "holds" if mean.value >= least else "does not hold"
    return "undecided"


def by_side(evidence: Sequence[Comparison], mean: Ratio) -> tuple[Verdict, str]:
    """The mean decides, when not more of the scenes speak against it than for it."""
    sides = [one.ratio.side for one in evidence]
    votes = sides.count("faster") - sides.count("slower")
    if mean.side == "faster" and votes > 0:
        return "holds", ""
    if mean.side == "slower" and votes < 0:
        return "does not hold", ""
    if mean.side == "even":
        return "undecided", f"the mean is within the noise of {100 * (NOISE - 1):.1f} % or its own interval"
    return "undecided", "the mean and the number of scenes say different things"


def figures_of(evidence: Sequence[Comparison], mean: Ratio) -> str:
    sides = [one.ratio.side for one in evidence]
    counts = f"{sides.count('faster')} of {len(sides)} comparisons for it, {sides.count('slower')} against"
    even = f", {sides.count('even')} within the noise" if "even" in sides else ""
    least, most = min(evidence, key=by_value), max(evidence, key=by_value)
    spread = f"from {told(least)} to {told(most)}" if len(evidence) > 1 else told(most)
    return f"{mean} on average ({counts}{even}; {spread})"


def by_value(one: Comparison) -> float:
    return one.ratio.value


def told(one: Comparison) -> str:
    return f"{one.ratio.value:.2f}x in {one.scene}" + (f", {one.mode}" if one.mode else "")
