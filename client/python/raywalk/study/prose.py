"""What the study says in sentences: its headline, its errors, how each scene differs from the paper's."""

from collections import Counter
from collections.abc import Sequence

from raywalk.models import BenchmarkResult, ResultRow, Scene
from raywalk.study.collect import Study
from raywalk.study.names import NAMES
from raywalk.study.parameters import SCENES
from raywalk.study.verdict import Finding
from raywalk.study.winners import Win
from raywalk.tables.notes2 import reference_name
from raywalk.tables.paper import Paper

ORDER = ("grid", "kd-tree", "BVH")
ABOUT_FIDELITY = {
    "original": "the paper's own data",
    "derived": "made from the paper's data, with changes",
    "stand-in": "the paper's object was not at hand",
    "procedural": "generated; not a scene of the paper",
    "uploaded": "uploaded; not a scene of the paper",
}


def headline(wins: Sequence[Win]) -> str:
    if not wins:
        return "Nothing was measured yet."
    counts = Counter("even" if win.even else win.family for win in wins)
    ahead = sorted((name for name in ORDER if counts[name]), key=lambda name: -counts[name])
    if not ahead:
        return f"No structure is ahead in any of {len(wins)} pairs of scene and rays."
    parts = [f"the {ahead[0]} wins {counts[ahead[0]]}", *(f"the {name} {counts[name]}" for name in ahead[1:])]
    even = f"; {counts['even']} {'is' if counts['even'] == 1 else 'are'} even" if counts["even"] else ""
    return f"Of {len(wins)} pairs of scene and rays, {joined(parts)}{even}."


def joined(parts: Sequence[str]) -> str:
    return parts[0] if len(parts) == 1 else ", ".join(parts[:-1]) + " and " + parts[-1]


def held(found: Sequence[Finding]) -> str:
    counts = Counter(one.here.verdict for one in found)
    holds = "holds" if counts["holds"] == 1 else "hold"
    return (
        f"{counts['holds']} of the paper's {len(found)} conclusions {holds} on this device, "
        f"{counts['does not hold']} {'does' if counts['does not hold'] == 1 else 'do'} not, "
        f"{counts['undecided']} {'is' if counts['undecided'] == 1 else 'are'} undecided."
    )


def errors(results: Sequence[BenchmarkResult]) -> list[str]:
    """How wrong each technique was at worst, over all scenes and rays."""
    said = []
    for technique, name in NAMES.items():
        rows = [
            (result, row)
            for result in results
            for row in result.rows
            if f"{row.structure}/{row.traversal}" == technique
        ]
        if rows:
            said.append(f"{name}: {worst_of(rows)}")
    return said


def worst_of(rows: Sequence[tuple[BenchmarkResult, ResultRow]]) -> str:
    result, row = max(rows, key=lambda pair: pair[1].error.id_mismatch_ppm_upper95)
    rmse = max(row.error.image_rmse for _, row in rows)
    return (
        f"at worst {row.error.id_mismatch_ppm:.3g} ppm of primary rays hit another triangle (95 % interval up to "
        f"{row.error.id_mismatch_ppm_upper95:.3g}; {result.scene.name}), RMSE of the images up to {rmse:.2g}; against "
        f"{reference_name(row.error.reference)}"
    )


def differences(scene: Scene) -> list[str]:
    """How a scene differs from the study's of its name."""
    said = [f"{scene.fidelity}: {ABOUT_FIDELITY[scene.fidelity]}."]
    note = scene.fidelity_note
    said += [note if note.endswith(".") else f"{note}."] if note else []
    paper = Paper(scene.paper)
    if paper.has_structures:
        lights = counted(scene.lights, paper.lights, "light")
        said.append(f"{counted(scene.triangles, paper.triangles, 'triangle')}; {lights}.")
    else:
        said.append(f"{scene.triangles:,} triangles; {scene.lights} light{'' if scene.lights == 1 else 's'}.")
    if scene.source:
        said.append(f"Source: {scene.source}.")
    if scene.warnings:
        more = f" (and {len(scene.warnings) - 3} more)" if len(scene.warnings) > 3 else ""
        said.append(f"Warnings: {'; '.join(scene.warnings[:3])}{more}.")
    return said


def counted(ours: int, theirs: int | None, what: str) -> str:
    name = what if ours == 1 else f"{what}s"
    if theirs is None:
        return f"{ours:,} {name}"
    return f"{ours:,} {name}, as in the paper" if ours == theirs else f"{ours:,} {name}, the paper {theirs:,}"


def missing(study: Study) -> list[str]:
    """What a reader has to know before he trusts a study that is not whole."""
    said = []
    if not study.complete:
        said.append(
            f"{study.finished} of {study.steps} steps are finished; the same command goes on where this one stopped."
        )
    said += [f"{name} is left out: {cause}" for name, cause in study.failures.items()]
    absent = [name for name in SCENES if name not in study.parameters.scenes]
    if absent:
        said.append(f"not asked for: {', '.join(absent)}.")
    if stand_ins := [result.scene.name for result in study.all_results if result.scene.fidelity == "stand-in"]:
        said.append(
            f"generated stand-ins, whose figures show the method and not the paper's object: {', '.join(stand_ins)}."
        )
    return said
