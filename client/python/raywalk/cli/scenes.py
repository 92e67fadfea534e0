"""raywalk scenes: list, info, fetch, load, upload, delete."""

import re
from pathlib import Path
from typing import Annotated

import typer
from rich.table import Table

from raywalk.cli.session import CleanGroup, connected, print_json, results
from raywalk.errors import RaywalkError
from raywalk.fetch import Outcome, fill, home_sources, mirror_sources
from raywalk.models import Scene
from raywalk.places import data_dir, scenes_dir
from raywalk.progress import ByteBars, bar, messages

app = typer.Typer(cls=CleanGroup, no_args_is_help=True)
Json = Annotated[bool, typer.Option("--json", help="Print JSON.")]


@app.command("list")
def list_(context: typer.Context, as_json: Json = False) -> None:
    """The catalogue, and uploaded scenes."""
    with connected(context) as client:
        scenes = client.list_scenes()
    if as_json:
        return print_json(scenes)
    results().print(scene_table(scenes))


@app.command()
def info(
    context: typer.Context,
    name: Annotated[str | None, typer.Argument(help="Name of a scene.")] = None,
    all_: Annotated[bool, typer.Option("--all", help="Every scene.")] = False,
    as_json: Json = False,
) -> None:
    """Everything that is known of a scene."""
    if (name is None) != all_:
        raise typer.BadParameter("give either the name of a scene or --all")
    with connected(context) as client:
        shown = client.list_scenes() if name is None else [client.get_scene(name)]
    if as_json:
        return print_json(shown if all_ else shown[0])
    for scene in shown:
        print_scene(scene)


@app.command()
def load(
    context: typer.Context,
    name: Annotated[str, typer.Argument(help="Name of a scene of the catalogue.")],
    triangles: Annotated[int | None, typer.Option(help="Triangle count of a procedural scene or stand-in.")] = None,
    as_json: Json = False,
) -> None:
    """Load a scene into the daemon (worth it with --server)."""
    with connected(context) as client, bar(f"loading {name}"):
        scene = client.load_scene(name, triangles)
    print_json(scene) if as_json else print_scene(scene)


@app.command()
def upload(
    context: typer.Context,
    file: Annotated[
        Path,
        typer.Argument(
            help="One file, plain or gzip: AFF, glTF, MGF, OBJ, Open Inventor, VRML 1.0 or PLY. Files that it names "
            "are not sent with it.",
            exists=True,
            dir_okay=False,
        ),
    ],
    name: Annotated[str, typer.Option(help="Name that the scene will have.")],
    as_json: Json = False,
) -> None:
    """Upload a scene under a name of your own (worth it with --server)."""
    with connected(context) as client, bar(f"uploading {file.name}"):
        scene = client.upload_scene(name, file.read_bytes(), extension_of(file))
    print_json(scene) if as_json else print_scene(scene)


def extension_of(file: Path) -> str | None:
    """Of the file's name, where it can tell a format: "obj" of box.obj and of box.obj.gz."""
    suffix = Path(file.stem).suffix if file.suffix.lower() == ".gz" else file.suffix
    extension = suffix[1:].lower()
    return extension if re.fullmatch("[a-z0-9]{1,8}", extension) else None


@app.command()
def delete(context: typer.Context, name: Annotated[str, typer.Argument(help="Name of a loaded scene.")]) -> None:
    """Evict a scene and its structures."""
    with connected(context) as client:
        client.delete_scene(name)


@app.command()
def fetch(
    names: Annotated[list[str] | None, typer.Argument(help="Only these; all when absent.")] = None,
    mirror: Annotated[
        Path | None, typer.Option("--from", help="Mirror: a folder of archives with SHA256SUMS.", file_okay=False)
    ] = None,
    data: Annotated[
        Path | None, typer.Option(help="Folder to fill; RAYWALK_SCENE_DATA or scenes/data when absent.")
    ] = None,
) -> None:
    """Get the original scene data: from a mirror folder, else from the public homes that the manifests name."""
    folder = data or data_dir()
    sources = mirror_sources(mirror) if mirror else home_sources(scenes_dir())
    known = [source.name for source in sources]
    if unknown := [name for name in names or [] if name not in known]:
        raise RaywalkError(f"no such scene data: {', '.join(unknown)}; known: {', '.join(known) or 'none'}")
    console = messages()
    marks = {
        "fetched": "[green]fetched[/]",
        "there": "there  ",
        "kept": "[yellow]kept[/]   ",
        "failed": "[red]FAILED[/] ",
    }

    def say(outcome: Outcome) -> None:
        console.print(f"{marks[outcome.state]} {outcome.name}{': ' + outcome.detail if outcome.detail else ''}")

    with ByteBars(console) as watcher:
        outcomes = fill([source for source in sources if not names or source.name in names], folder, watcher, say)
    failed = [outcome.name for outcome in outcomes if outcome.state == "failed"]
    if failed:
        raise RaywalkError(f"not fetched: {', '.join(failed)}; the rest is in {folder}")
    console.print(f"{len(outcomes)} in {folder}")


def scene_table(scenes: list[Scene]) -> Table:
    table = Table(box=None, padding=(0, 2, 0, 0))
    for heading, justify in (("name", "left"), ("triangles", "right"), ("lights", "right"), ("fidelity", "left")):
        table.add_column(heading, justify=justify)
    table.add_column("title")
    for scene in scenes:
        mark = "● " if scene.loaded else ""
        fidelity = "no data" if scene.available is False else scene.fidelity
        cells = (scene.name, f"{scene.triangles:,}", str(scene.lights), fidelity, mark + scene.title)
        table.add_row(*cells)
    return table


def print_scene(scene: Scene) -> None:
    console = results()
    console.print(f"[bold]{scene.name}[/]  {scene.title}")
    facts = scene.model_dump(exclude={"name", "title", "paper", "warnings"}, exclude_none=True)
    for key, value in facts.items():
        if value != "":
            console.print(f"  {key:13} {value:,}" if type(value) is int else f"  {key:13} {value}")
    for warning in scene.warnings:
        console.print(f"  [yellow]warning[/]       {warning}")
