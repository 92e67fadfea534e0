"""raywalk tables: the study's tables from stored results."""

from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from raywalk.cli.session import results, writable_folder
from raywalk.progress import messages
from raywalk.tables import TABLES, read_results, table_text, tables_of, terminal, write_tables


class Form(StrEnum):
    MD = "md"
    CSV = "csv"
    TERM = "term"


def tables(
    files: Annotated[list[Path], typer.Argument(help="Results as `raywalk bench --out` writes them.")],
    number: Annotated[
        int | None, typer.Option("--table", min=1, max=3, help="Only this one; 3 needs results of a GPU.")
    ] = None,
    form: Annotated[Form, typer.Option("--format", help="Form of the tables.")] = Form.TERM,
    out: Annotated[Path | None, typer.Option(help="Folder for table1 and so on; the terminal when absent.")] = None,
) -> None:
    """Tables 1 and 2 of the study, and 3 where a GPU measured, ours beside the paper's."""
    if form == Form.CSV and out is None and number is None:
        raise typer.BadParameter("--format csv takes --table 1, 2 or 3, or --out for a file each")
    found = read_results(files)
    numbers = tables_of(found) if number is None else [number]
    if out is not None:
        form = Form.MD if form == Form.TERM else form
        for path in write_tables(numbers, found, writable_folder(out), form.value):
            messages().print(f"wrote {path}")
        return
    for one in numbers:
        if form == Form.TERM:
            results().print(terminal(TABLES[one](found)))
        else:
            typer.echo(table_text(one, found, form.value), nl=form == Form.MD)
