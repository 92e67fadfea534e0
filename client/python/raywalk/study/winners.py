"""Which structure wins for which scene and which rays."""

from collections.abc import Sequence
from dataclasses import dataclass

from raywalk.gate import is_open
from raywalk.models import BenchmarkResult, ResultRow
from raywalk.study.compare import Ratio, Times, ratio
from raywalk.study.names import FAMILIES, NAMES, row_of
from raywalk.study.parameters import MODES


@dataclass(frozen=True)
class Win:
    """The fastest technique of a structure against the next structure's fastest."""

    scene: str
    mode: str
    family: str
    row: ResultRow
    second: str
    margin: Ratio

    @property
    def even(self) -> bool:
        return self.margin.side == "even"

    @property
    def technique(self) -> str:
        return NAMES[f"{self.row.structure}/{self.row.traversal}"]

    @property
    def words(self) -> str:
        if self.even:
            return f"{self.family} and {self.second}, even"
        return f"{self.family}, {self.margin.value:.2f}x"


def winners(results: Sequence[BenchmarkResult]) -> list[Win]:
    """One for every scene and mode in which at least two structures were measured. An open row cannot win."""
    found = [winner(result, mode) for result in results for mode in MODES]
    return [win for win in found if win]


def winner(result: BenchmarkResult, mode: str) -> Win | None:
    best: dict[str, ResultRow] = {}
    for family, members in FAMILIES.items():
        known = [row for member in members if (row := row_of(result, mode, member)) and row.frame_ms.mean > 0]
        if rows := [row for row in known if not is_open(row)]:
            best[family] = min(rows, key=lambda row: row.frame_ms.mean)
    if len(best) < 2:
        return None
    first, second = sorted(best, key=lambda family: best[family].frame_ms.mean)[:2]
    margin = ratio(times_of(best[second]), times_of(best[first]))
    return Win(result.scene.name, mode, first, best[first], second, margin)


def times_of(row: ResultRow) -> Times:
    return Times(row.frame_ms.mean, tuple(row.frame_times_ms or ()))
