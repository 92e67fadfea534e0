"""Measures a GPU daemon and prints the goals and tables of tests/gpu/RESULTS.md; run it on the machine with the GPU.

    python tests/measure/gpu.py [--daemon bin/raywalkd] [--frames 400] [--out RESULTS.md]

Needs the original bunny (and, for the dragon of 810,080 triangles, dragon_vrip_res2) in RAYWALK_SCENE_DATA. A
benchmark, not a test: it prints figures beside the goals and always ends well."""

import argparse
import datetime
import http.client
import json
import os
import re
import statistics
import tempfile
import time
from pathlib import Path
from urllib.parse import urlsplit

from raywalk import Client, LocalDaemon
from raywalk.follow import benchmark, built
from raywalk.models import BenchmarkResult, BenchmarkSpec, ResultRow, Technique
from raywalk.sweep import CAPS, sweep_specs
from raywalk.tables import table_text
from raywalk.tables.paper import Paper
from split_mesh import ply_bytes, read_ply, split

TECHNIQUES = [("grid", "dda"), ("kdtree", "short-stack-3"), ("kdtree", "short-stack-2"), ("bvh", "packet")]
FLAGSHIP = ("bvh", "while-while")
GOAL_TIMES = 60  # faster than the study's GTX 280, primary rays, bunny
GOAL_MRAYS = {"bunny": 5500, "dragon810k": 3200}  # of while-while, traversal only, single launches
GOAL_SHADED = 0.75  # of the goal above
GOAL_COLD_S, GOAL_WARM_S, GOAL_PREVIEW_MS = 3.0, 0.7, 6.0
TIMING = re.compile(r"(\w+);dur=([\d.]+)")


def frame_body(scene: str, frame: int, of: int) -> str:
    request = {"scene": scene, "structure": FLAGSHIP[0], "traversal": FLAGSHIP[1], "width": 1024, "height": 1024}
    return json.dumps(request | {"camera": {"frame": frame, "of": of}})


def first_frame_s(program: Path, cache: Path) -> float:
    """From the start of the daemon to the first frame in hand, scene loaded and structure built between."""
    begin = time.perf_counter()
    arguments = ("--device", "cuda", "--kernel-cache", str(cache))
    with LocalDaemon(program, arguments) as daemon, Client(daemon.base_url) as client:
        client.load_scene("bunny")
        while client.build_structure("bunny", "bvh").state != "ready":
            time.sleep(0.005)
        post(http.client.HTTPConnection("127.0.0.1", urlsplit(daemon.base_url).port), frame_body("bunny", 0, 400))
        return time.perf_counter() - begin


def post(connection: http.client.HTTPConnection, body: str) -> dict[str, float]:
    """Times of one JPEG frame in ms: the daemon's own, and `total` as seen from here."""
    begin = time.perf_counter()
    connection.request("POST", "/v1/frames", body, {"Content-Type": "application/json"})
    answer = connection.getresponse()
    answer.read()
    total_ms = (time.perf_counter() - begin) * 1e3
    return {name: float(ms) for name, ms in TIMING.findall(answer.headers["Server-Timing"])} | {"total": total_ms}


def preview(base_url: str, frames: int) -> dict[str, float]:
    """Medians over a walkthrough of 1024x1024 JPEG frames."""
    connection = http.client.HTTPConnection("127.0.0.1", urlsplit(base_url).port)
    seen = [post(connection, frame_body("bunny", frame, frames)) for frame in range(frames)]
    for times in seen:
        times["beyond the kernel"] = times["total"] - times["trace"]
    return {name: statistics.median(times[name] for times in seen) for name in seen[0]}


def measure(client: Client, scene: str, frames: int) -> BenchmarkResult:
    techniques = [Technique(structure=s, traversal=t) for s, t in [*TECHNIQUES, FLAGSHIP]]
    modes = ["trace", "primary", "shadow", "whitted"]
    return benchmark(client, BenchmarkSpec(scene=scene, techniques=techniques, modes=modes, frames=frames))


def row_of(result: BenchmarkResult, technique: tuple[str, str], mode: str) -> ResultRow:
    return next(row for row in result.rows if (row.structure, row.traversal, row.mode) == (*technique, mode))


def verdict(reached: bool) -> str:
    return "reached" if reached else "**missed**"


def goals(
    results: dict[str, BenchmarkResult], cold_s: float, warm_s: list[float], times: dict[str, float]
) -> list[str]:
    lines = ["| what | goal | measured | |", "|---|---|---|---|"]
    bunny = results["bunny"]
    for technique in TECHNIQUES:
        name = "/".join(technique)
        paper_ms = Paper(bunny.scene.paper).frame_ms("primary", name)
        ms = row_of(bunny, technique, "primary").frame_ms.median
        goal_ms = paper_ms / GOAL_TIMES
        lines.append(
            f"| bunny, primary, {name}: frame | <= {goal_ms:.3f} ms (paper {paper_ms:g} ms / {GOAL_TIMES}) "
            f"| {ms:.3f} ms, {paper_ms / ms:.0f} times faster | {verdict(ms <= goal_ms)} |"
        )
    for scene, goal in GOAL_MRAYS.items():
        if scene not in results:
            continue
        for mode, least in (("trace", goal), ("primary", GOAL_SHADED * goal)):
            row = row_of(results[scene], FLAGSHIP, mode)
            mrays = 1024 * 1024 / row.frame_ms.median / 1e3
            batch = f", {row.throughput.mrays_per_s:,.0f} in launches of {row.throughput.frames_per_launch}"
            lines.append(
                f"| {scene}, bvh/while-while, {'traversal only' if mode == 'trace' else 'with Phong shading'} "
                f"| >= {least:,.0f} Mrays/s | {mrays:,.0f}{batch} | {verdict(mrays >= least)} |"
            )
    warm = statistics.median(warm_s)
    lines.append(
        f"| start to first frame, no kernel in the cache | <= {GOAL_COLD_S} s | {cold_s:.2f} s "
        f"| {verdict(cold_s <= GOAL_COLD_S)} |"
    )
    lines.append(
        f"| the same, kernels cached, median of {len(warm_s)} | <= {GOAL_WARM_S} s | {warm:.2f} s "
        f"| {verdict(warm <= GOAL_WARM_S)} |"
    )
    beyond = times["beyond the kernel"]
    parts = ", ".join(f"{name} {times[name]:.2f}" for name in ("queue", "trace", "readback", "encode"))
    lines.append(
        f"| 1024x1024 JPEG over loopback, beyond the kernel | <= {GOAL_PREVIEW_MS} ms | {beyond:.2f} ms ({parts}) "
        f"| {verdict(beyond <= GOAL_PREVIEW_MS)} |"
    )
    return lines


def errors(results: dict[str, BenchmarkResult]) -> str:
    rows = [row for result in results.values() for row in result.rows]
    pixels, wrong = sum(row.error.pixels for row in rows), sum(row.error.id_mismatches for row in rows)
    ties = sum(row.error.ties for row in rows)
    return (
        f"Against watertight Embree on the host, over {pixels:,} primary rays of all rows: {wrong} hit another "
        f"triangle, {ties} were ties."
    )


def report(args: argparse.Namespace) -> str:
    with tempfile.TemporaryDirectory() as folder:
        cache = Path(folder) / "kernels"
        cold_s = first_frame_s(args.daemon, cache)
        warm_s = [first_frame_s(args.daemon, cache) for _ in range(5)]
        arguments = ("--device", "cuda", "--kernel-cache", str(cache))
        with LocalDaemon(args.daemon, arguments) as daemon, Client(daemon.base_url) as client:
            system = client.get_system()
            client.load_scene("bunny")
            built(client, "bunny", "bvh")
            times = preview(daemon.base_url, 200)
            results = {"bunny": measure(client, "bunny", args.frames)}
            dragon = Path(os.environ.get("RAYWALK_SCENE_DATA", "")) / "dragon/dragon_vrip_res2.ply.gz"
            if dragon.is_file():
                client.upload_scene("dragon810k", ply_bytes(*split(*read_ply(dragon))))
                results["dragon810k"] = measure(client, "dragon810k", args.frames)
            spec = BenchmarkSpec(scene="bunny", modes=["primary"], frames=20, repeats=3, batch=0, error_frames=1)
            table3 = [benchmark(client, one) for one in sweep_specs(client, spec, CAPS, {})]
    device = ", ".join(f"{name} {value}" for name, value in sorted(system.device.details.items()))
    today = datetime.datetime.now(datetime.UTC).date().isoformat()
    return "\n".join(
        [
            "# What was measured on a GPU",
            "",
            f"{system.device.name} ({device}), {system.machine.cpu}, {system.machine.os}, {today}, "
            f"commit {system.machine.git_commit[:12]}.",
            "",
            f"    python tests/measure/gpu.py --frames {args.frames}",
            "",
            "## Goals",
            "",
            *goals(results, cold_s, warm_s, times),
            "",
            errors(results),
            "",
            *[line for result in results.values() for line in (table_text(2, [result], "md"), "")],
            table_text(3, table3, "md"),
        ]
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--daemon", type=Path, help="the daemon; the client's own when absent")
    parser.add_argument("--frames", type=int, default=400)
    parser.add_argument("--out", type=Path, help="file for the report; standard output when absent")
    args = parser.parse_args()
    text = report(args)
    if args.out:
        args.out.write_text(text)
    print(text)


if __name__ == "__main__":
    main()
