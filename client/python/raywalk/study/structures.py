"""Table 1 and Table 3 of a study: the tables that `raywalk tables` prints, under the study's own line."""

from raywalk.study.collect import Study
from raywalk.study.measure import grid_options
from raywalk.tables.paper import Paper
from raywalk.tables.table import Table
from raywalk.tables.table1 import table1
from raywalk.tables.table3 import table3


def structure_table(study: Study) -> Table:
    table = table1(study.all_results)
    table.machine = study.line
    other = [
        result.scene.name
        for result in study.all_results
        if Paper(result.scene.paper).has_structures and grid_options(result.scene) is None
    ]
    if other:
        table.notes.append(
            f"{', '.join(other)}: the paper's grid cells would be no cubes in this scene's box, so the builder chose."
        )
    return table


def kernel_table(study: Study) -> Table:
    """Throws RaywalkError without results of a GPU."""
    table = table3(study.kernels)
    table.machine = study.line
    return table
