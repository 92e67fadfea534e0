"""Results read from files, tables written to files."""

from collections.abc import Iterable
from pathlib import Path

from pydantic import ValidationError

from raywalk.errors import RaywalkError
from raywalk.models import BenchmarkResult
from raywalk.tables.table import Table, csv_text, markdown

WRITERS = {"md": markdown, "csv": csv_text}


def read_results(paths: Iterable[Path]) -> list[BenchmarkResult]:
    """Benchmark results as `raywalk bench --out` writes them."""
    return [read_result(path) for path in paths]


def read_result(path: Path) -> BenchmarkResult:
    try:
        return BenchmarkResult.model_validate_json(path.read_bytes())
    except OSError as error:
        raise RaywalkError(f"{path} cannot be read: {error.strerror or error}") from error
    except ValidationError as error:
        first = error.errors()[0]
        where = "/".join(str(step) for step in first["loc"])
        raise RaywalkError(f"{path} is no benchmark result: /{where}: {first['msg']}") from error


def result_json(result: BenchmarkResult) -> str:
    return result.model_dump_json(indent=1, exclude_none=False) + "\n"


def write_tables(tables: dict[int, Table], folder: Path, form: str) -> list[Path]:
    """Writes table1.md and so on (or .csv)."""
    written = []
    for number, table in tables.items():
        path = folder / f"table{number}.{form}"
        path.write_text(WRITERS[form](table))
        written.append(path)
    return written
