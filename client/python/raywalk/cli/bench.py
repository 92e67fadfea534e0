"""raywalk bench: a benchmark job, its table and the ratios that are promised."""

from collections.abc import Callable
from pathlib import Path
from typing import Annotated

import typer

from raywalk.cli.session import connected, print_json, results, size, technique, words, writable_file
from raywalk.client import Client
from raywalk.follow import benchmark
from raywalk.models import BenchmarkResult, BenchmarkSpec, Job
from raywalk.progress import job_bar, messages
from raywalk.ratios import ratios
from raywalk.tables import table2, table_text, terminal
from raywalk.tables.files import result_json
from raywalk.techniques import bare_loops, measured


def spec_of(scene: str, techniques: str | None, modes: str, **numbers: object) -> BenchmarkSpec:
    """The job as the command line describes it; throws ValidationError when a value is out of range."""
    spec = {"scene": scene, "modes": words(modes)} | {key: value for key, value in numbers.items() if value is not None}
    if techniques is not None:
        pairs = [technique(word) for word in words(techniques)]
        spec["techniques"] = [{"structure": structure, "traversal": traversal} for structure, traversal in pairs]
    return BenchmarkSpec.model_validate(spec)


def measure(client: Client, spec: BenchmarkSpec, progress: Callable[[Job], None]) -> BenchmarkResult:
    """Runs the job; when no techniques are named, with all of them, and in mode trace with the bare loops too."""
    if spec.techniques is None:
        kinds = client.get_kinds()
        loops = bare_loops(kinds) if "trace" in (spec.modes or []) else []
        spec = spec.model_copy(update={"techniques": measured(kinds) + loops})
    return benchmark(client, spec, progress)


def bench(
    context: typer.Context,
    scene: Annotated[str, typer.Argument(help="Name of a scene; it is loaded and its structures are built.")],
    techniques: Annotated[
        str | None, typer.Option(help="STRUCTURE/TRAVERSAL, separated by commas; all when absent.")
    ] = None,
    modes: Annotated[
        str, typer.Option(help="Of trace, primary, shadow and whitted, separated by commas.")
    ] = "trace,primary,shadow,whitted",
    frames: Annotated[int, typer.Option(help="Frames spread evenly over the walkthrough; the study has 400.")] = 20,
    size_: Annotated[str, typer.Option("--size", help="Pixels.", metavar="WxH")] = "1024x1024",
    depth: Annotated[int, typer.Option(help="Bounces of secondary rays in mode whitted.")] = 2,
    repeats: Annotated[int, typer.Option(help="Times that the frames are measured.")] = 1,
    warmup: Annotated[int, typer.Option(help="Frames rendered before measuring.")] = 5,
    error_frames: Annotated[int | None, typer.Option(help="Frames compared with the reference.")] = None,
    time_limit: Annotated[float | None, typer.Option(help="Seconds after which measuring stops.")] = None,
    out: Annotated[Path | None, typer.Option(help="File for the result as JSON; `raywalk tables` reads it.")] = None,
    as_csv: Annotated[bool, typer.Option("--csv", help="Print the table as CSV.")] = False,
    as_json: Annotated[bool, typer.Option("--json", help="Print the result as JSON.")] = False,
) -> None:
    """Measure techniques on a scene's walkthrough; each time stands beside its error."""
    width, height = size(size_)
    numbers = {"width": width, "height": height, "frames": frames, "depth": depth, "repeats": repeats}
    numbers |= {"warmup": warmup, "error_frames": error_frames, "time_limit_s": time_limit}
    spec = spec_of(scene, techniques, modes, **numbers)
    if out is not None:
        writable_file(out)
    with connected(context) as client, job_bar(scene, width * height) as progress:
        result = measure(client, spec, progress)
    if out is not None:
        out.write_text(result_json(result))
        messages().print(f"wrote {out}")
    if as_json:
        return print_json(result)
    if as_csv:
        return typer.echo(table_text(2, [result], "csv"), nl=False)
    console = results()
    console.print(terminal(table2([result])))
    for line in ratios(result):
        console.print(line)
