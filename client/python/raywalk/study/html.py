"""Pieces of the report's page: escaped text, tables, chips."""

from html import escape
from itertools import groupby

from raywalk.tables.table import Table

VERDICTS = {"holds": "yes", "does not hold": "no", "undecided": "open"}  # classes of the chips
SHOWN_NOTES = 6


def tag(name: str, inner: str, class_: str = "", **attributes: str) -> str:
    """`inner` is markup."""
    given = {"class": class_} if class_ else {}
    shown = "".join(f' {key}="{escape(value)}"' for key, value in (given | attributes).items())
    return f"<{name}{shown}>{inner}</{name}>"


def paragraph(text: str, class_: str = "") -> str:
    return tag("p", code(text), class_)


def code(text: str) -> str:
    """Escaped, with what stands between backquotes as code."""
    pieces = escape(text, quote=False).split("`")
    return "".join(tag("code", piece) if number % 2 else piece for number, piece in enumerate(pieces))


def chip(text: str, class_: str) -> str:
    return tag("span", escape(text), f"chip {class_}")


def bullets(items: list[str]) -> str:
    return tag("ul", "".join(tag("li", code(item)) for item in items)) if items else ""


def table_html(table: Table) -> str:
    """Scrolls inside its box where it is wider than the page; notes below."""
    body = "".join(body_row(table, number) for number in range(len(table.rows)))
    whole = tag("table", tag("thead", heads(table)) + tag("tbody", body))
    return tag("h3", escape(table.title)) + tag("div", whole, "scroll", tabindex="0") + notes(table.notes)


def notes(said: list[str]) -> str:
    """Many of them open on demand."""
    if len(said) <= SHOWN_NOTES:
        return bullets(said)
    rest = said[SHOWN_NOTES:]
    return bullets(said[:SHOWN_NOTES]) + tag("details", tag("summary", f"{len(rest)} more notes") + bullets(rest))


def heads(table: Table) -> str:
    groups = ""
    if any(column.group for column in table.columns):
        for group, members in groupby(table.columns, key=lambda column: column.group):
            count = len(list(members))
            groups += tag("th", escape(group), "group" if group else "", colspan=str(count))
        groups = tag("tr", groups)
    names = "".join(tag("th", escape(column.name), "left" if column.left else "") for column in table.columns)
    return groups + tag("tr", names)


def body_row(table: Table, number: int) -> str:
    cells = ""
    for place, (column, (text, best)) in enumerate(zip(table.columns, table.shown(number), strict=True)):
        classes = " ".join(name for name, is_so in (("left", column.left), ("best", best)) if is_so)
        cells += tag("th" if place == 0 else "td", escape(text.strip()), classes)
    first = table.shown(number)[0][0]
    kind = "theirs" if first.startswith("  ") else ""
    return tag("tr", cells, f"{kind} {'section' if number in table.sections else ''}".strip())
