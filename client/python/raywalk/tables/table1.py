"""Table 1 of the study: each scene's structures, ours above the paper's."""

from collections.abc import Sequence

from raywalk.models import BenchmarkResult, ResultRow, Structure
from raywalk.tables.differences import differences
from raywalk.tables.machine import machine_line
from raywalk.tables.paper import Paper
from raywalk.tables.table import Cell, Column, Table

# The paper's traversal of each structure comes first: its steps and tests stand in the table.
TRAVERSALS = {
    "grid": ["dda"],
    "kdtree": ["short-stack-3", "short-stack-2"],
    "bvh": ["packet", "while-while"],
}
FIGURES = {
    "grid": ["size", "references_per_triangle", "megabytes", "steps", "tests"],
    "kdtree": ["leaves", "references_per_triangle", "megabytes", "steps", "tests"],
    "bvh": ["leaves", "megabytes", "steps", "tests"],
}
HEADINGS = {
    "size": ("cells", None),
    "leaves": ("leaves 10³", 1),
    "references_per_triangle": ("#refs", 2),
    "megabytes": ("MB", 2),
    "steps": ("steps", 1),
    "tests": ("tests", 1),
}
KIND_NAMES = {"grid": "grid", "kdtree": "kd-tree", "bvh": "BVH"}


def columns() -> list[Column]:
    made = [Column("scene", left=True), Column("triangles"), Column("lights")]
    for kind, figures in FIGURES.items():
        made += [Column(HEADINGS[figure][0], KIND_NAMES[kind], HEADINGS[figure][1]) for figure in figures]
    return made


def table1(results: Sequence[BenchmarkResult]) -> Table:
    table = Table("Table 1: the structures, ours above the paper's", machine_line(results), columns())
    for result in results:
        table.sections.add(len(table.rows))
        table.rows.append(our_row(result))
        if Paper(result.scene.paper).has_structures:
            table.rows.append(paper_row(result))
    table.notes = notes(results)
    return table


def our_row(result: BenchmarkResult) -> list[Cell]:
    scene = result.scene
    cells: list[Cell] = [f"{scene.name} ({scene.fidelity})", scene.triangles, scene.lights]
    for kind, figures in FIGURES.items():
        cells += [our_figure(result, kind, figure) for figure in figures]
    return cells


def paper_row(result: BenchmarkResult) -> list[Cell]:
    paper = Paper(result.scene.paper)
    cells: list[Cell] = ["  paper", paper.triangles, paper.lights]
    for kind, figures in FIGURES.items():
        for figure in figures:
            value = paper.structure(kind, figure)
            cells.append(cells_text(value) if figure == "size" else thousands(value) if figure == "leaves" else value)
    return cells


def our_figure(result: BenchmarkResult, kind: str, figure: str) -> Cell:
    if figure in ("steps", "tests"):
        row = counted_row(result, kind)
        return (row.steps_per_ray if figure == "steps" else row.tests_per_ray) if row else None
    structure = structure_of(result, kind)
    if structure is None:
        return None
    match figure:
        case "size":
            return cells_text(structure.resolution)
        case "leaves":
            return thousands(structure.leaves)
        case "megabytes":
            return structure.size_bytes / 1e6 if structure.size_bytes is not None else None
        case _:
            return structure.references_per_triangle


def structure_of(result: BenchmarkResult, kind: str) -> Structure | None:
    """The first structure of the kind."""
    return next((structure for structure in result.structures if structure.kind == kind), None)


def counted_row(result: BenchmarkResult, kind: str) -> ResultRow | None:
    """The row whose counts stand in the table: the paper's traversal, primary rays when they were measured."""
    rows = [row for row in result.rows if row.structure == kind and row.steps_per_ray is not None]
    order = TRAVERSALS[kind]
    rows.sort(key=lambda row: (order.index(row.traversal) if row.traversal in order else 99, row.mode != "primary"))
    return rows[0] if rows else None


def cells_text(resolution: Sequence[int] | None) -> str | None:
    return "x".join(str(count) for count in resolution) if resolution else None


def thousands(count: float | None) -> float | None:
    return count / 1000 if count is not None else None


def notes(results: Sequence[BenchmarkResult]) -> list[str]:
    said = [
        "#refs is references per triangle, MB is 10⁶ bytes of the whole structure, steps and tests are a ray's mean."
    ]
    counted = {}
    for result in results:
        for kind in FIGURES:
            if row := counted_row(result, kind):
                counted[f"{row.structure}/{row.traversal}"] = row.mode
    if counted:
        modes = ", ".join(sorted(set(counted.values())))
        said.append(
            f"Steps and tests: {', '.join(counted)}, rays of mode {modes}; the paper counts primary and secondary rays."
        )
    for result in results:
        scene = result.scene
        if scene.fidelity == "stand-in":
            said.append(
                f"{scene.name} is a generated stand-in with {scene.triangles} triangles: its figures show the method, "
                "not the paper's object."
            )
        said += differences(result)
    return said
