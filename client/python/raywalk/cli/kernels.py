"""raywalk kernels: registers, stack, spills and shared memory of every GPU kernel, without a GPU."""

import re
from pathlib import Path
from typing import Annotated

import typer
from rich import box
from rich.table import Table

from raywalk.cli.session import print_json, results, words, writable_file
from raywalk.errors import RaywalkError
from raywalk.kernels import Listing, committed_file, compile_kernels, differences, read_file, write_file
from raywalk.progress import bar, messages

ARCHITECTURES = "sm_80,sm_90,sm_100,sm_120"
SHOWN = 40  # differences


def architectures_of(text: str) -> list[str]:
    found = list(dict.fromkeys(words(text)))
    if not found or not all(re.fullmatch(r"sm_\d{2,3}[af]?", name) for name in found):
        raise typer.BadParameter(f"{text!r} are no architectures like {ARCHITECTURES}")
    return found


def kernels(
    arch: Annotated[
        str | None, typer.Option(help=f"Architectures, separated by commas; {ARCHITECTURES} when absent.")
    ] = None,
    check: Annotated[bool, typer.Option("--check", help="Compare with the committed table; exits with 1.")] = False,
    write: Annotated[bool, typer.Option("--write", help="Renew the committed table.")] = False,
    table: Annotated[Path | None, typer.Option(help="Another table than tests/gpu/kernels.csv.")] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON.")] = False,
) -> None:
    """Compile every GPU kernel and list what the assembler says of it; needs NVRTC but no GPU."""
    if check + write + as_json > 1:
        raise typer.BadParameter("--check, --write and --json exclude each other")
    if write and arch is not None:
        raise typer.BadParameter("--write renews the whole table: it takes no --arch")
    wanted = architectures_of(arch or ARCHITECTURES)
    committed = read_file(table or committed_file()) if check else None
    with bar(f"compiling the kernels for {', '.join(wanted)}"):
        found = compile_kernels(wanted)
    if committed is not None:
        return tell(differences(committed, found, wanted), found, table or committed_file())
    if write:
        path = writable_file(table or committed_file())
        write_file(path, found)
        return messages().print(f"wrote {path}: {len(found.kernels)} kernels by NVRTC {found.nvrtc}")
    print_json(found) if as_json else results().print(kernel_table(found))


def tell(said: list[str], found: Listing, path: Path) -> None:
    if not said:
        return messages().print(f"{len(found.kernels)} kernels by NVRTC {found.nvrtc} are as {path} has them")
    for line in said[:SHOWN]:
        typer.echo(line)
    if len(said) > SHOWN:
        typer.echo(f"and {len(said) - SHOWN} more")
    raise RaywalkError(f"{len(said)} kernels differ from {path}; raywalk kernels --write renews it")


def kernel_table(listing: Listing) -> Table:
    shown = Table(
        title=f"GPU kernels by NVRTC {listing.nvrtc}; bytes of stack, spills and shared memory",
        title_justify="left",
        box=box.SIMPLE_HEAD,
        padding=(0, 1, 0, 0),
    )
    for heading in ("architecture", "program", "traversal", "mode", "triangle test", "entry"):
        shown.add_column(heading, no_wrap=True)
    for heading in ("features", "block", "cap", "registers", "stack", "spill stores", "spill loads", "shared"):
        shown.add_column(heading, justify="right", no_wrap=True)
    for one in listing.kernels:
        names = [one.architecture, one.program, one.traversal, one.mode or "", one.intersector, one.entry]
        figures = [one.features, one.block, one.registers_cap or "none", one.registers, one.stack_bytes]
        figures += [one.spill_store_bytes, one.spill_load_bytes, one.shared_bytes]
        shown.add_row(*names, *(str(figure) for figure in figures))
    return shown
