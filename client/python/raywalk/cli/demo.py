"""raywalk demo: the main job from start to end."""

import time
from pathlib import Path
from typing import Annotated

import typer

from raywalk.cli.session import connected, results, size, writable_file, writable_folder
from raywalk.client import Client
from raywalk.follow import benchmark, built
from raywalk.models import BenchmarkSpec, Technique
from raywalk.progress import bar, job_bar, messages
from raywalk.showcase import render_walk, sheet_of
from raywalk.tables import TABLES, tables_of, terminal, write_tables
from raywalk.tables.files import result_json
from raywalk.techniques import measured

MODES = ["primary", "shadow", "whitted"]
SHOWN_MODE = "whitted"
FRAMES, LIMIT_S = 24, 40.0  # without --frames


def demo(
    context: typer.Context,
    scene: Annotated[str, typer.Option(help="Name of a scene.")] = "bunny",
    frames: Annotated[
        int | None,
        typer.Option(min=1, max=100000, help=f"Frames of the walkthrough; {FRAMES}, or as many as fit, when absent."),
    ] = None,
    size_: Annotated[str, typer.Option("--size", help="Pixels.", metavar="WxH")] = "512x512",
    out: Annotated[Path, typer.Option(help="Folder for tables, result and images.")] = Path("out/demo"),
) -> None:
    """Measure every structure and traversal on one walkthrough: tables, results.json, frames and a contact sheet."""
    start = time.monotonic()
    width, height = size(size_)
    folder = writable_folder(out)
    images = writable_folder(folder / "frames")
    for name in ("table1.md", "table2.md", "results.json", "contact-sheet.png"):
        writable_file(folder / name)
    for old in images.glob("*.png"):
        old.unlink()
    console = messages()
    with connected(context) as client:
        with bar(f"loading {scene}"):
            loaded = client.load_scene(scene)
        console.print(f"{loaded.title}: {loaded.triangles:,} triangles, {loaded.fidelity}")
        techniques = measured(client.get_kinds())
        build_all(client, scene, techniques)
        spec = BenchmarkSpec.model_validate(
            {"scene": scene, "techniques": techniques, "modes": MODES, "width": width, "height": height}
            | {"frames": frames or FRAMES, "warmup": 1}
            | ({} if frames else {"time_limit_s": LIMIT_S})
        )
        with job_bar(scene, width * height, console) as progress:
            result = benchmark(client, spec, progress)
        (folder / "results.json").write_text(result_json(result))
        write_tables(tables_of([result]), [result], folder, "md")
        count = spec.frames or FRAMES
        with bar("images", count, console) as progress:
            walk = render_walk(
                client,
                result,
                SHOWN_MODE,
                images,
                lambda done: progress.update(done, count, f"{progress.rate(done):.1f} frames/s"),
            )
            progress.update(0, None, what="contact sheet")
            sheet_of(client, result, SHOWN_MODE, walk).save(folder / "contact-sheet.png")
    for number in tables_of([result]):
        results().print(terminal(TABLES[number]([result])))
    console.print(
        f"wrote table1.md, table2.md, results.json, {len(walk)} frames and contact-sheet.png in {folder} "
        f"after {time.monotonic() - start:.0f} s"
    )


def build_all(client: Client, scene: str, techniques: list[Technique]) -> None:
    kinds = list(dict.fromkeys(technique.structure for technique in techniques))
    console = messages()
    with bar("building", len(kinds), console) as progress:
        for number, kind in enumerate(kinds):
            progress.update(number, len(kinds), what=f"building {kind}")
            structure = built(client, scene, kind)
            facts = f"{(structure.size_bytes or 0) / 1e6:.1f} MB in {structure.build_ms or 0:.0f} ms"
            console.print(f"built {kind}: {facts}")
