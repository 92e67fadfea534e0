"""The images of a demo: frames of the walkthrough, and what the contact sheet shows of each technique."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
from PIL import Image

from raywalk.client import Client
from raywalk.contact import Panel, Reference, contact_sheet
from raywalk.errors import ProblemError
from raywalk.follow import built
from raywalk.gate import closed
from raywalk.images import opened
from raywalk.models import BenchmarkResult, FrameRequest, PathFrame, ResultRow
from raywalk.tables.machine import machine_line
from raywalk.tables.notes2 import technique

RAW, PNG = "application/octet-stream", "image/png"
WALK_TILES = 8


def row_of(result: BenchmarkResult, name: str, mode: str) -> ResultRow | None:
    return next((row for row in result.rows if technique(row) == name and row.mode == mode), None)


def names_of(result: BenchmarkResult) -> list[str]:
    return list(dict.fromkeys(technique(row) for row in result.rows))


def request_of(result: BenchmarkResult, name: str, frame: int, **more: object) -> FrameRequest:
    structure, traversal = name.split("/")
    spec = result.spec
    request = {"scene": spec.scene, "structure": structure, "traversal": traversal}
    request |= {"width": spec.width, "height": spec.height, "camera": PathFrame(frame=frame, of=spec.frames or 1)}
    return FrameRequest.model_validate(request | more)


def fastest(result: BenchmarkResult, mode: str) -> str:
    """Of the closed rows, if there are any."""
    rows = [row for row in result.rows if row.mode == mode]
    return technique(min(closed(rows) or rows, key=lambda row: row.frame_ms.mean))


def render_walk(
    client: Client, result: BenchmarkResult, mode: str, folder: Path, on_frame: Callable[[int], None]
) -> list[Path]:
    """Every frame of the benchmark's walkthrough by the fastest technique, as frames/NNNN.png."""
    name, paths = fastest(result, mode), []
    for frame in range(result.spec.frames or 1):
        got = client.render_frame(request_of(result, name, frame, mode=mode), PNG)
        paths.append(folder / f"{frame:04}.png")
        paths[-1].write_bytes(got.content)
        on_frame(frame + 1)
    return paths


def panel_of(client: Client, result: BenchmarkResult, name: str, mode: str) -> Panel:
    image = opened(client.render_frame(request_of(result, name, 0, mode=mode), PNG).content)
    row = row_of(result, name, mode)
    caption = f"{row.frame_ms.mean:.1f} ms a frame, {row.mrays_per_s:.2f} Mrays/s" if row else ""
    return Panel(name, caption, np.asarray(image), steps_of(client, result, name))


def steps_of(client: Client, result: BenchmarkResult, name: str) -> np.ndarray | None:
    """Steps of each primary ray; None where the technique cannot count."""
    row = next((row for row in result.rows if technique(row) == name), None)
    if row is None or row.steps_per_ray is None:
        return None
    try:
        return client.render_frame(request_of(result, name, 0, output="steps"), RAW).array()[..., 0]
    except ProblemError:
        return None


def reference_of(client: Client, result: BenchmarkResult, mode: str) -> Reference | None:
    """The first frame by watertight Embree, which shares no code with our structures; None where it is missing."""
    try:
        structure = built(client, result.spec.scene, "embree", {"robust": "on"})
        request = request_of(result, "embree/intersect", 0, mode=mode).model_copy(update={"structure": structure.id})
        return Reference("embree/intersect robust=on", np.asarray(opened(client.render_frame(request, PNG).content)))
    except ProblemError:
        return None


def sheet_of(client: Client, result: BenchmarkResult, mode: str, walk: list[Path]) -> Image.Image:
    """The contact sheet of a result whose walkthrough was rendered."""
    chosen = [walk[round(k)] for k in np.linspace(0, len(walk) - 1, min(WALK_TILES, len(walk)))]
    scene = result.scene
    title = f"Raywalk: {scene.title}, {scene.triangles:,} triangles ({scene.fidelity}), rays: {mode}"
    panels = [panel_of(client, result, name, mode) for name in names_of(result)]
    reference = reference_of(client, result, mode) or Reference(panels[0].name, panels[0].image)
    return contact_sheet(title, machine_line([result]), panels, reference, [Image.open(path) for path in chosen])
