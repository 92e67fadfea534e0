"""Says why figures of Table 1 differ from the paper's by more than 25 %, from the figures themselves."""

from collections.abc import Mapping

from raywalk.models import BenchmarkResult, ResultRow, Structure
from raywalk.tables.paper import Paper

NOTABLE = 0.25
TRIANGLE_BYTES, REFERENCE_BYTES, OFFSET_BYTES = 48, 4, 4
WHY_REFERENCES = {
    "grid": "counted at the paper's cells, by bounding boxes where the options do not say otherwise, as in the scenes "
    "where both agree; the paper's own geometry must lie otherwise",
    "kdtree": "triangles are clipped to their cells before the next split (perfect splits), and the paper's cost "
    "constants are not given",
}
NODE_BYTES = {"kdtree": 8, "bvh": 64}


def differences(result: BenchmarkResult, counted: Mapping[str, ResultRow]) -> list[str]:
    """One note for each figure of a structure that is off by more than NOTABLE, and one for all steps and tests.
    `counted` are the rows, by structure, whose steps and tests stand in the table."""
    paper = Paper(result.scene.paper)
    notes = []
    for structure in result.structures:
        name = f"{result.scene.name} {structure.kind}"
        if structure.kind not in ("grid", "kdtree", "bvh"):
            continue
        ours, theirs = (structure.leaves or 0) / 1e3, paper.structure(structure.kind, "leaves") or 0
        if structure.kind != "grid" and notable(ours, theirs / 1e3):
            reason = why_leaves(structure, result.scene.triangles, ours < theirs / 1e3)
            notes.append(f"{name}: {compared(ours, theirs / 1e3, 'thousand leaves')}: {reason}.")
        ours = structure.references_per_triangle or 0
        theirs = paper.structure(structure.kind, "references_per_triangle")
        if notable(ours, theirs):
            notes.append(
                f"{name}: {compared(ours, theirs, 'references a triangle')}: {WHY_REFERENCES[structure.kind]}."
            )
        ours, theirs = (structure.size_bytes or 0) / 1e6, paper.structure(structure.kind, "megabytes")
        if notable(ours, theirs):
            reason = why_megabytes(structure, result.scene.triangles, paper)
            notes.append(f"{name}: {compared(ours, theirs, 'MB')}: {reason}.")
    return notes + count_note(result, counted, paper)


def count_note(result: BenchmarkResult, counted: Mapping[str, ResultRow], paper: Paper) -> list[str]:
    """Steps and tests depend on the views as much as on the structures, and the paper does not give its own."""
    off = []
    for kind, row in counted.items():
        for figure, ours in (("steps", row.steps_per_ray or 0), ("tests", row.tests_per_ray or 0)):
            theirs = paper.structure(kind, figure)
            if notable(ours, theirs):
                off.append(f"{kind} {figure} {100 * (ours / theirs - 1):+.0f} %")
    if not off:
        return []
    spec = result.spec
    return [
        f"{result.scene.name}, steps and tests ({', '.join(off)}): {spec.frames} frames of our walkthrough at "
        f"{spec.width}x{spec.height}; the paper gives neither its views nor the share of secondary rays in its counts, "
        "and its tests follow from leaves of another size."
    ]


def notable(ours: float, theirs: float | None) -> bool:
    return bool(ours and theirs) and abs(ours / theirs - 1) > NOTABLE


def compared(ours: float, theirs: float, unit: str) -> str:
    return f"{ours:.2f} {unit}, the paper {theirs:.2f} ({100 * (ours / theirs - 1):+.0f} %)"


def settings(structure: Structure) -> str:
    """The build options, in brackets."""
    shown = (f"{k} {v:g}" if isinstance(v, (int, float)) else f"{k} {v}" for k, v in structure.options.items())
    return f" ({', '.join(shown)})" if structure.options else ""


def why_leaves(structure: Structure, triangles: int, fewer: bool) -> str:
    per_leaf = (structure.references or triangles) / max(1, structure.leaves or 1)
    if structure.kind == "kdtree":
        sampled = structure.options.get("sah") in ("sampled", 1)
        heuristic = "sampled surface area heuristic" if sampled else "exact surface area heuristic, perfect splits"
        way = "stops earlier" if fewer else "splits further"
        return (
            f"{heuristic} and our cost constants: it {way} than the paper's sampled one, whose constants are not "
            f"given; {per_leaf:.2f} references a leaf{settings(structure)}"
        )
    return (
        f"{per_leaf:.2f} triangles a leaf by our cost constants and largest leaf{settings(structure)}, the paper's "
        f"leaves are {'smaller' if fewer else 'larger'}"
    )


def why_megabytes(structure: Structure, triangles: int, paper: Paper) -> str:
    """Splits the size into its parts by the layouts in kernels/accel."""
    total, references = (structure.size_bytes or 0) / 1e6, structure.references or 0
    listed = REFERENCE_BYTES * references / 1e6
    if structure.kind == "bvh":
        copied = TRIANGLE_BYTES * (references or triangles) / 1e6
        return (
            f"{copied:.2f} MB are triangles of {TRIANGLE_BYTES} bytes copied in leaf order, which the paper keeps "
            f"outside; {total - copied:.2f} MB are nodes of {NODE_BYTES['bvh']} bytes with both children's boxes"
        )
    if structure.kind == "kdtree":
        nodes = NODE_BYTES["kdtree"] * (structure.nodes or 0) / 1e6
        return (
            f"{nodes:.2f} MB are {structure.nodes or 0} nodes of {NODE_BYTES['kdtree']} bytes and {listed:.2f} MB are "
            f"{references} references of {REFERENCE_BYTES} bytes{paper_kdtree(paper)}"
        )
    cells = OFFSET_BYTES * (structure.nodes or 0) / 1e6
    return (
        f"{cells:.2f} MB are an offset of {OFFSET_BYTES} bytes a cell and {listed:.2f} MB are {references} references "
        f"of {REFERENCE_BYTES} bytes; the paper does not give its layout"
    )


def paper_kdtree(paper: Paper) -> str:
    """What the paper's own counts would take in our form; its figure must hold something else too."""
    leaves, share = paper.structure("kdtree", "leaves"), paper.structure("kdtree", "references_per_triangle")
    if not (leaves and share and paper.triangles):
        return ""
    own = (NODE_BYTES["kdtree"] * 2 * leaves + REFERENCE_BYTES * share * paper.triangles) / 1e6
    return f"; the paper's leaves and references would take {own:.2f} MB in that form"
