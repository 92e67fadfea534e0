"""Table 3 for programs: a record for each scene, mode, technique and register cap."""

from collections.abc import Sequence

from raywalk.kernel_options import REGISTERS, asked, options_text, register_cap
from raywalk.models import BenchmarkResult, ResultRow
from raywalk.tables.notes2 import technique
from raywalk.tables.records import PAPER_PREFIX, Record, key_of, origin_of
from raywalk.tables.table3 import best_of, groups, of_best, paper_ms, theirs


def records3(results: Sequence[BenchmarkResult]) -> list[Record]:
    return [
        kernel_record(result, row, best_of(group)) for result in results for group in groups(result) for row in group
    ]


def kernel_record(result: BenchmarkResult, row: ResultRow, best: ResultRow | None) -> Record:
    kernel, paper = row.kernel, theirs(row)
    assert kernel is not None
    others = {name: value for name, value in asked(result.spec, row).items() if name != REGISTERS}
    record = key_of(result) | {"mode": row.mode, "technique": technique(row), "kernel_options": options_text(others)}
    record |= {"register_cap": register_cap(row), "registers": kernel.registers, "local_bytes": kernel.local_bytes}
    record |= {"shared_bytes": kernel.shared_bytes, "threads_per_block": kernel.threads_per_block}
    record |= {"blocks_per_multiprocessor": kernel.blocks_per_multiprocessor}
    record |= {"occupancy": kernel.occupancy, "binary_bytes": kernel.binary_bytes}
    record |= {"frame_median_ms": row.frame_ms.median, "unstable": int(row.frame_ms.unstable)}
    record |= {"time_of_best": of_best(row, best)}
    record |= {f"{PAPER_PREFIX}_registers": paper and paper.registers}
    record |= {f"{PAPER_PREFIX}_occupancy": paper and paper.occupancy}
    return record | {f"{PAPER_PREFIX}_frame_ms": paper_ms(result, row)} | origin_of(result)
