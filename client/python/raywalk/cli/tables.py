"""raywalk tables: the study's tables from stored results."""

from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from raywalk.cli.session import results, writable_folder
from raywalk.progress import messages
from raywalk.tables import TABLES, csv_text, markdown, read_results, terminal, write_tables


class Form(StrEnum):
    MD = "md"
    CSV = "csv"
    TERM = "term"


def tables(
    files: Annotated[list[Path], typer.Argument(help="Results as `raywalk bench --out` writes them.")],
    number: Annotated[int | None, typer.Option("--table", min=1, max=2, help="Only this one.")] = None,
    form: Annotated[Form, typer.Option("--format", help="Form of the tables.")] = Form.TERM,
    out: Annotated[Path | None, typer.Option(help="Folder for table1 and table2; the terminal when absent.")] = None,
) -> None:
    """Tables 1 and 2 of the study, ours beside the paper's."""
    found = read_results(files)
    made = {one: TABLES[one](found) for one in TABLES if number in (None, one)}
    if out is not None:
        form = Form.MD if form == Form.TERM else form
        for path in write_tables(made, writable_folder(out), form.value):
            messages().print(f"wrote {path}")
        return
    for table in made.values():
        if form == Form.TERM:
            results().print(terminal(table))
        else:
            typer.echo(markdown(table) if form == Form.MD else csv_text(table))
