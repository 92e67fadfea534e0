"""The tables for programs: CSV with a record a row, every key in every record, units in the names of the columns."""

import csv
import io
from collections.abc import Sequence
from typing import Any

from raywalk.gate import is_open, tier_of
from raywalk.kernel_options import asked, options_text
from raywalk.models import BenchmarkResult, ResultRow
from raywalk.tables.gpu import telemetry_text
from raywalk.tables.machine import command_of
from raywalk.tables.notes2 import BASE, technique
from raywalk.tables.paper import PAPER_DEVICE, PAPER_FRAMES, PAPER_SIZE, Paper
from raywalk.tables.runs import compared_of
from raywalk.tables.table1 import FIGURES, counted_row, our_figure, paper_figure
from raywalk.tables.table2 import base_ms

Record = dict[str, Any]
NAMES = {
    "size": "cells",
    "leaves": "leaves_thousands",
    "references_per_triangle": "references_per_triangle",
    "megabytes": "mb",
    "steps": "steps_per_ray",
    "tests": "tests_per_ray",
}
PAPER_PREFIX = PAPER_DEVICE.lower().replace(" ", "")


def records1(results: Sequence[BenchmarkResult]) -> list[Record]:
    """Structures: `source` is ours or paper; counts are of the named traversal and mode."""
    records = []
    for result in results:
        records.append(structures_record(result))
        if Paper(result.scene.paper).has_structures:
            records.append(paper_record(result))
    return records


def structures_record(result: BenchmarkResult) -> Record:
    scene = result.scene
    record = key_of(result) | {"source": "ours", "triangles": scene.triangles, "lights": scene.lights}
    for kind, figures in FIGURES.items():
        row = counted_row(result, kind)
        record |= {f"{kind}_{NAMES[figure]}": our_figure(result, kind, figure) for figure in figures}
        record |= {f"{kind}_traversal": row and row.traversal, f"{kind}_mode": row and row.mode}
    return record | origin_of(result)


def paper_record(result: BenchmarkResult) -> Record:
    paper = Paper(result.scene.paper)
    width, height = PAPER_SIZE.split("x")
    record = key_of(result) | {"source": "paper", "fidelity": "original", "frames": PAPER_FRAMES}
    record |= {"width_px": int(width), "height_px": int(height), "triangles": paper.triangles, "lights": paper.lights}
    for kind, figures in FIGURES.items():
        record |= {f"{kind}_{NAMES[figure]}": paper_figure(paper, kind, figure) for figure in figures}
        record |= {f"{kind}_traversal": None, f"{kind}_mode": None}
    return record | dict.fromkeys(origin_of(result)) | {"device": PAPER_DEVICE}


def records2(results: Sequence[BenchmarkResult]) -> list[Record]:
    """Times: a record for each scene, mode and technique; the paper's time stands in columns of its own."""
    return [time_record(result, row) for result in results for row in result.rows]


def time_record(result: BenchmarkResult, row: ResultRow) -> Record:
    base = None if is_open(row) else base_ms(row.mode, [other for other in result.rows if other.mode == row.mode])
    paper, error = Paper(result.scene.paper), row.error
    theirs, their_base = paper.frame_ms(row.mode, technique(row)), paper.frame_ms(row.mode, BASE[row.mode])
    return (
        key_of(result)
        | {"mode": row.mode, "technique": technique(row), "depth": result.spec.depth}
        | {"frame_mean_ms": row.frame_ms.mean, "frame_percent": share(row.frame_ms.mean, base)}
        | {"frame_median_ms": row.frame_ms.median, "unstable": int(row.frame_ms.unstable)}
        | {"mrays_per_s": row.mrays_per_s, "rays_per_frame": row.rays_per_frame}
        | {"error_reference": error.reference, "error_frames": compared_of(result), "ids_ppm": error.id_mismatch_ppm}
        | {"ids_upper95_ppm": error.id_mismatch_ppm_upper95}
        | {"image_rmse": None if row.mode == "trace" else error.image_rmse, "image_psnr_db": error.image_psnr_db}
        | {"image_ssim": error.image_ssim, "image_flip_mean": error.image_flip_mean}
        | {"image_flip_p99": error.image_flip_p99, "image_flip_max": error.image_flip_max}
        | {"changed_pixels_ppm": error.changed_pixels_ppm}
        | {f"{PAPER_PREFIX}_frame_ms": theirs, f"{PAPER_PREFIX}_percent": share(theirs, their_base)}
        | {"kernel_options": options_text(asked(result.spec, row))}
        | gate_record(row)
        | throughput_record(row)
        | {"telemetry": telemetry_text(result) if result.telemetry else None}
        | origin_of(result)
    )


def gate_record(row: ResultRow) -> Record:
    gate = row.gate
    return {
        "tier": tier_of(row),
        "gate": gate and gate.status,
        "gate_limit_ppm": gate and gate.limit_ppm,
        "wrong_rays": gate and gate.wrong,
        "wrong_ppm": gate and gate.wrong_ppm,
        "wrong_upper95_ppm": gate and gate.wrong_ppm_upper95,
        "gate_reason": gate and gate.reason,
    }


def throughput_record(row: ResultRow) -> Record:
    seen = row.throughput
    return {
        "launch_frames": seen and seen.frames_per_launch,
        "launch_frame_mean_ms": seen and seen.frame_ms.mean,
        "launch_mrays_per_s": seen and seen.mrays_per_s,
    }


def key_of(result: BenchmarkResult) -> Record:
    spec, scene = result.spec, result.scene
    key = {"scene": scene.name, "fidelity": scene.fidelity}
    return key | {"width_px": spec.width, "height_px": spec.height, "frames": spec.frames}


def origin_of(result: BenchmarkResult) -> Record:
    machine = result.machine
    origin = {"device": machine.device, "threads": machine.threads, "machine": machine.fingerprint}
    return origin | {
        "git_commit": machine.git_commit,
        "created_at": result.created_at,
        "command": command_of(result),
    }


def share(value: float | None, base: float | None) -> float | None:
    """Percent, unrounded."""
    return 100 * value / base if value is not None and base else None


def csv_text(records: Sequence[Record]) -> str:
    """One heading, then the records; what is missing is empty."""
    out = io.StringIO()
    writer = csv.DictWriter(out, list(records[0]) if records else [], lineterminator="\n")
    writer.writeheader()
    writer.writerows(records)
    return out.getvalue()
