"""Tables of accuracy: the hard cases by technique, and a sweep's techniques and knobs by class of rays."""

from collections.abc import Sequence

from raywalk.accuracy.points import CLASSES, Point, knobs_text, pareto, point_of, points_of, rounded, setting_text
from raywalk.models import AccuracyResult, HardCase, SweepRow
from raywalk.tables.machine import describe
from raywalk.tables.table import Cell, Column, Table

GOAL_INVALID = 1.1  # of a valid ray's time


def machine_line(result: AccuracyResult) -> str:
    return f"{describe(result.machine)}, {result.created_at[:10]}"


def cases_table(result: AccuracyResult) -> Table:
    """One row a technique with its knobs; strict ones must pass."""
    columns = [Column("technique", left=True), Column("knobs", left=True), Column("passed"), Column("of")]
    columns += [Column("rays"), Column("failed", left=True)]
    table = Table("Hard cases", machine_line(result), columns)
    broken = 0
    for (technique, knobs), cases in by_technique(result.cases).items():
        ran = [case for case in cases if case.why_not is None]
        failed = [case for case in ran if case.failures]
        broken += sum(case.strict for case in failed)
        numbers = ", ".join(str(case.number) for case in failed) or "none"
        rays = sum(case.rays for case in ran)
        table.rows.append([technique, knobs, len(ran) - len(failed), len(ran), rays, numbers])
    table.notes.append(
        "every strict technique passes every case that is about it"
        if not broken
        else f"{broken} failures of strict techniques: each is a defect; accuracy.json has the first ray of each"
    )
    table.notes.append("of other knobs a failure is a figure: what their speed costs")
    return table


def by_technique(cases: Sequence[HardCase]) -> dict[tuple[str, str], list[HardCase]]:
    found: dict[tuple[str, str], list[HardCase]] = {}
    for case in cases:
        key = (f"{case.structure}/{case.traversal}", setting_text(case.knobs, case.strict))
        found.setdefault(key, []).append(case)
    return found


def sweep_table(result: AccuracyResult, brief: bool = False) -> Table:
    """Two columns a class: Mrays/s, and wrong rays in ppm with the upper end of the 95 % interval. `brief` leaves out
    what is neither strict nor among the fastest for its error in any class."""
    classes = [name for name in CLASSES if any(row.class_ == name for row in result.rows)]
    columns = [Column("technique", left=True), Column("knobs", left=True), Column("B/tri", digits=0)]
    for name in classes:
        columns += [Column("Mrays/s", name, 2), Column("wrong ppm", name)]
    columns.append(Column("p99.9", "t ulp", 2))
    scene = result.scene.name if result.scene else ""
    table = Table(f"Speed against error: {scene}", machine_line(result), columns)
    fronts = fronts_of(result)
    for key, rows in rows_by_combination(result.rows).items():
        first = next(iter(rows.values()))
        if brief and not first.strict and not any(key in front for front in fronts.values()):
            continue
        place = len(table.rows)
        cells: list[Cell] = [f"{first.structure}/{first.traversal}", setting_text(first.knobs, first.strict)]
        cells.append(first.bytes_per_triangle)
        for name in classes:
            row = rows.get(name)
            cells += [None, None] if row is None else [row.mrays_per_s, point_of(row).error_text]
            if row is not None and key in fronts[name]:
                table.best_cells |= {(place, len(cells) - 2), (place, len(cells) - 1)}
        errors = [row.error.t_ulps.well_conditioned for row in rows.values() if row.error.t_ulps.well_conditioned.hits]
        known = [one.p999 for one in errors if one.p999 is not None]
        cells.append(max(known) if known and len(known) == len(errors) else None)
        table.rows.append(cells)
    table.notes = notes_of(result)
    return table


Key = tuple[str, str, str]


def key_of(row: SweepRow) -> Key:
    return row.structure, row.traversal, knobs_text(row.knobs)


def id_of(point: Point) -> Key:
    return point.structure, point.traversal, knobs_text(point.knobs)


def rows_by_combination(rows: Sequence[SweepRow]) -> dict[Key, dict[str, SweepRow]]:
    found: dict[Key, dict[str, SweepRow]] = {}
    for row in rows:
        found.setdefault(key_of(row), {})[row.class_] = row
    return found


def fronts_of(result: AccuracyResult) -> dict[str, set[Key]]:
    return {name: {id_of(one) for one in pareto(points)} for name, points in points_of(result).items()}


def brute_text(rows: Sequence[SweepRow], *, strict: bool) -> str:
    """Empty when none of these were compared."""
    compared = [row.error.brute_mismatches for row in rows if row.strict is strict and row.error.brute_mismatches]
    count, of = sum(one.count for one in compared), sum(one.of for one in compared)
    return f"{count} of {of:,} {'strict answers' if strict else 'others'}" if compared else ""


def notes_of(result: AccuracyResult) -> list[str]:
    rows = result.rows
    notes = ["bold: nothing else is faster and less wrong; in brackets the upper end of the 95 % interval"]
    notes.append("t ulp: error of well-conditioned distances, 99.9 % of them, in the worst class")
    notes.append("wrong: leaks, false misses and hits, wrong ids, double hits, self-hits and NaN, by exact arithmetic")
    told = [text for text in (brute_text(rows, strict=True), brute_text(rows, strict=False)) if text]
    if told:
        notes.append(f"differ from brute force by the same triangle test: {', '.join(told)}")
    if result.invalid_costs:
        worst = max(result.invalid_costs, key=lambda one: one.ratio)
        over = "within" if worst.ratio <= GOAL_INVALID else "over"
        name = f"{worst.structure}/{worst.traversal}"
        text = f"an invalid ray takes at most {worst.ratio:.2f}x the time of a valid miss ({name})"
        notes.append(f"{text}, {over} the goal of {GOAL_INVALID}x")
    double = sum(row.error.double_hits.count for row in rows if row.strict and row.error.double_hits)
    leaks = sum(row.error.leaks.count for row in rows if row.strict)
    strict = sum(row.error.judged for row in rows if row.strict)
    if strict:
        bound = rounded(max(row.error.wrong.ppm_upper95 for row in rows if row.strict))
        text = f"strict: {leaks} leaks and {double} double hits in {strict:,} rays"
        notes.append(f"{text}; wrong in no class more often than {bound} ppm (95 %)")
    return notes + result.notes
