"""What tells the results of one table apart: columns that are there only when the results differ in them."""

from collections.abc import Callable, Sequence

from raywalk.models import BenchmarkResult
from raywalk.tables.table import Cell, Column


def size_of(result: BenchmarkResult) -> str:
    return f"{result.spec.width}x{result.spec.height}"


def compared_of(result: BenchmarkResult) -> int | None:
    """Frames compared with the reference; the same in every row of a result."""
    return result.rows[0].error.frames if result.rows else None


FACTS: dict[str, Callable[[BenchmarkResult], Cell]] = {
    "size": size_of,
    "frames": lambda result: result.spec.frames,
    "depth": lambda result: result.spec.depth,
    "compared": compared_of,
}


def differing(results: Sequence[BenchmarkResult], facts: Sequence[str] = tuple(FACTS)) -> list[str]:
    """The facts that are not the same in all results."""
    return [fact for fact in facts if len({FACTS[fact](result) for result in results}) > 1]


def run_columns(facts: Sequence[str]) -> list[Column]:
    return [Column(fact) for fact in facts]


def run_cells(result: BenchmarkResult, facts: Sequence[str]) -> list[Cell]:
    return [FACTS[fact](result) for fact in facts]
