"""Table 2 of the study: time per frame of every technique and mode, beside the paper's, each with its error."""

from collections.abc import Sequence
from dataclasses import replace

from raywalk.gate import closed, is_open, marked, tier_of, word_of
from raywalk.kernel_options import label as name_of
from raywalk.models import BenchmarkResult, ResultRow
from raywalk.tables.gpu import faster_cell, on_gpu, throughput_cells, throughput_columns
from raywalk.tables.machine import machine_line
from raywalk.tables.notes2 import BASE, MODES, is_bound, notes, technique
from raywalk.tables.paper import PAPER_DEVICE, Paper
from raywalk.tables.runs import differing, run_cells, run_columns, size_of
from raywalk.tables.table import Cell, Column, Table

SINGLE = [
    Column("mode", left=True),
    Column("technique", left=True),
    Column("tier", left=True, optional=True),
    Column("ms", "frame", 2),
    Column("%", "frame"),
    Column("Mrays/s", "", 2),
]
ERRORS = [
    Column("gate", left=True, optional=True),
    Column("wrong ppm", "error", optional=True),
    Column("ids ppm", "error"),
    Column("95 % ≤", "error", 1),
    Column("RMSE", "error"),
    Column("FLIP", "error", optional=True),  # older results have none
]
PAPERS = [Column("ms", PAPER_DEVICE, 1), Column("%", PAPER_DEVICE)]
FASTER = Column("faster", PAPER_DEVICE, optional=True)
GPU_DIGITS = 3  # of a time on a GPU, which is far below a millisecond


def columns(results: Sequence[BenchmarkResult]) -> list[Column]:
    """All; those that nobody fills are dropped in the end."""
    gpu = on_gpu(results)
    single = [replace(column, digits=GPU_DIGITS) if gpu and column.name == "ms" else column for column in SINGLE]
    return [*single, *throughput_columns(results), *ERRORS, *PAPERS, FASTER]


def table2(results: Sequence[BenchmarkResult]) -> Table:
    facts = differing(results)
    title = "Table 2: mean time of a frame" + ("" if "size" in facts else f", {size_of(results[0])}")
    table = Table(title, machine_line(results), [Column("scene", left=True), *run_columns(facts), *columns(results)])
    for result in results:
        label: list[Cell] = [f"{result.scene.name} ({result.scene.fidelity})", *run_cells(result, facts)]
        for mode in MODES:
            rows = [row for row in result.rows if row.mode == mode]
            if rows:
                table.sections.add(len(table.rows))
                add_mode(table, result, label, mode, rows)
                label = [""] * len(label)
    table.drop_empty()
    table.notes = notes(results)
    return table


def add_mode(table: Table, result: BenchmarkResult, label: list[Cell], mode: str, rows: list[ResultRow]) -> None:
    paper = Paper(result.scene.paper)
    base = base_ms(mode, rows)
    best = min((row for row in closed(rows) if not is_bound(row)), key=lambda row: row.frame_ms.mean, default=None)
    for number, row in enumerate(rows):
        if row is best:
            table.best.add(len(table.rows))
        name = marked(name_of(result.spec, row), row) + (" *" if row.frame_ms.unstable else "")
        cells = [*label, mode, name] if number == 0 else [*[""] * len(label), "", name]
        share = None if is_open(row) else percent(row.frame_ms.mean, base)
        cells += [tier_of(row), row.frame_ms.mean, share, row.mrays_per_s]
        cells += throughput_cells(row) + error_cells(row)
        cells += [*paper_cells(paper, mode, technique(row)), faster_cell(result, row)]
        table.rows.append(cells)


def base_ms(mode: str, rows: list[ResultRow]) -> float | None:
    """The time that is 100 %: of the paper's choice, else of the fastest; None when every row is open."""
    counted = closed(rows)
    named = [row for row in counted if technique(row) == BASE[mode]]
    return min((row.frame_ms.mean for row in named[:1] or counted), default=None)


def percent(value: float | None, base: float | None) -> str | None:
    return f"{100 * value / base:.0f}%" if value is not None and base else None


def error_cells(row: ResultRow) -> list[Cell]:
    error = row.error
    ppm = f"{error.id_mismatch_ppm:.3g}"
    rmse = None if row.mode == "trace" else f"{error.image_rmse:.2g}"
    flip = None if error.image_flip_mean is None else f"{error.image_flip_mean:.2g}"
    wrong = f"{row.gate.wrong_ppm:.3g}" if row.gate else None
    return [word_of(row), wrong, ppm, error.id_mismatch_ppm_upper95, rmse, flip]


def paper_cells(paper: Paper, mode: str, name: str) -> list[Cell]:
    value = paper.frame_ms(mode, name)
    return [value, percent(value, paper.frame_ms(mode, BASE[mode]))]
