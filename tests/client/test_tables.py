"""The study's tables from a stored result."""

import csv
import io

import pytest
from raywalk.errors import RaywalkError
from raywalk.ratios import ratios
from raywalk.tables import markdown, read_results, table1, table2, table_text
from raywalk.tables.machine import machine_line

STAND_IN = {"fidelity": "stand-in"}


def rows_of(table) -> list[dict[str, str]]:
    """Cells by the titles of their columns, as they are shown, figures unrounded."""
    titles = [column.title for column in table.columns]
    assert table.machine.startswith("A processor, 2 threads, commit 0123456789ab, 2026-11-22, `raywalk bench bunny")
    return [dict(zip(titles, ["" if cell is None else str(cell) for cell in row], strict=True)) for row in table.rows]


def records_of(number: int, results) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(table_text(number, results, "csv"))))


def other_run(result, modes=("trace",)):
    """A smaller run of the same scene, with fewer frames and modes."""
    spec = result.spec.model_copy(update={"width": 64, "height": 32, "frames": 3, "modes": list(modes)})
    rows = [row.model_copy(deep=True) for row in result.rows if row.mode in modes]
    for row in rows:
        row.error.frames = 3
    return result.model_copy(update={"spec": spec, "rows": rows})


def test_machine_line_names_the_command(result) -> None:
    command = (
        "raywalk bench bunny --frames 8 --size 512x512 --modes trace,primary,shadow,whitted --repeats 1 --warmup 5"
    )
    assert f"`{command}`" in machine_line([result])


def test_machine_line_warns_of_different_machines(result) -> None:
    other = result.model_copy(update={"machine": result.machine.model_copy(update={"fingerprint": "other"})})
    assert machine_line([result, other]).startswith("DIFFERENT MACHINES")


def test_table1_stands_beside_the_paper(result) -> None:
    ours, paper = rows_of(table1([result]))
    assert ours["scene"] == "bunny (original)"
    assert (ours["grid cells"], paper["grid cells"]) == ("83x82x64", "83x82x64")
    assert (ours["grid #refs"], paper["grid #refs"]) == ("3.7", "3.7")
    assert (ours["kd-tree leaves 10³"], paper["kd-tree leaves 10³"]) == ("310.0", "154.0")
    assert (ours["BVH MB"], paper["BVH MB"]) == ("4.806", "2.84")
    assert (ours["BVH steps"], paper["BVH tests"]) == ("55.0", "8.0")


def test_table1_explains_what_differs(result) -> None:
    notes = "\n".join(table1([result]).notes)
    assert "bunny kdtree: 310.00 thousand leaves, the paper 154.00 (+101 %): exact surface area heuristic" in notes
    assert "bunny bvh: 4.81 MB, the paper 2.84 (+69 %): 3.33 MB are triangles of 48 bytes" in notes
    assert "bunny bvh: 23.00 thousand leaves" not in notes


def test_table1_without_the_paper(result) -> None:
    bare = result.model_copy(update={"scene": result.scene.model_copy(update={"paper": None})})
    assert len(rows_of(table1([bare]))) == 1


def test_table1_marks_stand_ins(result) -> None:
    bare = result.model_copy(update={"scene": result.scene.model_copy(update=STAND_IN)})
    table = table1([bare])
    assert table.rows[0][0] == "bunny (stand-in)"
    assert any("generated stand-in" in note for note in table.notes)


def test_table2_times_and_errors(result) -> None:
    rows = rows_of(table2([result]))
    named = [row["technique"] for row in rows]
    packet = rows[named.index("bvh/packet", 8)]
    assert packet["frame ms"] == "72.42"
    assert packet["frame %"] == "100%"
    assert (packet["GTX 280 ms"], packet["GTX 280 %"]) == ("13.8", "100%")
    grid = rows[named.index("grid/dda", 8)]
    errors = [grid[f"error {name}"] for name in ("ids ppm", "95 % ≤", "RMSE", "FLIP")]
    assert errors == ["1.91", "6.9", "0.0001", "1.5e-06"]
    assert grid["GTX 280 %"] == "116%"


def test_table2_percent_is_relative_to_kdt2_beyond_primary(result) -> None:
    table = table2([result])
    shown = [row for row in rows_of(table) if row["technique"] == "kdtree/short-stack-2"]
    assert [row["frame %"] for row in shown] == ["122%", "122%", "100%", "100%"]
    assert [row["GTX 280 %"] for row in shown] == ["", "228%", "100%", ""]


def test_table2_marks_the_fastest_but_no_bare_loop(result) -> None:
    table = table2([result])
    assert {table.rows[number][2] for number in table.best} == {"embree/intersect"}
    assert "**embree/intersect**" in markdown(table)
    assert "bvh/packet *" in markdown(table)


def test_markdown_has_one_width(result) -> None:
    for table in table1([result]), table2([result]):
        lines = [line for line in markdown(table).splitlines() if line.startswith("|")]
        assert len({line.count("|") for line in lines}) == 1
        assert markdown(table).startswith("A processor, 2 threads")


def test_ratios(result) -> None:
    lines = ratios(result)
    assert "builds of 69,451 triangles: grid 12 ms" in lines[0]
    assert "a 512x512 primary frame takes 1.18x the bare loop embree/loop-8" in lines[1]
    assert not any("goal" in line for line in lines)
    assert "bvh/while-while traces 0.55x the rays of embree/intersect" in lines[2]
    assert "the rays of embree/loop-8" in lines[-1]


def test_goals_hold_for_large_frames_of_scenes_with_triangles(result) -> None:
    large = result.model_copy(update={"spec": result.spec.model_copy(update={"width": 1024, "height": 1024})})
    lines = ratios(large)
    assert lines[1].endswith("goal at most 1.15x, MISSED")
    assert lines[2].endswith("goal at least 0.3x, reached")
    assert "goal" not in lines[-1]
    empty = large.model_copy(update={"scene": large.scene.model_copy(update={"triangles": 0})})
    assert not any("goal" in line for line in ratios(empty))


def test_ratios_need_both_sides(result) -> None:
    rows = [row for row in result.rows if row.structure == "grid"]
    assert len(ratios(result.model_copy(update={"rows": rows, "structures": []}))) == 0


def test_unreadable_results(tmp_path) -> None:
    with pytest.raises(RaywalkError, match="cannot be read"):
        read_results([tmp_path / "none.json"])
    (tmp_path / "bad.json").write_text('{"schema_version": 2}')
    with pytest.raises(RaywalkError, match="no benchmark result: /schema_version"):
        read_results([tmp_path / "bad.json"])


def test_different_runs_are_told_apart(result) -> None:
    small = other_run(result)
    for make in table1, table2:
        table = make([result, small])
        assert "512x512" not in table.title
        assert [table.machine.count(f"--size {size}") for size in ("512x512", "64x32")] == [1, 1]
        rows = [row for row in rows_of(table) if row["scene"].startswith("bunny")]
        assert [(row["size"], row["frames"]) for row in rows] == [("512x512", "8"), ("64x32", "3")]
    assert "on as many frames as column `compared` says" in "\n".join(table2([result, small]).notes)
    assert [row["compared"] for row in rows_of(table2([result, small])) if row["compared"]] == ["4", "3"]


def test_the_counted_mode_is_named_for_each_row(result) -> None:
    table = table1([result, other_run(result)])
    assert [row["rays"] for row in rows_of(table)] == [
        "primary",
        "all",
        "trace",
        "all",
    ]
    assert len(table.notes) == len(set(table.notes))
    (note,) = [note for note in table.notes if note.startswith("Steps and tests")]
    names = "grid/dda, kdtree/short-stack-3, bvh/packet"
    assert f"bunny 512x512: {names}, rays of mode primary; bunny 64x32: {names}, rays of mode trace;" in note


def test_equal_runs_need_no_more_columns(result) -> None:
    assert len(table2([result, result]).columns) == len(table2([result]).columns)
    assert table2([result, result]).title.endswith("512x512")


def test_errors_name_both_references(result) -> None:
    rows = [row.model_copy(deep=True) for row in result.rows]
    for row in rows:
        row.error.reference = row.error.reference.replace("intersect", "intersect robust=on")
    notes = "\n".join(table2([result.model_copy(update={"rows": rows})]).notes)
    ours, embree = (
        "ours against watertight Embree (embree/intersect robust=on)",
        "Embree itself against bvh/while-while",
    )
    assert f"Errors: {ours}, {embree}, on 4 frames: " in notes


def test_an_early_stop_is_told_once(result) -> None:
    stopped = {"stop_reason": "time_limit"}
    assert sum("stopped" in note for note in table2([result.model_copy(update=stopped)]).notes) == 1
    stopped["notes"] = ["Measuring stopped at the time limit; frames after it are missing."]
    assert sum("stopped" in note for note in table2([result.model_copy(update=stopped)]).notes) == 1


def test_a_scene_without_mirrors_is_said_to_have_none(result) -> None:
    said = "bunny: nothing in view reflects or refracts"
    assert any(note.startswith(said) for note in table2([result]).notes)
    rows = [row.model_copy(deep=True) for row in result.rows]
    next(row for row in rows if row.mode == "whitted").rays_per_frame += 1
    assert not any(note.startswith(said) for note in table2([result.model_copy(update={"rows": rows})]).notes)


def test_csv_of_times_is_for_programs(result) -> None:
    records = records_of(2, [result, other_run(result)])
    assert len(records) == len(result.rows) + 8
    keys = {(r["scene"], r["width_px"], r["mode"], r["technique"]) for r in records}
    assert len(keys) == len(records)
    assert all(all(key) for key in keys)
    assert not any(" " in name or "%" in name for name in records[0])
    packet = next(r for r in records if (r["mode"], r["technique"]) == ("primary", "bvh/packet"))
    assert float(packet["frame_mean_ms"]) == 72.42
    assert (packet["frame_percent"], packet["gtx280_percent"], packet["gtx280_frame_ms"]) == ("100.0", "100.0", "13.8")
    assert packet["command"].startswith("raywalk bench bunny")


def test_csv_of_structures_marks_the_paper(result) -> None:
    ours, paper = records_of(1, [result])
    assert [(r["scene"], r["source"]) for r in (ours, paper)] == [("bunny", "ours"), ("bunny", "paper")]
    assert (ours["grid_cells"], paper["kdtree_leaves_thousands"]) == ("83x82x64", "154.0")
    assert (ours["bvh_traversal"], ours["bvh_mode"], ours["bvh_mb"]) == ("packet", "primary", "4.806")
    assert (paper["width_px"], paper["frames"], paper["device"]) == ("1024", "400", "GTX 280")
    assert (paper["threads"], paper["command"]) == ("", "")
