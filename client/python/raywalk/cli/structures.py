"""raywalk structures: list, build, delete, kinds."""

from typing import Annotated

import typer
from rich.table import Table

from raywalk.cli.session import CleanGroup, connected, options, print_json, results
from raywalk.follow import built
from raywalk.models import Structure
from raywalk.progress import bar

app = typer.Typer(cls=CleanGroup, no_args_is_help=True)
Json = Annotated[bool, typer.Option("--json", help="Print JSON.")]


@app.command("list")
def list_(context: typer.Context, as_json: Json = False) -> None:
    """Structures that are resident or being built."""
    with connected(context) as client:
        structures = client.list_structures()
    print_json(structures) if as_json else results().print(structure_table(structures))


@app.command()
def kinds(context: typer.Context, as_json: Json = False) -> None:
    """Kinds of structures with their build options, and their traversals."""
    with connected(context) as client:
        found = client.get_kinds()
    if as_json:
        return print_json(found)
    console = results()
    for kind in found:
        console.print(f"[bold]{kind.name}[/]  {kind.help}")
        for traversal in kind.traversals:
            console.print(f"  {kind.name}/{traversal.name:16} {traversal.help}")
        for option in kind.options:
            console.print(f"  -o {option.name}={option.default}  [dim]{option.help}[/]")


@app.command()
def build(
    context: typer.Context,
    scene: Annotated[str, typer.Argument(help="Name of a scene; it is loaded first.")],
    kind: Annotated[str, typer.Argument(help="Kind of structure.")],
    option: Annotated[list[str] | None, typer.Option("-o", "--option", help="Build option name=value.")] = None,
    as_json: Json = False,
) -> None:
    """Build a structure over a scene and show its figures."""
    wanted = options(option)
    with connected(context) as client, bar(f"building {kind} of {scene}"):
        client.load_scene(scene)
        structure = built(client, scene, kind, wanted)
    print_json(structure) if as_json else results().print(structure_table([structure]))


@app.command()
def delete(context: typer.Context, structure: Annotated[str, typer.Argument(help="Id of a structure.")]) -> None:
    """Evict one structure."""
    with connected(context) as client:
        client.delete_structure(structure)


def structure_table(structures: list[Structure]) -> Table:
    table = Table(box=None, padding=(0, 2, 0, 0))
    table.add_column("id")
    table.add_column("state")
    for heading in ("nodes", "leaves", "refs", "refs/triangle", "MB", "depth", "build ms"):
        table.add_column(heading, justify="right")
    for one in structures:
        counts = [f"{count:,}" if count is not None else "" for count in (one.nodes, one.leaves, one.references)]
        refs = f"{one.references_per_triangle:.2f}" if one.references_per_triangle is not None else ""
        megabytes = f"{one.size_bytes / 1e6:.2f}" if one.size_bytes is not None else ""
        depth = str(one.max_depth) if one.max_depth is not None else ""
        build_ms = f"{one.build_ms:.1f}" if one.build_ms is not None else ""
        state = one.state if not one.error else f"{one.state}: {one.error}"
        table.add_row(one.id, state, *counts, refs, megabytes, depth, build_ms)
    return table
