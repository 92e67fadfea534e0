"""What the project promises of speed, as ratios within one result."""

from raywalk.gate import closed, tier_of
from raywalk.models import BenchmarkResult, ResultRow

LOOPS = ("embree/loop-1", "embree/loop-8")
ENGINE = "embree/intersect"
OURS = "bvh/while-while"
MOST_OVERHEAD = 1.15
LEAST_SHARE = 0.3
LEAST_SIDE = 1024  # pixels: smaller frames measure the call more than the rays


def ratios(result: BenchmarkResult) -> list[str]:
    """A line for each ratio whose two sides were measured; open rows are left out."""
    rows: dict[tuple[str, str], ResultRow] = {}
    for row in closed(result.rows):
        rows.setdefault((f"{row.structure}/{row.traversal}", row.mode), row)
    lines = build_lines(result)
    loops = [rows[loop, "trace"] for loop in LOOPS if (loop, "trace") in rows]
    if loops and (frame := rows.get((ENGINE, "primary"))):
        lines.append(overhead_line(frame, min(loops, key=lambda row: row.frame_ms.median), result))
    if ours := rows.get((OURS, "trace")):
        lines += [share_line(ours, rows[name, "trace"], result) for name in (ENGINE, *LOOPS) if (name, "trace") in rows]
    lines += tier_lines(result)
    if left_out := len(result.rows) - len(closed(result.rows)):
        lines.append(f"{left_out} open row{'s are' if left_out > 1 else ' is'} left out of these ratios")
    return lines


def tier_lines(result: BenchmarkResult) -> list[str]:
    """What the strict tier costs where other knobs were measured beside it."""
    rows = {(row.structure_id, row.traversal, row.mode, tier_of(row)): row for row in closed(result.rows)}
    lines = []
    for (structure, traversal, mode, tier), row in rows.items():
        strict = rows.get((structure, traversal, mode, "strict"))
        if strict and tier in ("fast", "auto") and row.kernel_options != strict.kernel_options:
            ratio = strict.frame_ms.median / row.frame_ms.median
            times = f"{strict.frame_ms.median:.2f} and {row.frame_ms.median:.2f} ms"
            lines.append(f"{row.structure}/{traversal}, {mode}: strict takes {ratio:.2f}x the time of {tier} ({times})")
    return lines


def overhead_line(frame: ResultRow, bare: ResultRow, result: BenchmarkResult) -> str:
    ratio = frame.frame_ms.median / bare.frame_ms.median
    size = f"{result.spec.width}x{result.spec.height}"
    return (
        f"{ENGINE}: a {size} primary frame takes {ratio:.2f}x the bare loop {bare.structure}/{bare.traversal} "
        f"({frame.frame_ms.median:.2f} and {bare.frame_ms.median:.2f} ms)"
        + verdict(result, ratio <= MOST_OVERHEAD, f"at most {MOST_OVERHEAD}x")
    )


def share_line(ours: ResultRow, theirs: ResultRow, result: BenchmarkResult) -> str:
    """The goal is one ray list for both; a bare loop, which makes its rays as it goes, is told without a verdict."""
    name = f"{theirs.structure}/{theirs.traversal}"
    share = ours.mrays_per_s / theirs.mrays_per_s if theirs.mrays_per_s else 0.0
    rates = f"{ours.mrays_per_s:.2f} and {theirs.mrays_per_s:.2f} Mrays/s"
    goal = verdict(result, share >= LEAST_SHARE, f"at least {LEAST_SHARE}x") if name == ENGINE else ""
    return f"{OURS} traces {share:.2f}x the rays of {name} ({rates}){goal}"


def build_lines(result: BenchmarkResult) -> list[str]:
    builds = [f"{one.kind} {one.build_ms:.0f} ms" for one in result.structures if one.build_ms is not None]
    return [f"builds of {result.scene.triangles:,} triangles: {', '.join(builds)}"] if builds else []


def verdict(result: BenchmarkResult, reached: bool, goal: str) -> str:
    """The goals hold for large frames of scenes that have something to hit; others get none."""
    if min(result.spec.width or 0, result.spec.height or 0) < LEAST_SIDE or not result.scene.triangles:
        return ""
    return f": goal {goal}, {'reached' if reached else 'MISSED'}"
