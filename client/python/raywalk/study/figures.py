"""Times to draw conclusions from: those measured here, and the paper's own for the same scenes."""

from collections.abc import Sequence
from typing import Protocol

from raywalk.gate import is_open
from raywalk.models import BenchmarkResult
from raywalk.study.compare import Times
from raywalk.study.names import row_of
from raywalk.tables.paper import Paper

SECONDARY = 1.01  # rays with bounces over those without, from which on a scene has secondary rays


class Figures(Protocol):
    """Where conclusions take their figures from."""

    @property
    def scenes(self) -> Sequence[str]: ...

    def times(self, scene: str, mode: str, technique: str) -> Times | None: ...

    def megabytes(self, scene: str, kind: str) -> float | None: ...


class Measured:
    """This device's."""

    def __init__(self, results: Sequence[BenchmarkResult]):
        self._results = {result.scene.name: result for result in results}
        self.scenes: Sequence[str] = list(self._results)

    def times(self, scene: str, mode: str, technique: str) -> Times | None:
        """None, too, for an open row, and for mode whitted where nothing in view reflects or refracts."""
        result = self._results[scene]
        row = row_of(result, mode, technique)
        if row is None or is_open(row) or row.frame_ms.mean <= 0:
            return None
        without = row_of(result, "shadow", technique) if mode == "whitted" else None
        if without and row.rays_per_frame < SECONDARY * without.rays_per_frame:
            return None
        return Times(row.frame_ms.mean, tuple(row.frame_times_ms or ()))

    def megabytes(self, scene: str, kind: str) -> float | None:
        sizes = [one.size_bytes for one in self._results[scene].structures if one.kind == kind and one.size_bytes]
        return sizes[0] / 1e6 if sizes else None


class Published:
    """The paper's, for those of the scenes that it has."""

    def __init__(self, results: Sequence[BenchmarkResult]):
        papers = {result.scene.name: Paper(result.scene.paper) for result in results}
        self._papers = {name: paper for name, paper in papers.items() if paper.has_times or paper.has_structures}
        self.scenes: Sequence[str] = list(self._papers)

    def times(self, scene: str, mode: str, technique: str) -> Times | None:
        value = self._papers[scene].frame_ms(mode, technique)
        return Times(value) if value else None

    def megabytes(self, scene: str, kind: str) -> float | None:
        return self._papers[scene].structure(kind, "megabytes")
