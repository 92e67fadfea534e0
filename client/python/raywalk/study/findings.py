"""FINDINGS.md: what the study finds on this device, from its figures alone."""

from raywalk.gate import open_notes
from raywalk.study.collect import Study
from raywalk.study.names import FAMILIES, NAMES, RAYS
from raywalk.study.prose import differences, errors, headline, held, missing
from raywalk.study.verdict import Finding, findings
from raywalk.study.winners import Win, winners

NOTE = (
    "A structure's time is that of its fastest technique ({members}); the factor is the next structure's time over it. "
    "An open row, which has more wrong rays than its tier allows, cannot win. Even: within the interval or 3.5 %, what "
    "repeats of one frame may spread. Intervals are 95 % bootstrap intervals over the frames of the walkthrough; means "
    "over scenes are geometric."
)


def note() -> str:
    return NOTE.format(
        members="; ".join(f"{family}: {', '.join(NAMES[one] for one in all_)}" for family, all_ in FAMILIES.items())
    )


def findings_markdown(study: Study) -> str:
    wins, found = winners(study.all_results), findings(study.all_results)
    lines = ["# Findings", "", study.line, "", f"**{headline(wins)}** {held(found)}", ""]
    lines += [f"- {said}" for said in missing(study)]
    lines += ["", "## Which structure wins", "", note(), "", *wins_table(wins), ""]
    lines += ["## The paper's conclusions", ""]
    for one in found:
        lines += conclusion(one)
    lines += ["## How wrong", ""]
    lines += [f"- {said}." for said in errors(study.all_results)]
    lines += [f"- {said}" for said in open_notes(study.all_results)]
    lines += ["", "## How each scene differs from the paper's", ""]
    lines += [f"- **{one.scene.name}**: {' '.join(differences(one.scene))}" for one in study.all_results]
    return "\n".join(lines) + "\n"


def wins_table(wins: list[Win]) -> list[str]:
    modes = [mode for mode in RAYS if any(win.mode == mode for win in wins)]
    lines = ["| scene | " + " | ".join(RAYS[mode] for mode in modes) + " |", "|---" * (1 + len(modes)) + "|"]
    for scene in dict.fromkeys(win.scene for win in wins):
        by_mode = {win.mode: win for win in wins if win.scene == scene}
        cells = [by_mode[mode].words if mode in by_mode else "—" for mode in modes]
        lines.append(f"| {scene} | " + " | ".join(cells) + " |")
    return lines


def conclusion(one: Finding) -> list[str]:
    return [
        f"### {one.conclusion.words} — {one.here.verdict}",
        "",
        f"- The paper ({one.conclusion.source}); compared: {one.conclusion.asks}.",
        f"- Here: **{one.here.verdict}**: {one.here.why}.",
        f"- By the paper's own tables, the same scenes: {one.paper.verdict}: {one.paper.why}.",
        "",
    ]
