"""raywalk bench: a benchmark job, its table and the ratios that are promised."""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Annotated

import typer

from raywalk import sweep
from raywalk.cli.session import connected, options, print_json, results, size, technique, words, writable_file
from raywalk.client import Client
from raywalk.follow import benchmark
from raywalk.kernel_options import REGISTERS, Options, spread_over
from raywalk.models import BenchmarkResult, BenchmarkSpec, Job
from raywalk.progress import job_bar, messages
from raywalk.ratios import ratios
from raywalk.tables import TABLES, table_text, terminal
from raywalk.tables.files import result_json
from raywalk.techniques import bare_loops, in_tiers, measured

TIERS = ("strict", "fast", "auto")
MODES = "trace,primary,shadow,whitted"
TIMES, KERNELS = 2, 3  # tables


def spec_of(scene: str, techniques: str | None, modes: str, **numbers: object) -> BenchmarkSpec:
    """The job as the command line describes it; throws ValidationError when a value is out of range."""
    spec = {"scene": scene, "modes": words(modes)} | {key: value for key, value in numbers.items() if value is not None}
    if techniques is not None:
        pairs = [technique(word) for word in words(techniques)]
        spec["techniques"] = [{"structure": structure, "traversal": traversal} for structure, traversal in pairs]
    return BenchmarkSpec.model_validate(spec)


def measure(
    client: Client,
    spec: BenchmarkSpec,
    progress: Callable[[Job], None],
    kernel: Options | None = None,
    tiers: Sequence[str] = TIERS[:1],
) -> BenchmarkResult:
    """Runs the job; when no techniques are named, with all of them, and in mode trace with the bare loops too."""
    if spec.techniques is None or kernel or tuple(tiers) != TIERS[:1]:
        kinds = client.get_kinds()
        loops = bare_loops(kinds) if "trace" in (spec.modes or []) else []
        techniques = spread_over(kinds, spec.techniques or measured(kinds) + loops, kernel or {})
        spec = spec.model_copy(update={"techniques": in_tiers(kinds, techniques, tiers)})
    return benchmark(client, spec, progress)


def measure_sweep(
    client: Client, spec: BenchmarkSpec, progress: Callable[[Job], None], kernel: Options, caps: list[int]
) -> list[BenchmarkResult]:
    """The jobs of Table 3, one after the other."""
    jobs = sweep.sweep_specs(client, spec, caps, kernel)
    return [benchmark(client, job, progress) for job in jobs]


def files_of(out: Path, count: int) -> list[Path]:
    """`out` itself for one result; NAME-1.json and so on for several."""
    return [out] if count == 1 else [out.with_stem(f"{out.stem}-{number + 1}") for number in range(count)]


def scene_of(scene: str | None, table: int) -> str:
    if scene is None and table == TIMES:
        raise typer.BadParameter("name a scene; only --table 3 has one of its own (bunny)")
    return scene or sweep.SCENE


def tiers_of(text: str, table: int) -> list[str]:
    """Tiers separated by commas, each once."""
    tiers = list(dict.fromkeys(words(text)))
    if not tiers or not set(tiers) <= set(TIERS):
        raise typer.BadParameter(f"{text!r} is not one or more of {', '.join(TIERS)}")
    if table == KERNELS and tiers != ["strict"]:
        raise typer.BadParameter("--table 3 is about the strict tier; --kernel names other knobs")
    return tiers


def kernel_of(text: str | None, table: int, registers: str | None) -> Options:
    """Kernel options, checked against the options that exclude each other."""
    kernel = options(words(text or ""), "registers=64") or {}
    if text is not None and not kernel:
        raise typer.BadParameter(f"{text!r} are no kernel options like registers=64,block=128")
    if table == KERNELS and REGISTERS in kernel:
        raise typer.BadParameter("--table 3 sweeps the register caps; name them with --registers")
    if table != KERNELS and registers is not None:
        raise typer.BadParameter("--registers is for --table 3; one cap is --kernel registers=64")
    return kernel


def bench(
    context: typer.Context,
    scene: Annotated[
        str | None, typer.Argument(help="Name of a scene; it is loaded and its structures are built.")
    ] = None,
    techniques: Annotated[
        str | None, typer.Option(help="STRUCTURE/TRAVERSAL, separated by commas; all when absent.")
    ] = None,
    modes: Annotated[
        str | None,
        typer.Option(help="Of trace, primary, shadow and whitted, separated by commas; all, or primary for --table 3."),
    ] = None,
    frames: Annotated[int, typer.Option(help="Frames spread evenly over the walkthrough; the study has 400.")] = 20,
    size_: Annotated[str, typer.Option("--size", help="Pixels.", metavar="WxH")] = "1024x1024",
    depth: Annotated[int, typer.Option(help="Bounces of secondary rays in mode whitted.")] = 2,
    repeats: Annotated[int, typer.Option(help="Times that the frames are measured.")] = 1,
    warmup: Annotated[int, typer.Option(help="Frames rendered before measuring.")] = 5,
    batch: Annotated[
        int | None, typer.Option(help="Frames of one launch for throughput on a GPU; 0: none. 16 when absent.")
    ] = None,
    error_frames: Annotated[int | None, typer.Option(help="Frames compared with the reference.")] = None,
    time_limit: Annotated[float | None, typer.Option(help="Seconds after which measuring stops.")] = None,
    kernel: Annotated[
        str | None,
        typer.Option(help="Kernel options; each technique takes those that it has.", metavar="NAME=VALUE,..."),
    ] = None,
    tier: Annotated[
        str,
        typer.Option(
            help="Of strict, fast and auto, separated by commas; auto measures which knobs are cheapest for the scene.",
            metavar="TIER,...",
        ),
    ] = "strict",
    table: Annotated[
        int, typer.Option(min=TIMES, max=KERNELS, help="2: times; 3: registers, occupancy and times of GPU kernels.")
    ] = TIMES,
    registers: Annotated[
        str | None,
        typer.Option(help="Register caps that --table 3 sweeps, separated by commas; 0: the compiler's choice."),
    ] = None,
    out: Annotated[Path | None, typer.Option(help="File for the result as JSON; `raywalk tables` reads it.")] = None,
    as_csv: Annotated[bool, typer.Option("--csv", help="Print the table as CSV.")] = False,
    as_json: Annotated[bool, typer.Option("--json", help="Print the result as JSON.")] = False,
) -> None:
    """Measure techniques on a scene's walkthrough; each time stands beside its error. `--table 3` measures GPU kernels
    under a sweep of register caps."""
    scene, (width, height) = scene_of(scene, table), size(size_)
    asked, tiers = kernel_of(kernel, table, registers), tiers_of(tier, table)
    numbers = {"width": width, "height": height, "frames": frames, "depth": depth, "repeats": repeats}
    numbers |= {"warmup": warmup, "time_limit_s": time_limit, "batch": batch, "error_frames": error_frames}
    if table == KERNELS:
        numbers |= {"batch": sweep.BATCH if batch is None else batch}
        numbers |= {"error_frames": sweep.ERROR_FRAMES if error_frames is None else error_frames}
    spec = spec_of(scene, techniques, modes or (sweep.MODES if table == KERNELS else MODES), **numbers)
    caps = sweep.caps_of(registers)
    if out is not None:
        writable_file(out)
    with connected(context) as client, job_bar(scene, width * height) as progress:
        if table == KERNELS:
            measured_ = measure_sweep(client, spec, progress, asked, caps)
        else:
            measured_ = [measure(client, spec, progress, asked, tiers)]
    for path, result in zip(files_of(out, len(measured_)), measured_, strict=True) if out is not None else ():
        path.write_text(result_json(result))
        messages().print(f"wrote {path}")
    show(table, measured_, as_csv, as_json)


def show(table: int, found: list[BenchmarkResult], as_csv: bool, as_json: bool) -> None:
    """The table in the form that is asked for; with the times, what is promised of them."""
    if as_json:
        return print_json(found[0] if len(found) == 1 else found)
    if as_csv:
        return typer.echo(table_text(table, found, "csv"), nl=False)
    console = results()
    console.print(terminal(TABLES[table](found)))
    for result in found if table == TIMES else ():
        for line in ratios(result):
            console.print(line)
