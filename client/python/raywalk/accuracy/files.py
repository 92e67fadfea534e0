"""What a measurement of accuracy leaves behind: everything as JSON, tables, charts."""

import csv
import io
import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from raywalk.accuracy.chart import chart
from raywalk.accuracy.drawing import png_of, svg_of
from raywalk.accuracy.tables import cases_table, machine_line, sweep_table
from raywalk.models import AccuracyResult
from raywalk.tables.table import Table, markdown

ALL = "accuracy.json"


def write_accuracy(results: Sequence[AccuracyResult], folder: Path) -> list[str]:
    """The names of what was written."""
    written: list[str] = []

    def write(name: str, content: str | bytes) -> None:
        (folder / name).write_bytes(content.encode() if isinstance(content, str) else content)
        written.append(name)

    write(ALL, json.dumps([plain(result) for result in results], indent=1) + "\n")
    for result in results:
        if result.cases:
            write("hard-cases.md", markdown(cases_table(result)))
            write("hard-cases.csv", csv_of(cases_table(result)))
        written += write_sweep(result, folder)
    return written


def write_sweep(result: AccuracyResult, folder: Path) -> list[str]:
    """The tables and charts of one scene, and their names; nothing where nothing was measured."""
    if not result.scene or not result.rows:
        return []
    name = result.scene.name
    drawing = chart(result, machine_line(result))
    contents = {
        f"sweep-{name}.md": markdown(sweep_table(result)).encode(),
        f"sweep-{name}.csv": sweep_csv(result).encode(),
    }
    contents |= {f"speed-error-{name}.svg": svg_of(drawing).encode(), f"speed-error-{name}.png": png_of(drawing)}
    for file, content in contents.items():
        (folder / file).write_bytes(content)
    return list(contents)


def plain(result: AccuracyResult) -> dict[str, Any]:
    return result.model_dump(mode="json", by_alias=True)


def csv_of(table: Table) -> str:
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow([column.title for column in table.columns])
    writer.writerows(table.rows)
    return out.getvalue()


def sweep_csv(result: AccuracyResult) -> str:
    """A record a row, with every figure."""
    records = [record_of(row.model_dump(mode="json", by_alias=True)) for row in result.rows]
    out = io.StringIO()
    writer = csv.DictWriter(
        out, list(dict.fromkeys(name for record in records for name in record)), lineterminator="\n"
    )
    writer.writeheader()
    writer.writerows(records)
    return out.getvalue()


def record_of(value: dict[str, Any], before: str = "") -> dict[str, Any]:
    """Nested figures as columns: error_leaks_ppm and so on."""
    record: dict[str, Any] = {}
    for name, one in value.items():
        record |= record_of(one, f"{before}{name}_") if isinstance(one, dict) else {f"{before}{name}": one}
    return record
