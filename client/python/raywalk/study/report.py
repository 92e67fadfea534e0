"""report.html: the whole study on one page that needs nothing else."""

from html import escape

from raywalk.accuracy.chart import chart
from raywalk.accuracy.drawing import svg_of
from raywalk.accuracy.tables import machine_line, sweep_table
from raywalk.gate import open_notes
from raywalk.study.charts import bar_chart, line_chart
from raywalk.study.collect import Picture, Study
from raywalk.study.findings import note
from raywalk.study.html import VERDICTS, bullets, chip, paragraph, table_html, tag
from raywalk.study.names import NAMES, RAYS
from raywalk.study.parameters import IMAGE_FIGURES, RESOLUTION_FIGURES
from raywalk.study.pictures import data_url
from raywalk.study.prose import differences, errors, headline, held, missing
from raywalk.study.structures import kernel_table, structure_table
from raywalk.study.style import CSS
from raywalk.study.svg import CLASSES
from raywalk.study.times import time_tables
from raywalk.study.verdict import Finding, Ruling, findings
from raywalk.study.winners import Win, winners
from raywalk.tables.gpu import telemetry_notes
from raywalk.tables.paper import PAPER_DEVICE

TITLE = "Grid, kd-tree or BVH?"
PAPER = "M. Zlatuška and V. Havran, Ray Tracing on a GPU with CUDA – Comparative Study of Three Algorithms, WSCG 2010"
PLACES = {
    "findings": "Findings",
    "winners": "Who wins",
    "times": "Times",
    "structures": "Structures",
    "kernels": "Kernels",
    "resolution": "Resolution",
    "accuracy": "Speed against error",
    "images": "Images",
    "scenes": "Scenes",
    "again": "Measure again",
}


def report_html(study: Study) -> str:
    wins, found = winners(study.all_results), findings(study.all_results)
    sections = {
        "findings": findings_section(study, found),
        "winners": winners_section(wins),
        "times": times_section(study),
        "structures": table_html(structure_table(study)) if study.results else "",
        "kernels": table_html(kernel_table(study)) if study.kernels else "",
        "resolution": resolution_section(study),
        "accuracy": accuracy_section(study),
        "images": images_section(study),
        "scenes": scenes_section(study),
        "again": again_section(study),
    }
    present = {name: inner for name, inner in sections.items() if inner}
    links = "".join(tag("a", PLACES[name], href=f"#{name}") for name in present)
    body = header(study, wins, found) + tag("nav", links)
    body += "".join(tag("section", tag("h2", PLACES[name]) + inner, id=name) for name, inner in present.items())
    head = '<meta charset="utf-8"><meta name="viewport" content="width=device-width,initial-scale=1">'
    head += tag("title", f"Raywalk: {escape(TITLE)}") + tag("style", CSS)
    return f'<!doctype html>\n<html lang="en"><head>{head}</head><body>{tag("main", body)}</body></html>\n'


def header(study: Study, wins: list[Win], found: list[Finding]) -> str:
    own = study.parameters
    facts = {
        "Scenes": f"{len(study.results)} of {len(own.scenes)}",
        "Frames": f"{own.frames} a walkthrough, {own.size}",
    }
    if study.machine:
        seen = study.machine
        facts = {"Device": seen.device} | facts
        facts |= {"Threads": str(seen.threads)} if not seen.device_details else {}
        facts |= {name.capitalize(): value for name, value in sorted((seen.device_details or {}).items())}
        facts |= {"System": f"{seen.os}, {seen.kernel}", "Raywalk": f"{seen.version}, commit {seen.git_commit[:12]}"}
    days = sorted({result.created_at[:10] for result in study.all_results})
    facts |= {"Measured": " to ".join(dict.fromkeys([days[0], days[-1]]))} if days else {}
    facts["Rays"] = ", ".join(own.modes)
    listed = "".join(tag("div", tag("dt", escape(name)) + tag("dd", escape(value))) for name, value in facts.items())
    said = missing(study)
    notice = tag("div", bullets(said), "notice") if said else ""
    return tag(
        "header",
        paragraph(f"{TITLE} The study of 2010, measured again", "over")
        + tag("h1", escape(headline(wins)))
        + paragraph(held(found) if wins else "", "lead")
        + tag("dl", listed)
        + notice,
    )


def findings_section(study: Study, found: list[Finding]) -> str:
    if not study.results:
        return ""
    cards = "".join(card(one) for one in found)
    wrong = tag("h3", "How wrong") + bullets(
        [f"{said}." for said in errors(study.all_results)] + open_notes(study.all_results)
    )
    intro = f"What {PAPER} concluded from a {PAPER_DEVICE}, against the figures of this device."
    return paragraph(intro, "faint") + tag("div", cards, "cards") + wrong


def card(one: Finding) -> str:
    inner = chip(one.here.verdict, VERDICTS[one.here.verdict]) + tag("h3", escape(one.conclusion.words))
    inner += paragraph(f"{one.here.mean.value:.2f}x" if one.here.mean else "—", "large")
    inner += paragraph(f"{one.conclusion.asks}.", "faint")
    inner += paragraph(f"Here: {one.here.why}.")
    inner += paragraph(f"By the paper's own tables, the same scenes: {one.paper.verdict}: {one.paper.why}.", "faint")
    about = paragraph(f"The paper, {one.conclusion.source}.", "faint")
    return tag(
        "article", inner + tag("details", tag("summary", "what was compared") + about + evidence(one.here)), "card"
    )


def evidence(ruling: Ruling) -> str:
    rows = "".join(
        tag("tr", tag("th", escape(one.scene)) + tag("td", one.mode) + tag("td", escape(str(one.ratio))))
        for one in ruling.evidence
    )
    return tag("table", tag("tbody", rows))


def winners_section(wins: list[Win]) -> str:
    if not wins:
        return ""
    modes = [mode for mode in RAYS if any(win.mode == mode for win in wins)]
    head = tag("tr", tag("th", "scene", "left") + "".join(tag("th", RAYS[mode], "left") for mode in modes))
    rows = ""
    for scene in dict.fromkeys(win.scene for win in wins):
        by_mode = {win.mode: win for win in wins if win.scene == scene}
        cells = "".join(tag("td", win_cell(by_mode[mode]) if mode in by_mode else "—") for mode in modes)
        rows += tag("tr", tag("th", escape(scene)) + cells, "section")
    table = tag("table", tag("thead", head) + tag("tbody", rows), "wins")
    return paragraph(note(), "faint") + tag("div", table, "scroll", tabindex="0")


def win_cell(win: Win) -> str:
    name = f"{win.row.structure}/{win.row.traversal}"
    dot = tag("span", "", "dot", style=f"background:var(--{CLASSES[name][2:]})")
    if win.even:
        words = f"{tag('b', escape(win.family))} and {escape(win.second)}, even"
    else:
        words = f"{tag('b', escape(win.family))} {win.margin.value:.2f}x"
    by = "" if NAMES[name] == win.family else f"{NAMES[name]}; "
    return dot + words + tag("small", escape(f"{by}{win.margin.interval} over the {win.second}"))


def times_section(study: Study) -> str:
    charts = [chart for mode in RAYS if (chart := bar_chart(study, mode))]
    drawn = "".join(tag("div", chart, "box") for chart in charts)
    return drawn + "".join(table_html(table) for table in time_tables(study))


def resolution_section(study: Study) -> str:
    drawn = ""
    for number, scene in RESOLUTION_FIGURES.items():
        if scene in study.resolutions:
            drawn += tag("div", line_chart(study.resolutions[scene], resolution_title(study, number)), "box")
    if not drawn:
        return ""
    about = (
        "Time of a frame (median, ms) against its pixels; bars span the measured frames. The paper plots its times and "
    )
    return paragraph(about + "gives no numbers for them, so only ours are drawn.", "faint") + tag("div", drawn, "two")


def resolution_title(study: Study, number: int) -> str:
    scene = RESOLUTION_FIGURES[number]
    modes = study.resolutions[scene][0].spec.modes or ["primary"]
    return f"Figure {number}: {scene}, {RAYS[modes[-1]]}"


def accuracy_section(study: Study) -> str:
    if not study.accuracy:
        return ""
    about = "Every technique with every set of knobs on lists of rays, timed in turns and judged by exact arithmetic. "
    about += "Right is faster, lower is less often wrong; below the axis no ray was wrong."
    drawn = ""
    for result in study.accuracy.values():
        if result.rows:
            drawn += tag("div", svg_of(chart(result, machine_line(result)), standalone=False), "box")
            drawn += table_html(sweep_table(result, brief=True))
    return paragraph(about, "faint") + drawn


def images_section(study: Study) -> str:
    """In the order of the paper's figures, then other scenes."""
    ordered = [name for names in IMAGE_FIGURES.values() for name in names]
    names = [*ordered, *(name for name in study.pictures if name not in ordered)]
    figures = "".join(figure(study, study.pictures[name]) for name in names if name in study.pictures)
    return tag("div", figures, "gallery") if figures else ""


def figure(study: Study, picture: Picture) -> str:
    scene = study.scene(picture.scene)
    title = scene.title if scene else picture.scene
    number = next((number for number, names in IMAGE_FIGURES.items() if picture.scene in names), None)
    facts = [f"Figure {number}"] if number else []
    facts += [f"{scene.triangles:,} triangles"] if scene else []
    facts.append(f"frame {picture.frame} of {picture.of}")
    chips = chip(scene.fidelity, "plain") if scene else ""
    image = f'<img alt="{escape(title)}" width="{picture.width}" height="{picture.height}" src="{data_url(picture)}">'
    return tag("figure", image + tag("figcaption", f"{tag('b', escape(title))}{chips}<br>{escape(', '.join(facts))}"))


def scenes_section(study: Study) -> str:
    rows = "".join(
        tag(
            "article", tag("h3", escape(one.scene.title)) + paragraph(" ".join(differences(one.scene)), "faint"), "card"
        )
        for one in study.all_results
    )
    return tag("div", rows, "cards") if rows else ""


def again_section(study: Study) -> str:
    limit = study.parameters.time_limit_s
    said = [f"`{study.parameters.command}`"]
    said += [f"each scene was measured for at most {limit:g} s"] if limit else []
    said.append(f"all steps together took {study.seconds:.0f} s")
    said.append(f"the paper: {PAPER}")
    return bullets([f"{one}." for one in said] + telemetry_notes(study.all_results))
