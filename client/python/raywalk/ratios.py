"""What the project promises of speed, as ratios within one result."""

from raywalk.models import BenchmarkResult, ResultRow

LOOPS = ("embree/loop-1", "embree/loop-8")
ENGINE = "embree/intersect"
OURS = "bvh/while-while"
MOST_OVERHEAD = 1.15
LEAST_SHARE = 0.3
LEAST_SIDE = 1024  # pixels: smaller frames measure the call more than the rays


def ratios(result: BenchmarkResult) -> list[str]:
    """A line for each ratio whose two sides were measured."""
    rows = {(f"{row.structure}/{row.traversal}", row.mode): row for row in result.rows}
    lines = build_lines(result)
    loops = [rows[loop, "trace"] for loop in LOOPS if (loop, "trace") in rows]
    if loops:
        bare = min(loops, key=lambda row: row.frame_ms.median)
        for mode, what in (("primary", "primary frame"), ("trace", "traversal of a frame")):
            if frame := rows.get((ENGINE, mode)):
                lines.append(overhead_line(what, frame, bare, result))
    ours, theirs = rows.get((OURS, "trace")), rows.get((ENGINE, "trace"))
    if ours and theirs and theirs.mrays_per_s:
        share = ours.mrays_per_s / theirs.mrays_per_s
        rates = f"{ours.mrays_per_s:.2f} and {theirs.mrays_per_s:.2f} Mrays/s"
        lines.append(
            f"{OURS} traces {share:.2f}x the rays of {ENGINE} ({rates})"
            + verdict(result, share >= LEAST_SHARE, f"at least {LEAST_SHARE}x")
        )
    return lines


def overhead_line(what: str, frame: ResultRow, bare: ResultRow, result: BenchmarkResult) -> str:
    ratio = frame.frame_ms.median / bare.frame_ms.median
    size = f"{result.spec.width}x{result.spec.height}"
    return (
        f"{ENGINE}: a {size} {what} takes {ratio:.2f}x the bare loop {bare.structure}/{bare.traversal} "
        f"({frame.frame_ms.median:.2f} and {bare.frame_ms.median:.2f} ms)"
        + verdict(result, ratio <= MOST_OVERHEAD, f"at most {MOST_OVERHEAD}x")
    )


def build_lines(result: BenchmarkResult) -> list[str]:
    builds = [f"{one.kind} {one.build_ms:.0f} ms" for one in result.structures if one.build_ms is not None]
    return [f"builds of {result.scene.triangles:,} triangles: {', '.join(builds)}"] if builds else []


def verdict(result: BenchmarkResult, reached: bool, goal: str) -> str:
    """The goals hold for large frames of scenes that have something to hit; others get none."""
    if min(result.spec.width or 0, result.spec.height or 0) < LEAST_SIDE or not result.scene.triangles:
        return ""
    return f": goal {goal}, {'reached' if reached else 'MISSED'}"
