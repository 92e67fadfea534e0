"""Table 3 of the study: registers, memory, occupancy and time of every GPU kernel under a sweep of register caps."""

from collections.abc import Sequence

from raywalk.errors import RaywalkError
from raywalk.gate import closed, is_open, marked, open_notes, tier_of
from raywalk.kernel_options import REGISTERS, label, register_cap
from raywalk.models import BenchmarkResult, ResultRow
from raywalk.tables import paper3
from raywalk.tables.gpu import on_gpu, telemetry_notes
from raywalk.tables.machine import machine_line
from raywalk.tables.notes2 import MODES, notes_of, technique
from raywalk.tables.paper import PAPER_DEVICE
from raywalk.tables.paper3 import PaperKernel, paper_kernel
from raywalk.tables.runs import differing, run_cells, run_columns, size_of
from raywalk.tables.table import Cell, Column, Table

COLUMNS = [
    Column("mode", left=True),
    Column("technique", left=True),
    Column("cap"),
    Column("registers"),
    Column("local B"),
    Column("shared B"),
    Column("threads", "block"),
    Column("blocks", "multiprocessor"),
    Column("occupancy %", "multiprocessor", 1),
    Column("ms", "frame", 3),
    Column("of best", "frame", optional=True),
    Column("registers", PAPER_DEVICE),
    Column("occupancy %", PAPER_DEVICE, 1),
    Column("ms", PAPER_DEVICE, 1, optional=True),
]
FACTS = ["size", "frames", "depth"]


def table3(results: Sequence[BenchmarkResult]) -> Table:
    """Throws RaywalkError when no result was measured on a GPU."""
    require_gpu(results)
    facts = differing(results, FACTS)
    title = "Table 3: kernels under register caps" + ("" if "size" in facts else f", {size_of(results[0])}")
    table = Table(title, machine_line(results), [Column("scene", left=True), *run_columns(facts), *COLUMNS])
    for result in results:
        start = [f"{result.scene.name} ({result.scene.fidelity})", *run_cells(result, facts)]
        mode = ""
        for group in groups(result):
            changes = group[0].mode != mode
            if changes or len(group) > 1:
                table.sections.add(len(table.rows))
            mode = group[0].mode
            add_group(table, result, [*start, mode if changes else ""], group)
            start = [""] * len(start)
    table.drop_empty()
    table.notes = notes(results)
    return table


def require_gpu(results: Sequence[BenchmarkResult]) -> None:
    if not on_gpu(results):
        raise RaywalkError("Table 3 is about GPU kernels, and these results were measured without a GPU")


def groups(result: BenchmarkResult) -> list[list[ResultRow]]:
    """Rows that differ in their cap alone, in its order; modes in their order, the rest as it was measured."""
    found: dict[tuple[str, str, str], list[ResultRow]] = {}
    for row in sorted(result.rows, key=lambda row: list(MODES).index(row.mode)):
        if row.kernel:
            key = (row.mode, row.structure_id, f"{label(result.spec, row, without=REGISTERS)} {tier_of(row)}")
            found.setdefault(key, []).append(row)
    return [sorted(rows, key=register_cap) for rows in found.values()]


def best_of(group: Sequence[ResultRow]) -> ResultRow | None:
    """The fastest closed one; None where there is nothing to choose from."""
    return min(closed(group), key=lambda row: row.frame_ms.median, default=None) if len(group) > 1 else None


def add_group(table: Table, result: BenchmarkResult, start: list[Cell], group: list[ResultRow]) -> None:
    best = best_of(group)
    for number, row in enumerate(group):
        if row is best:
            table.best.add(len(table.rows))
        name = marked(label(result.spec, row, without=REGISTERS), row) + (" *" if row.frame_ms.unstable else "")
        cells = start if number == 0 else [""] * len(start)
        table.rows.append([*cells, name, *kernel_cells(row), *time_cells(row, best), *paper_cells(result, row)])


def kernel_cells(row: ResultRow) -> list[Cell]:
    kernel = row.kernel
    assert kernel is not None
    cells: list[Cell] = [register_cap(row) or "none", kernel.registers, kernel.local_bytes, kernel.shared_bytes]
    return [*cells, kernel.threads_per_block, kernel.blocks_per_multiprocessor, 100 * kernel.occupancy]


def time_cells(row: ResultRow, best: ResultRow | None) -> list[Cell]:
    return [row.frame_ms.median, f"{ratio:.2f}x" if (ratio := of_best(row, best)) else None]


def of_best(row: ResultRow, best: ResultRow | None) -> float | None:
    """Time over the best cap's; None for an open row."""
    return (
        row.frame_ms.median / best.frame_ms.median if best and not is_open(row) and best.frame_ms.median > 0 else None
    )


def theirs(row: ResultRow) -> PaperKernel | None:
    return paper_kernel(technique(row), register_cap(row))


def paper_ms(result: BenchmarkResult, row: ResultRow) -> float | None:
    """The paper's time for this scene, this mode and this cap."""
    kernel = theirs(row)
    return kernel.frame_ms.get(result.scene.name) if kernel and row.mode == paper3.MODE else None


def paper_cells(result: BenchmarkResult, row: ResultRow) -> list[Cell]:
    kernel = theirs(row)
    if kernel is None:
        return [None, None, None]
    return [kernel.registers, 100 * kernel.occupancy, paper_ms(result, row)]


def notes(results: Sequence[BenchmarkResult]) -> list[str]:
    said = [
        "cap: most registers a thread that the compiler may use; none: its own choice. local: bytes a thread of stack "
        "and spills; shared: bytes a block; blocks and occupancy: resident at once, and their threads of those that a "
        "multiprocessor could hold.",
        "frame ms is the median; the fastest cap of each technique is set off, the others are told against it.",
        f"{PAPER_DEVICE}: {paper3.SOURCE}. Its kernels without a cap stand beside ours without one, those with its cap "
        "beside ours with that cap. It gives neither local nor shared memory, and times for robots, kitchen and "
        f"museum only (here mode {paper3.MODE}).",
    ]
    said += open_notes(results)
    if any(row.frame_ms.unstable for result in results for row in result.rows):
        said.append("* unstable: repeats of the same frame spread by more than 3.5 %.")
    own = [f"{result.scene.name}: {note}" for result in results for note in notes_of(result)]
    return list(dict.fromkeys(said + telemetry_notes(results) + own))
