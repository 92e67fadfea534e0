"""The gate of a row: an open row is shown with its time, but nothing is concluded from it."""

from collections.abc import Callable, Iterable, Sequence

from raywalk.models import BenchmarkResult, ResultRow

OPEN, CLOSED = "OPEN", "closed"


def is_open(row: ResultRow) -> bool:
    """Not right enough for its tier. Results of older daemons have no gate and count as closed."""
    return row.gate is not None and row.gate.status == "open"


def closed(rows: Iterable[ResultRow]) -> list[ResultRow]:
    return [row for row in rows if not is_open(row)]


def tier_of(row: ResultRow) -> str | None:
    return row.gate.tier if row.gate else None


def word_of(row: ResultRow) -> str | None:
    """The cell of a table; None where there is no gate."""
    return None if row.gate is None else OPEN if is_open(row) else CLOSED


def marked(name: str, row: ResultRow) -> str:
    """A technique's name in a table."""
    return f"{name} ({OPEN})" if is_open(row) else name


def told(rows: Sequence[ResultRow]) -> str:
    """Techniques with their tiers, each with its modes."""
    modes: dict[str, list[str]] = {}
    for row in rows:
        name = f"{row.structure}/{row.traversal}" + (f" {tier_of(row)}" if tier_of(row) else "")
        modes.setdefault(name, []).append(row.mode)
    return ", ".join(f"{name} ({' '.join(dict.fromkeys(found))})" for name, found in modes.items())


def grouped(rows: Iterable[ResultRow], why: Callable[[ResultRow], str | None]) -> list[str]:
    """The rows that have a reason, told together where it is the same."""
    reasons: dict[str, list[ResultRow]] = {}
    for row in rows:
        if reason := why(row):
            reasons.setdefault(reason, []).append(row)
    return [f"{told(same)}: {reason}" for reason, same in reasons.items()]


def open_notes(results: Sequence[BenchmarkResult]) -> list[str]:
    """How many rows are open, and why each is."""
    said = []
    for result in results:
        rows = [row for row in result.rows if is_open(row)]
        if rows:
            count = f"{len(rows)} of {len(result.rows)} rows {'is' if len(rows) == 1 else 'are'} open"
            why = "; ".join(grouped(rows, lambda row: row.gate and row.gate.reason.removesuffix(".")))
            said.append(f"{result.scene.name}: {count}, in no comparison: {why}.")
    return said


def choice_notes(results: Sequence[BenchmarkResult]) -> list[str]:
    """What tier auto chose, and why."""
    return [
        f"{result.scene.name}: {one}"
        for result in results
        for one in grouped(result.rows, lambda row: row.gate and row.gate.choice and row.gate.choice.reason)
    ]


def gate_notes(results: Sequence[BenchmarkResult]) -> list[str]:
    if not any(row.gate for result in results for row in result.rows):
        return []
    said = [
        "gate: closed when the wrong rays (of primary and sampled shadow rays, judged in exact arithmetic where "
        "technique and reference disagree) are within the tier's limit, strict and auto 0, fast 1 ppm; techniques "
        "without knobs have no tier and no limit."
    ]
    return said + open_notes(results) + choice_notes(results)
