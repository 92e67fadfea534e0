"""Table 2 of the study: time per frame of every technique and mode, beside the paper's, each with its error."""

from collections.abc import Sequence

from raywalk.models import BenchmarkResult, ResultRow
from raywalk.tables.machine import machine_line
from raywalk.tables.paper import PAPER_DEVICE, PAPER_FRAMES, PAPER_SIZE, Paper
from raywalk.tables.table import Cell, Column, Table

MODES = {
    "trace": "traversal alone",
    "primary": "primary rays",
    "shadow": "these and a shadow ray a light",
    "whitted": "these and secondary rays",
}
# What is 100 %, as in the paper: its BVH for primary rays, kdt-2 for the others.
BVH, KDT2 = "bvh/packet", "kdtree/short-stack-2"
BASE = {"trace": BVH, "primary": BVH, "shadow": KDT2, "whitted": KDT2}
COLUMNS = [
    Column("scene", left=True),
    Column("mode", left=True),
    Column("technique", left=True),
    Column("ms", "frame", 2),
    Column("%", "frame"),
    Column("Mrays/s", "", 2),
    Column("ids ppm", "error"),
    Column("95 % ≤", "error", 1),
    Column("RMSE", "error"),
    Column("ms", PAPER_DEVICE, 1),
    Column("%", PAPER_DEVICE),
]


def technique(row: ResultRow) -> str:
    return f"{row.structure}/{row.traversal}"


def table2(results: Sequence[BenchmarkResult]) -> Table:
    spec = results[0].spec
    table = Table(f"Table 2: mean time of a frame, {spec.width}x{spec.height}", machine_line(results), COLUMNS)
    for result in results:
        label = f"{result.scene.name} ({result.scene.fidelity})"
        for mode in MODES:
            rows = [row for row in result.rows if row.mode == mode]
            if rows:
                table.sections.add(len(table.rows))
                add_mode(table, result, label, mode, rows)
                label = ""
    table.notes = notes(results)
    return table


def add_mode(table: Table, result: BenchmarkResult, label: str, mode: str, rows: list[ResultRow]) -> None:
    paper = Paper(result.scene.paper)
    base = base_of(mode, rows).frame_ms.mean
    best = min((row for row in rows if not is_bound(row)), key=lambda row: row.frame_ms.mean, default=None)
    for number, row in enumerate(rows):
        if row is best:
            table.best.add(len(table.rows))
        name = technique(row) + (" *" if row.frame_ms.unstable else "")
        cells: list[Cell] = [label if number == 0 else "", mode if number == 0 else "", name]
        cells += [row.frame_ms.mean, percent(row.frame_ms.mean, base), row.mrays_per_s]
        cells += error_cells(row) + paper_cells(paper, mode, technique(row))
        table.rows.append(cells)


def is_bound(row: ResultRow) -> bool:
    """A bare loop only says what is possible."""
    return row.traversal.startswith("loop-")


def base_of(mode: str, rows: list[ResultRow]) -> ResultRow:
    """The row that is 100 %: the paper's choice, else the fastest."""
    named = [row for row in rows if technique(row) == BASE[mode]]
    return named[0] if named else min(rows, key=lambda row: row.frame_ms.mean)


def percent(value: float | None, base: float | None) -> str | None:
    return f"{100 * value / base:.0f}%" if value is not None and base else None


def error_cells(row: ResultRow) -> list[Cell]:
    error = row.error
    ppm = f"{error.id_mismatch_ppm:.3g}"
    rmse = None if row.mode == "trace" else f"{error.image_rmse:.2g}"
    return [ppm, error.id_mismatch_ppm_upper95, rmse]


def paper_cells(paper: Paper, mode: str, name: str) -> list[Cell]:
    value = paper.frame_ms(mode, name)
    return [value, percent(value, paper.frame_ms(mode, BASE[mode]))]


def notes(results: Sequence[BenchmarkResult]) -> list[str]:
    said = [
        f"100 % is {BVH} for primary rays and {KDT2} for the others, as in the paper (else the fastest); "
        "the fastest of each group is set off."
    ]
    modes = {row.mode for result in results for row in result.rows}
    said.append("Modes: " + "; ".join(f"{mode}: {prose}" for mode, prose in MODES.items() if mode in modes) + ".")
    references = ", ".join(sorted({row.error.reference for result in results for row in result.rows}))
    frames = ", ".join(sorted({str(row.error.frames) for result in results for row in result.rows}))
    said.append(
        f"Errors against {references} on {frames} frames: primary rays that hit another triangle (ppm, with the upper "
        "end of the 95 % interval) and RMSE of sRGB values in 0..1."
    )
    if any(Paper(result.scene.paper).has_times for result in results):
        said.append(f"{PAPER_DEVICE}: the paper's times, {PAPER_SIZE}, {PAPER_FRAMES} frames of its own walkthroughs.")
    if any(is_bound(row) for result in results for row in result.rows):
        said.append("embree/loop-1 and loop-8 are bare loops over one ray and eight: they bound what is possible.")
    if any(row.frame_ms.unstable for result in results for row in result.rows):
        said.append("* unstable: repeats of the same frame spread by more than 3.5 %.")
    for result in results:
        if result.scene.fidelity == "stand-in":
            said.append(f"{result.scene.name} is a generated stand-in with {result.scene.triangles} triangles.")
        if result.stop_reason != "completed":
            said.append(f"{result.scene.name}: measuring stopped early ({result.stop_reason}).")
        said += [f"{result.scene.name}: {note}" for note in result.notes]
    return said
