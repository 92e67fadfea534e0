"""A table as data, and its two forms for people: Markdown and the terminal."""

from dataclasses import dataclass, field

from rich import box
from rich.markup import escape
from rich.table import Table as RichTable

Cell = str | int | float | None
NONE = "—"


@dataclass(frozen=True)
class Column:
    """`group` is the heading that neighbours share; `digits` is how numbers are rounded (None: as they are); an
    `optional` column is dropped where no row fills it."""

    name: str
    group: str = ""
    digits: int | None = None
    left: bool = False
    optional: bool = False

    @property
    def title(self) -> str:
        return f"{self.group} {self.name}".strip()

    def show(self, cell: Cell) -> str:
        if cell is None:
            return NONE
        if isinstance(cell, float) and self.digits is not None:
            return f"{cell:,.{self.digits}f}".replace(",", " ") if abs(cell) >= 1e5 else f"{cell:.{self.digits}f}"
        return str(cell)


@dataclass
class Table:
    """`machine` is the short line that says where the figures come from."""

    title: str
    machine: str
    columns: list[Column]
    rows: list[list[Cell]] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    sections: set[int] = field(default_factory=set)  # rows that a rule precedes on the terminal
    best: set[int] = field(default_factory=set)  # rows set off as the best of their group
    best_cells: set[tuple[int, int]] = field(default_factory=set)  # (row, column) set off within a row

    def drop_empty(self) -> None:
        """Drops the optional columns without a cell."""
        kept = [
            number
            for number, column in enumerate(self.columns)
            if not column.optional or any(row[number] is not None for row in self.rows)
        ]
        self.best_cells = {(row, kept.index(column)) for row, column in self.best_cells if column in kept}
        self.columns = [self.columns[number] for number in kept]
        self.rows = [[row[number] for number in kept] for row in self.rows]

    def shown(self, row: int) -> list[tuple[str, bool]]:
        """The cells of a row as they are shown, each with whether it is set off."""
        cells = [column.show(cell) for column, cell in zip(self.columns, self.rows[row], strict=True)]
        return [
            (cell, cell not in ("", NONE) and (row in self.best or (row, column) in self.best_cells))
            for column, cell in enumerate(cells)
        ]


def markdown(table: Table) -> str:
    lines = [table.machine, "", f"**{table.title}**", ""]
    lines.append("| " + " | ".join(column.title for column in table.columns) + " |")
    lines.append("|" + "|".join("---" if column.left else "---:" for column in table.columns) + "|")
    for number in range(len(table.rows)):
        cells = [(cell.replace("|", "\\|"), best) for cell, best in table.shown(number)]
        lines.append("| " + " | ".join(f"**{cell}**" if best else cell for cell, best in cells) + " |")
    lines += [""] + [f"- {note}" for note in table.notes] if table.notes else []
    return "\n".join(lines) + "\n"


def terminal(table: Table) -> RichTable:
    caption = "\n".join(f"• {escape(note)}" for note in table.notes)
    shown = RichTable(
        title=f"[not italic][bold]{escape(table.title)}[/]\n[dim]{escape(table.machine)}[/][/]",
        caption=caption,
        caption_justify="left",
        title_justify="left",
        box=box.SIMPLE_HEAD,
        padding=(0, 1, 0, 0),
    )
    for column in table.columns:
        heading = f"[cyan]{column.group}[/]\n{column.name}" if column.group else f"\n{column.name}"
        shown.add_column(heading, justify="left" if column.left else "right", no_wrap=True)
    for number in range(len(table.rows)):
        if number in table.sections:
            shown.add_section()
        cells = [(escape(cell), best) for cell, best in table.shown(number)]
        shown.add_row(*(f"[bold green]{cell}[/]" if best else cell for cell, best in cells))
    return shown
