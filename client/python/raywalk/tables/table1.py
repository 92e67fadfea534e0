"""Table 1 of the study: each scene's structures, ours above the paper's."""

from collections.abc import Sequence

from raywalk.models import BenchmarkResult, ResultRow, Structure
from raywalk.tables.differences import differences
from raywalk.tables.machine import machine_line
from raywalk.tables.paper import PAPER_FRAMES, PAPER_SIZE, Paper
from raywalk.tables.runs import differing, run_cells, run_columns, size_of
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
PAPER_RUN: dict[str, Cell] = {"size": PAPER_SIZE, "frames": PAPER_FRAMES}
KIND_NAMES = {"grid": "grid", "kdtree": "kd-tree", "bvh": "BVH"}


def columns(facts: Sequence[str], with_rays: bool) -> list[Column]:
    made = [Column("scene", left=True), *run_columns(facts)]
    made += [Column("rays", left=True)] if with_rays else []
    made += [Column("triangles"), Column("lights")]
    for kind, figures in FIGURES.items():
        made += [Column(HEADINGS[figure][0], KIND_NAMES[kind], HEADINGS[figure][1]) for figure in figures]
    return made


def table1(results: Sequence[BenchmarkResult]) -> Table:
    facts = differing(results, ["size", "frames"])
    with_rays = len({counted_modes(result) for result in results}) > 1
    table = Table("Table 1: the structures, ours above the paper's", machine_line(results), columns(facts, with_rays))
    for result in results:
        table.sections.add(len(table.rows))
        table.rows.append(our_row(result, facts, with_rays))
        if Paper(result.scene.paper).has_structures:
            table.rows.append(paper_row(result, facts, with_rays))
    table.notes = notes(results)
    return table


def our_row(result: BenchmarkResult, facts: Sequence[str], with_rays: bool) -> list[Cell]:
    scene = result.scene
    cells: list[Cell] = [f"{scene.name} ({scene.fidelity})", *run_cells(result, facts)]
    cells += [counted_modes(result) or None] if with_rays else []
    cells += [scene.triangles, scene.lights]
    for kind, figures in FIGURES.items():
        cells += [our_figure(result, kind, figure) for figure in figures]
    return cells


def paper_row(result: BenchmarkResult, facts: Sequence[str], with_rays: bool) -> list[Cell]:
    paper = Paper(result.scene.paper)
    cells: list[Cell] = ["  paper", *(PAPER_RUN[fact] for fact in facts)]
    cells += ["all"] if with_rays else []
    cells += [paper.triangles, paper.lights]
    for kind, figures in FIGURES.items():
        cells += [paper_figure(paper, kind, figure) for figure in figures]
    return cells


def paper_figure(paper: Paper, kind: str, figure: str) -> Cell:
    value = paper.structure(kind, figure)
    return cells_text(value) if figure == "size" else thousands(value) if figure == "leaves" else value


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


def counted_rows(result: BenchmarkResult) -> list[ResultRow]:
    return [row for kind in FIGURES if (row := counted_row(result, kind))]


def counted_modes(result: BenchmarkResult) -> str:
    """The modes whose rays were counted; more than one only when structures were measured in different ones."""
    return ", ".join(sorted({row.mode for row in counted_rows(result)}))


def counted_text(result: BenchmarkResult) -> str:
    """What was counted, as a clause; empty when nothing was."""
    names = ", ".join(f"{row.structure}/{row.traversal}" for row in counted_rows(result))
    return f"{names}, rays of mode {counted_modes(result)}" if names else ""


def counted_note(results: Sequence[BenchmarkResult]) -> list[str]:
    """One clause when all results counted the same, else one a result."""
    said = [counted_text(result) for result in results]
    if len(set(said)) > 1:
        pairs = zip(results, said, strict=True)
        clauses = [f"{result.scene.name} {size_of(result)}: {text or 'none'}" for result, text in pairs]
        said = ["; ".join(clauses)]
    return [f"Steps and tests: {said[0]}; the paper counts primary and secondary rays."] if said[0] else []


def cells_text(resolution: Sequence[int] | None) -> str | None:
    return "x".join(str(count) for count in resolution) if resolution else None


def thousands(count: float | None) -> float | None:
    return count / 1000 if count is not None else None


def notes(results: Sequence[BenchmarkResult]) -> list[str]:
    said = [
        "#refs is references per triangle, MB is 10⁶ bytes of the whole structure, steps and tests are a ray's mean."
    ]
    said += counted_note(results)
    for result in results:
        scene = result.scene
        if scene.fidelity == "stand-in":  # why its figures differ needs no other reason
            said.append(
                f"{scene.name} is a generated stand-in with {scene.triangles} triangles: its figures show the method, "
                "not the paper's object."
            )
            continue
        said += differences(result, {row.structure: row for row in counted_rows(result)})
    return list(dict.fromkeys(said))
