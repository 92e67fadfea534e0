"""Results read from files, tables written to files."""

from collections.abc import Iterable, Sequence
from pathlib import Path

from pydantic import ValidationError

from raywalk.errors import RaywalkError
from raywalk.models import BenchmarkResult
from raywalk.tables.gpu import on_gpu
from raywalk.tables.records import csv_text, records1, records2
from raywalk.tables.records3 import records3
from raywalk.tables.table import markdown
from raywalk.tables.table1 import table1
from raywalk.tables.table2 import table2
from raywalk.tables.table3 import require_gpu, table3

TABLES = {1: table1, 2: table2, 3: table3}
RECORDS = {1: records1, 2: records2, 3: records3}


def tables_of(results: Sequence[BenchmarkResult]) -> list[int]:
    """The tables that these results can fill: the third is about GPU kernels."""
    return [number for number in TABLES if number != 3 or on_gpu(results)]


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


def table_text(number: int, results: Sequence[BenchmarkResult], form: str) -> str:
    """A table as `md` for people or `csv` for programs. Throws RaywalkError for Table 3 without a GPU."""
    if number == 3:
        require_gpu(results)
    return csv_text(RECORDS[number](results)) if form == "csv" else markdown(TABLES[number](results))


def write_tables(numbers: Iterable[int], results: Sequence[BenchmarkResult], folder: Path, form: str) -> list[Path]:
    """Writes table1.md and so on (or .csv)."""
    written = []
    for number in numbers:
        path = folder / f"table{number}.{form}"
        path.write_text(table_text(number, results, form))
        written.append(path)
    return written
