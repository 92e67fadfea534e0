"""What a GPU adds to Table 2: throughput apart from latency, the gain over the paper's GPU, its sensors."""

from collections.abc import Sequence

from raywalk.models import BenchmarkResult, ResultRow, SensorRange
from raywalk.tables.paper import PAPER_DEVICE, PAPER_SIZE, Paper
from raywalk.tables.runs import size_of
from raywalk.tables.table import Cell, Column


def on_gpu(results: Sequence[BenchmarkResult]) -> bool:
    return any(row.kernel for result in results for row in result.rows)


def frames_per_launch(results: Sequence[BenchmarkResult]) -> list[int]:
    """Every number of frames that a launch had; empty when throughput was not measured."""
    rows = (row for result in results for row in result.rows)
    return sorted({row.throughput.frames_per_launch for row in rows if row.throughput})


def throughput_columns(results: Sequence[BenchmarkResult]) -> list[Column]:
    launches = frames_per_launch(results)
    group = f"{launches[0]} a launch" if len(launches) == 1 else "many a launch"
    return [Column("ms", group, 3, optional=True), Column("Mrays/s", group, 1, optional=True)]


def throughput_cells(row: ResultRow) -> list[Cell]:
    if row.throughput is None:
        return [None, None]
    return [row.throughput.frame_ms.mean, row.throughput.mrays_per_s]


def faster(result: BenchmarkResult, row: ResultRow) -> float | None:
    """How many times as fast as the paper's GPU, for frames of its size; None on a CPU and where it has no time."""
    theirs = Paper(result.scene.paper).frame_ms(row.mode, f"{row.structure}/{row.traversal}")
    if theirs is None or row.kernel is None or size_of(result) != PAPER_SIZE or row.frame_ms.mean <= 0:
        return None
    return theirs / row.frame_ms.mean


def any_faster(results: Sequence[BenchmarkResult]) -> bool:
    return any(faster(result, row) is not None for result in results for row in result.rows)


def faster_cell(result: BenchmarkResult, row: ResultRow) -> str | None:
    times = faster(result, row)
    return None if times is None else f"{times:.1f}x"


def gpu_notes(results: Sequence[BenchmarkResult]) -> list[str]:
    said = []
    if launches := frames_per_launch(results):
        counts = " or ".join(str(count) for count in launches)
        said.append(
            f"frame: one frame a launch, its latency; {counts} a launch: the mean share of a frame in launches of "
            f"{counts} frames, the throughput."
        )
    if any_faster(results):
        said.append(f"faster than {PAPER_DEVICE}: the paper's mean time over ours.")
    return said + telemetry_notes(results)


def telemetry_notes(results: Sequence[BenchmarkResult]) -> list[str]:
    """One line a result that has sensors."""
    return [f"{result.scene.name}: {telemetry_text(result)}." for result in results if result.telemetry]


def telemetry_text(result: BenchmarkResult) -> str:
    seen = result.telemetry
    assert seen is not None
    throttled = ", ".join(seen.throttle_reasons) or "none"
    return (
        f"while it measured, core clock {spread(seen.core_clock_mhz, 'MHz')}, memory clock "
        f"{spread(seen.memory_clock_mhz, 'MHz')}, power {spread(seen.power_w, 'W')} of {seen.power_limit_w:.0f} W, "
        f"temperature {spread(seen.temperature_c, '°C')}, throttle reasons: {throttled}"
    )


def spread(sensor: SensorRange, unit: str) -> str:
    """The median, and the range where there is one."""
    lo, mid, hi = (f"{value:.0f}" for value in (sensor.min, sensor.median, sensor.max))
    return f"{mid} {unit}" + (f" ({lo} to {hi})" if lo != hi else "")
