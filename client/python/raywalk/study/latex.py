"""A table as LaTeX: a tabular with the rules of booktabs, to be read by \\input."""

from itertools import groupby

from raywalk.tables.table import Table

SPECIAL = {
    "\\": r"\textbackslash{}",
    "&": r"\&",
    "%": r"\%",
    "$": r"\$",
    "#": r"\#",
    "_": r"\_",
    "{": r"\{",
    "}": r"\}",
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
    "<": r"\textless{}",
    ">": r"\textgreater{}",
    "—": "---",
    "≤": r"$\leq$",
    "≥": r"$\geq$",
    "×": r"$\times$",
    "·": r"$\cdot$",
    "³": r"\textsuperscript{3}",
    "⁶": r"\textsuperscript{6}",
    "°": r"$^{\circ}$",
}


def escaped(text: str) -> str:
    """What stands for the text; characters that a plain LaTeX does not know become question marks."""
    letters = (SPECIAL.get(letter, letter if ord(letter) < 128 else "?") for letter in text)
    return "".join(letters)


def latex(table: Table) -> str:
    """Needs the package booktabs; title and notes are comments, for the caption of the document around it."""
    lines = ["% needs \\usepackage{booktabs}", f"% {comment(table.title)}", f"% {comment(table.machine)}"]
    lines.append(f"\\begin{{tabular}}{{{''.join('l' if column.left else 'r' for column in table.columns)}}}")
    lines += ["\\toprule", *headings(table), "\\midrule"]
    for number in range(len(table.rows)):
        if number in table.sections and number:
            lines.append("\\addlinespace")
        cells = [indented(text, best) for text, best in table.shown(number)]
        lines.append(" & ".join(cells) + r" \\")
    lines += ["\\bottomrule", "\\end{tabular}"]
    return "\n".join([*lines, *(f"% {comment(note)}" for note in table.notes)]) + "\n"


def comment(text: str) -> str:
    return " ".join(text.split())


def indented(text: str, best: bool) -> str:
    """A name that begins with spaces is set in, as on the terminal."""
    inner = escaped(text.strip())
    start = r"\quad " if text.startswith("  ") else ""
    return start + (f"\\textbf{{{inner}}}" if best else inner)


def headings(table: Table) -> list[str]:
    """The groups over their columns, then the columns' names."""
    cells, rules, first = [], [], 1
    for group, members in groupby(table.columns, key=lambda column: column.group):
        count = len(list(members))
        if group:
            cells.append(f"\\multicolumn{{{count}}}{{c}}{{{escaped(group)}}}")
            rules.append(f"\\cmidrule(lr){{{first}-{first + count - 1}}}")
        else:
            cells += [""] * count
        first += count
    names = " & ".join(escaped(column.name) for column in table.columns) + r" \\"
    return [names] if not rules else [" & ".join(cells) + r" \\", "".join(rules), names]
