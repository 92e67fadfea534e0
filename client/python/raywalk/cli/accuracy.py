"""raywalk accuracy: the hard cases, and speed against error."""

from pathlib import Path
from typing import Annotated

import typer

from raywalk.accuracy.files import write_accuracy
from raywalk.accuracy.tables import cases_table, sweep_table
from raywalk.cli.session import connected, results, writable_folder
from raywalk.errors import RaywalkError
from raywalk.follow import accuracy as measured
from raywalk.models import AccuracyResult, AccuracySpec
from raywalk.progress import messages, stage_bar
from raywalk.tables import terminal

SCENES = ("bunny", "robots", "conference")


def accuracy(
    context: typer.Context,
    scene: Annotated[
        list[str] | None, typer.Option(help=f"Of the sweep, may be repeated; {', '.join(SCENES)} when absent.")
    ] = None,
    quick: Annotated[bool, typer.Option("--quick", help="Fewer rays, launches and combinations of knobs.")] = False,
    rays: Annotated[int | None, typer.Option(min=64, max=10_000_000, help="Of each class of rays.")] = None,
    seed: Annotated[int, typer.Option(min=0, max=4294967295, help="Of the rays.")] = 1,
    cases: Annotated[bool, typer.Option("--cases/--no-cases", help="The forty hard cases.")] = True,
    time_limit: Annotated[float | None, typer.Option(help="Seconds of each scene and of the cases.")] = None,
    out: Annotated[Path, typer.Option(help="Folder for accuracy.json, tables and charts.")] = Path("out/accuracy"),
) -> None:
    """The forty hard cases, and on scenes speed against error: every technique with every set of knobs, judged by exact
    arithmetic. Fails when a strict technique fails a hard case."""
    folder = writable_folder(out)
    common = {"quick": quick, "seed": seed} | ({"time_limit_s": time_limit} if time_limit else {})
    specs = [AccuracySpec.model_validate(common | {"hard_cases": True})] if cases else []
    numbers = {"rays": rays} if rays else {}
    for name in list(dict.fromkeys(scene or SCENES)):
        specs.append(AccuracySpec.model_validate(common | numbers | {"scene": name, "hard_cases": False}))
    found: list[AccuracyResult] = []
    with connected(context) as client:
        for spec in specs:
            with stage_bar(spec.scene or "hard cases") as progress:
                found.append(measured(client, spec, progress))
            names = write_accuracy(found, folder)  # each time: a later scene may be interrupted
    for result in found:
        table = cases_table(result) if result.cases else sweep_table(result, brief=True)
        results().print(terminal(table))
    messages().print(f"wrote {', '.join(names)} in {folder}", markup=False)
    if broken := [case for result in found for case in result.cases if case.strict and case.failures]:
        first = broken[0]
        name = f"{first.structure}/{first.traversal}"
        raise RaywalkError(f"{name} fails hard case {first.number} ({first.title}): {first.first_failure}")
