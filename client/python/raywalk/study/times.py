"""Table 2 in the paper's form: a table for each kind of rays, techniques side by side, percentages, averages."""

import math
from collections.abc import Sequence

from raywalk.gate import OPEN, is_open, open_notes
from raywalk.models import BenchmarkResult, ResultRow
from raywalk.study.collect import Study
from raywalk.study.names import BASES, EMBREE, NAMES, RAYS, STUDIED, row_of, techniques_in
from raywalk.study.parameters import SCENES
from raywalk.tables.gpu import gpu_notes
from raywalk.tables.notes2 import error_note
from raywalk.tables.paper import PAPER_DEVICE, PAPER_FRAMES, PAPER_SIZE, Paper
from raywalk.tables.table import Cell, Column, Table

# The last line of the paper's Table 2 as printed.
PRINTED_AVERAGES = {
    "primary": (148, 181, 140, 100),
    "shadow": (141, 117, 100, 104),
    "whitted": (193, 113, 100, 142),
}
ERRORS = [
    Column("ids ppm", "worst error"),
    Column("95 % ≤", "worst error", 1),
    Column("RMSE", "worst error"),
    Column("FLIP", "worst error"),
]
NO_ERRORS: list[Cell] = [""] * len(ERRORS)
Row = dict[str, float]  # ms by technique


def time_tables(study: Study) -> list[Table]:
    """One for each mode that was measured, with what is common to all below the last."""
    modes = [mode for mode in RAYS if any(times_of(result, mode) for result in study.all_results)]
    tables = [time_table(study, mode, letter) for mode, letter in zip(modes, "abc", strict=False)]
    if tables:
        tables[-1].notes += notes(study)
    return tables


def time_table(study: Study, mode: str, letter: str) -> Table:
    """Rows: ours and the paper's for each scene, then the averages of both."""
    techniques = techniques_in(study.all_results)
    digits = 3 if study.kernels or any(row.kernel for one in study.all_results for row in one.rows) else 1
    columns = [Column("scene", left=True)]
    for technique in techniques:
        columns += [Column("ms", NAMES[technique], digits), Column("%", NAMES[technique])]
    title = f"Table 2{letter}: mean time of a frame, {RAYS[mode]}, {study.parameters.size}"
    table = Table(title, study.line, [*columns, *ERRORS])
    ours, papers = [], []
    for result in study.all_results:
        row = times_of(result, mode)
        theirs = paper_times(result, mode)
        if not row and not theirs:
            continue
        table.sections.add(len(table.rows))
        counted = closed_times_of(result, mode)
        mark_best(table, counted, techniques)
        name = f"{result.scene.name} ({result.scene.fidelity})"
        table.rows.append([name, *our_cells(row, counted, mode, techniques), *worst(result, mode)])
        ours.append(counted)
        if theirs:
            papers.append(theirs)
            table.rows.append(["  paper", *cells(theirs, mode, techniques), *NO_ERRORS])
    table.sections.add(len(table.rows))
    add_averages(table, mode, techniques, ours, papers)
    return table


def add_averages(table: Table, mode: str, techniques: Sequence[str], ours: list[Row], papers: list[Row]) -> None:
    def line(name: str, percents: dict[str, float | int | None]) -> None:
        shown = [cell for one in techniques for cell in ("", percent_text(percents.get(one)))]
        table.rows.append([name, *shown, *NO_ERRORS])

    line("average", averages(ours, mode, techniques))
    if papers:
        whole = len(papers) == len(SCENES)
        line("  paper" if whole else "  paper, these scenes", averages(papers, mode, STUDIED))
        line("  paper, all nine as printed", dict(zip(STUDIED, PRINTED_AVERAGES[mode], strict=True)))


def times_of(result: BenchmarkResult, mode: str) -> Row:
    rows = {technique: row_of(result, mode, technique) for technique in NAMES}
    return {technique: row.frame_ms.mean for technique, row in rows.items() if row}


def closed_times_of(result: BenchmarkResult, mode: str) -> Row:
    """Those that may be compared."""
    rows = {technique: row_of(result, mode, technique) for technique in NAMES}
    return {technique: row.frame_ms.mean for technique, row in rows.items() if row and not is_open(row)}


def our_cells(row: Row, counted: Row, mode: str, techniques: Sequence[str]) -> list[Cell]:
    """An open row has its time, marked, and no share."""
    shown = cells(counted, mode, techniques)
    for number, technique in enumerate(techniques):
        if technique in row and technique not in counted:
            shown[2 * number] = f"{row[technique]:.1f} {OPEN}"
    return shown


def paper_times(result: BenchmarkResult, mode: str) -> Row:
    paper = Paper(result.scene.paper)
    times = {technique: paper.frame_ms(mode, technique) for technique in STUDIED}
    return {technique: value for technique, value in times.items() if value is not None}


def percents(row: Row, mode: str) -> dict[str, float]:
    """Each time relative to the paper's choice of what is 100 %; nothing where that was not measured."""
    base = row.get(BASES[mode])
    return {technique: 100 * value / base for technique, value in row.items()} if base else {}


def averages(rows: Sequence[Row], mode: str, techniques: Sequence[str]) -> dict[str, float | int | None]:
    """The mean of the scenes' percentages, over the scenes that have all of the study's techniques measured, as the
    paper does it: its conference room, whose kd-trees lacked memory, is not in its last average."""
    full = [percents(row, mode) for row in rows if all(technique in row for technique in STUDIED)]
    shown: dict[str, float | int | None] = {}
    for technique in techniques:
        values = [row[technique] for row in full if technique in row]
        shown[technique] = sum(values) / len(values) if values else None
    return shown


def percent_text(value: float | None) -> str | None:
    """Rounded half up, as the paper does it."""
    return None if value is None else f"{math.floor(value + 0.5)}%"


def cells(row: Row, mode: str, techniques: Sequence[str]) -> list[Cell]:
    shares = percents(row, mode)
    return [cell for one in techniques for cell in (row.get(one), percent_text(shares.get(one)))]


def mark_best(table: Table, row: Row, techniques: Sequence[str]) -> None:
    """Embree, which is no part of the comparison, cannot be the best."""
    own = [technique for technique in techniques if technique in row and technique != EMBREE]
    if own:
        column = 1 + 2 * techniques.index(min(own, key=lambda one: row[one]))
        table.best_cells |= {(len(table.rows), column), (len(table.rows), column + 1)}


def worst(result: BenchmarkResult, mode: str) -> list[Cell]:
    """The largest error figures of our techniques."""
    rows = [row for row in result.rows if row.mode == mode and row.structure != "embree"]
    if not rows:
        return [None] * len(ERRORS)
    most: ResultRow = max(rows, key=lambda row: row.error.id_mismatch_ppm_upper95)
    rmse = max(row.error.image_rmse for row in rows)
    flips = [row.error.image_flip_mean for row in rows if row.error.image_flip_mean is not None]
    flip = f"{max(flips):.2g}" if flips else None  # older results have none
    return [f"{most.error.id_mismatch_ppm:.3g}", most.error.id_mismatch_ppm_upper95, f"{rmse:.2g}", flip]


def notes(study: Study) -> list[str]:
    said = [
        "100 % is the packet BVH for primary rays and kdt-2 for the others, as in the paper; the fastest of each row "
        "is set off, Embree apart.",
        "average: mean of the percentages over the scenes with all four of the paper's techniques. From the paper's "
        "printed times its own last lines come out to within 1: it prints 181, 193, 142 where they give 180.5, 192.5 "
        "and 141.5, which rounding of its times to 0.1 ms explains.",
        f"paper: {PAPER_DEVICE}, {PAPER_SIZE}, {PAPER_FRAMES} frames of its own walkthroughs.",
    ]
    results = study.all_results
    said += error_note(results) + open_notes(results)
    short = [result.scene.name for result in results if result.stop_reason != "completed"]
    if short:
        said.append(f"measuring stopped at the time limit, with fewer frames: {', '.join(short)}.")
    return said + gpu_notes(results)
