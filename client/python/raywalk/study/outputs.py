"""Everything that a study writes beside its steps: tables, figures, findings, the report."""

from collections.abc import Sequence
from pathlib import Path

from raywalk.accuracy.files import write_sweep
from raywalk.study.charts import line_chart, resolution_points
from raywalk.study.collect import Study
from raywalk.study.findings import findings_markdown
from raywalk.study.latex import latex
from raywalk.study.parameters import IMAGE_FIGURES, RESOLUTION_FIGURES
from raywalk.study.pictures import montage
from raywalk.study.report import report_html, resolution_title
from raywalk.study.store import write_atomic
from raywalk.study.structures import kernel_table, structure_table
from raywalk.study.times import time_tables
from raywalk.tables.files import RECORDS
from raywalk.tables.records import Record, csv_text, key_of
from raywalk.tables.table import Table, markdown

IMAGE_TITLES = {3: "Figure 3: scanned objects", 4: "Figure 4: BART scenes", 5: "Figure 5: architectural scenes"}
REPORT, FINDINGS = "report.html", "FINDINGS.md"


def tables_of(study: Study) -> dict[int, list[Table]]:
    """The study's tables by the paper's numbers; those without a result are missing."""
    tables: dict[int, list[Table]] = {}
    if study.results:
        tables = {1: [structure_table(study)], 2: time_tables(study)}
    return tables | ({3: [kernel_table(study)]} if study.kernels else {})


def write_all(study: Study, folder: Path) -> list[str]:
    """The names of what was written. Files of an earlier state of the study are replaced."""
    written: list[str] = []

    def write(name: str, text: str) -> None:
        write_atomic(folder / name, text.encode())
        written.append(name)

    for number, tables in tables_of(study).items():
        results = study.kernels if number == 3 else study.all_results
        write(f"table{number}.md", "\n".join(markdown(table) for table in tables))
        write(f"table{number}.tex", "\n".join(latex(table) for table in tables))
        write(f"table{number}.csv", csv_text(RECORDS[number](results)))
    for number, scene in RESOLUTION_FIGURES.items():
        if scene in study.resolutions:
            write(f"figure{number}.svg", line_chart(study.resolutions[scene], resolution_title(study, number), True))
            write(f"figure{number}.csv", csv_text(resolution_records(study, scene)))
    for result in study.accuracy.values():
        written += write_sweep(result, folder)
    for number, names in IMAGE_FIGURES.items():
        if any(name in study.pictures for name in names):
            montage(study, names, IMAGE_TITLES[number], folder / f"figure{number}.png")
            written.append(f"figure{number}.png")
    write(FINDINGS, findings_markdown(study))
    write(REPORT, report_html(study))
    return written


def resolution_records(study: Study, scene: str) -> list[Record]:
    """A record for each technique and size."""
    results: Sequence = study.resolutions[scene]
    key = {name: value for name, value in key_of(results[0]).items() if name in ("scene", "fidelity")}
    mode = (results[0].spec.modes or ["primary"])[-1]
    return [
        key
        | {"mode": mode, "technique": technique, "width_px": width, "height_px": height}
        | {"frame_median_ms": median, "frame_min_ms": low, "frame_max_ms": high}
        for technique, points in resolution_points(results).items()
        for width, height, median, low, high in points
    ]
