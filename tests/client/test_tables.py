"""The study's tables from a stored result."""

import csv
import io

import pytest
from raywalk.errors import RaywalkError
from raywalk.ratios import ratios
from raywalk.tables import csv_text, markdown, read_results, table1, table2
from raywalk.tables.machine import machine_line

STAND_IN = {"fidelity": "stand-in"}


def rows_of(table) -> list[dict[str, str]]:
    lines = csv_text(table).split("\n", 1)
    assert lines[0].startswith("# A processor, 2 threads, commit 0123456789ab, 2026-11-22, `raywalk bench bunny")
    return list(csv.DictReader(io.StringIO(lines[1])))


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
    assert (grid["error ids ppm"], grid["error 95 % ≤"], grid["error RMSE"]) == ("1.91", "6.9", "0.0001")
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
    assert "bvh/while-while traces 0.55x the rays of embree/intersect" in lines[3]


def test_goals_hold_for_large_frames_of_scenes_with_triangles(result) -> None:
    large = result.model_copy(update={"spec": result.spec.model_copy(update={"width": 1024, "height": 1024})})
    lines = ratios(large)
    assert lines[1].endswith("goal at most 1.15x, MISSED")
    assert lines[3].endswith("goal at least 0.3x, reached")
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
