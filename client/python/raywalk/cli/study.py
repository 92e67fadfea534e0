"""raywalk study: the paper in one command."""

import time
from pathlib import Path
from typing import Annotated

import typer

from raywalk.cli.session import connected, results, size, words, writable_folder
from raywalk.errors import RaywalkError
from raywalk.progress import messages
from raywalk.study.collect import Study, collect
from raywalk.study.outputs import FINDINGS, REPORT, tables_of, write_all
from raywalk.study.parameters import parameters_of
from raywalk.study.prose import headline, held
from raywalk.study.run import Run, identity_of
from raywalk.study.store import Store
from raywalk.study.verdict import findings
from raywalk.study.winners import winners
from raywalk.tables import terminal


def study(
    context: typer.Context,
    scenes: Annotated[
        str | None, typer.Option(help="Names, separated by commas; the paper's nine when absent.")
    ] = None,
    frames: Annotated[
        int | None,
        typer.Option(
            min=1,
            max=100000,
            help="Frames of each walkthrough. When absent as many as a CPU measures in minutes, or the study's 400 "
            "on a GPU.",
        ),
    ] = None,
    size_: Annotated[
        str | None,
        typer.Option("--size", help="Pixels; 256x256 on a CPU, 1024x1024 on a GPU when absent.", metavar="WxH"),
    ] = None,
    modes: Annotated[
        str | None, typer.Option(help="Of primary, shadow and whitted, separated by commas; all when absent.")
    ] = None,
    out: Annotated[Path, typer.Option(help="Folder of the study; one that was stopped goes on there.")] = Path(
        "out/study"
    ),
    accuracy: Annotated[
        bool | None,
        typer.Option(
            "--accuracy/--no-accuracy",
            help="Measure speed against error on every scene too. When absent on a GPU alone: it adds half a minute a "
            "scene on a CPU.",
        ),
    ] = None,
    fresh: Annotated[
        bool, typer.Option("--fresh", help="Start over: drop what the folder's study has measured.")
    ] = False,
) -> None:
    """The paper in one command: Tables 1 to 3 and Figures 1 to 5 beside its figures, what is left of its conclusions on
    this device, and one report.html. Stopped at any time and started again it goes on where it was."""
    start = time.monotonic()
    shape = size(size_) if size_ is not None else None
    named = words(scenes) if scenes is not None else None
    rays = words(modes) if modes is not None else None
    parameters_of(named, rays, frames, shape, gpu=False)  # what is wrong is told before a daemon is started
    store = Store(writable_folder(out))
    with store.locked(), connected(context) as client:
        system = client.get_system()
        gpu = system.device.kind == "cuda"
        parameters = parameters_of(named, rays, frames, shape, gpu, accuracy)
        store.open(identity_of(parameters, system, client.list_scenes()), fresh)
        run = Run(client, store, parameters, gpu)
        try:
            run.run()
        except BaseException:  # Ctrl-C, a stop or a lost daemon: what there is makes a report
            finish(collect(store, parameters, gpu, run.failures), out)
            raise
        found = collect(store, parameters, gpu, run.failures)
    finish(found, out)
    for tables in tables_of(found).values():
        for table in tables:
            results().print(terminal(table))
    console = results()
    console.print(headline(winners(found.all_results)), soft_wrap=True)
    console.print(held(findings(found.all_results)), soft_wrap=True)
    messages().print(f"the study took {time.monotonic() - start:.0f} s; open {out / REPORT}, read {out / FINDINGS}")
    if found.failures:
        raise RaywalkError("\n".join(f"{name} is left out: {cause}" for name, cause in found.failures.items()))


def finish(found: Study, out: Path) -> None:
    names = write_all(found, out)
    messages().print(f"{found.finished} of {found.steps} steps; wrote {', '.join(names)} in {out}", markup=False)
