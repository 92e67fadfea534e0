"""Speed against error: points and their front, the chart's two writers, tables, the command."""

import csv
import io
import json
from pathlib import Path
from xml.etree import ElementTree

import httpx2
import pytest
from PIL import Image
from raywalk.accuracy.axes import LogAxis, around, number_text
from raywalk.accuracy.chart import chart, height_of
from raywalk.accuracy.drawing import SCALE, Area, Drawing, Line, Text, png_of, svg_of
from raywalk.accuracy.files import sweep_csv, write_accuracy
from raywalk.accuracy.points import Point, error_text, pareto, points_of
from raywalk.accuracy.tables import cases_table, sweep_table
from raywalk.study.collect import collect
from raywalk.study.outputs import write_all
from raywalk.study.plan import Step, plan
from raywalk.study.report import report_html

from tests.client.accuracy_parts import FAST, STRICT, accuracy_result, case, row
from tests.client.conftest import EVENTS, JOB, problem
from tests.client.study_parts import stored

SVG = "{http://www.w3.org/2000/svg}"


def point(mrays: float, ppm: float) -> Point:
    return Point("bvh", "packet", {}, False, mrays, ppm, max(ppm, 300.0), 64.0)


@pytest.fixture
def small(result):
    rows = [row("primary", 3.0, 0), row("primary", 4.0, 2, FAST), row("edge", 3.0, 0), row("edge", 4.0, 900, FAST)]
    return accuracy_result(result, rows)


@pytest.mark.parametrize(
    ("points", "front"),
    [
        ([(3, 0)], [(3, 0)]),
        ([(1, 0), (2, 10), (3, 100)], [(3, 100), (2, 10), (1, 0)]),
        ([(1, 50), (2, 10), (3, 100)], [(3, 100), (2, 10)]),
        ([(3, 100), (3, 10), (2, 10)], [(3, 10)]),
        ([(2, 0), (1, 0)], [(2, 0)]),
        ([], []),
    ],
)
def test_the_front_is_what_nothing_beats(points, front) -> None:
    made = [point(mrays, ppm) for mrays, ppm in points]
    assert [(one.mrays, one.ppm) for one in pareto(made)] == front


def test_points_come_by_class_in_a_fixed_order(small) -> None:
    found = points_of(small)
    assert list(found) == ["primary", "edge"]
    assert [one.said for one in found["edge"]] == ["strict", "moeller-trumbore"]
    assert [one.letter for one in found["edge"]] == ["W", "M"]


def test_errors_are_told_with_their_bound() -> None:
    assert error_text(0, 300) == "0 (<300)"
    assert error_text(0.03, 0.14) == "0.03 (<0.14)"


def test_a_log_axis() -> None:
    axis = LogAxis(1, 100, 10, 30)
    assert [axis.at(value) for value in (1, 10, 100)] == pytest.approx([10, 20, 30])
    assert axis.decades() == [1, 2, 5, 10, 20, 50, 100]
    assert LogAxis(1, 1e6, 0, 1).decades() == [10.0**power for power in range(7)]
    low, high = around([3.0])
    assert low < 3 < high and high / low >= 4
    assert [number_text(value) for value in (0.1, 1000, 1e5, 1e6)] == ["0.1", "1000", "100k", "1M"]


def test_none_wrong_lies_below_the_axis() -> None:
    up = LogAxis(10, 1e6, 200, 0)
    assert height_of(point(1, 0), up, ["bvh/packet"], 200) > 200
    assert height_of(point(1, 1000), up, ["bvh/packet"], 200) == pytest.approx(120)
    assert height_of(point(1, 1), up, ["bvh/packet"], 200) == 200


def arrows(svg: str) -> int:
    """Small triangles that point down and have no rim."""
    return sum(
        len(one.get("points", "").split()) == 3 and "stroke" not in one.get("style", "")
        for one in ElementTree.fromstring(svg).iter(f"{SVG}polygon")
    )


def test_the_chart_has_a_panel_a_class_and_an_arrow_for_zero(small) -> None:
    svg = svg_of(chart(small, "a machine & more"))
    tree = ElementTree.fromstring(svg)
    words = [one.text for one in tree.iter(f"{SVG}text")]
    for expected in ("primary rays", "rays aimed at edges", "a machine & more", "bvh/while-while", "moeller-trumbore"):
        assert expected in words, expected
    assert any("W watertight, M moeller-trumbore" in (one or "") for one in words)
    tips = [one.text or "" for one in tree.iter(f"{SVG}title")]
    assert any("bvh/while-while, moeller-trumbore: 4 Mrays/s, 90000 (<180000) ppm wrong" in one for one in tips)
    assert arrows(svg) == 2 + 1  # of the two strict points and of the legend
    assert "none wrong: below 300 ppm (95 %)" in words


def test_the_front_is_drawn_through_its_points(small) -> None:
    drawn = [part for part in chart(small, "").parts if isinstance(part, Line) and part.dashed]
    assert [len(line.points) for line in drawn] == [2, 2, 2]  # of both panels and of the legend
    (fast, strict) = drawn[1].points
    assert fast[0] > strict[0] and fast[1] < strict[1]


def test_both_writers_draw_the_same() -> None:
    parts = [Area([(10, 10), (30, 10), (30, 30), (10, 30)], "#ff0000", "#000000"), Text((5, 50), "a < b")]
    drawing = Drawing(60, 60, "A & B", [*parts, Line([(0, 55), (60, 55)], "#0000ff", 2, dashed=True)])
    image = Image.open(io.BytesIO(png_of(drawing)))
    assert image.size == (60 * SCALE, 60 * SCALE)
    assert image.getpixel((20 * SCALE, 20 * SCALE)) == (255, 0, 0)
    assert image.getpixel((45 * SCALE, 20 * SCALE)) == (255, 255, 255)
    tree = ElementTree.fromstring(svg_of(drawing))
    assert tree.find(f"{SVG}polygon").get("points") == "10.0,10.0 30.0,10.0 30.0,30.0 10.0,30.0"
    assert tree.find(f"{SVG}text").text == "a < b"


def test_the_table_of_a_sweep(small) -> None:
    table = sweep_table(small)
    assert [column.title for column in table.columns][2:5] == ["B/tri", "primary Mrays/s", "primary wrong ppm"]
    strict, fast = table.rows
    assert strict[:2] == ["bvh/while-while", "strict"] and strict[4] == "0 (<300)"
    assert fast[1] == "moeller-trumbore" and fast[6] == "90000 (<180000)"
    notes = " ".join(table.notes)
    assert "0 leaks and 0 double hits in 20,000 rays" in notes
    assert "0 of 600 strict answers, 0 of 600 others" in notes
    assert "0.80x" in notes and "within the goal" in notes


def test_the_brief_table_leaves_out_what_is_beaten(result) -> None:
    beaten = STRICT | {"slab": "plain"}
    made = accuracy_result(result, [row("primary", 3.0, 0), row("primary", 2.0, 5, beaten)])
    assert [line[1] for line in sweep_table(made, brief=True).rows] == ["strict"]
    assert [line[1] for line in sweep_table(made).rows] == ["strict", "plain"]


def test_the_table_of_hard_cases(result) -> None:
    cases = [case(1), case(2), case(3, why_not="needs glass"), case(1, 7, FAST)]
    table = cases_table(accuracy_result(result, [], cases))
    assert table.rows == [
        ["bvh/packet", "strict", 2, 2, 2000, "none"],
        ["bvh/packet", "moeller-trumbore", 0, 1, 1000, "1"],
    ]
    assert table.notes[0].startswith("every strict technique passes")
    failed = cases_table(accuracy_result(result, [], [case(4, 1)]))
    assert "1 failures of strict techniques" in failed.notes[0]


def test_everything_is_written(tmp_path: Path, result, small) -> None:
    cases = accuracy_result(result, [], [case(1)])
    names = write_accuracy([cases, small], tmp_path)
    sweep = [f"sweep-bunny.{form}" for form in ("md", "csv")] + [f"speed-error-bunny.{form}" for form in ("svg", "png")]
    assert names == ["accuracy.json", "hard-cases.md", "hard-cases.csv", *sweep]
    kept = json.loads((tmp_path / "accuracy.json").read_text())
    assert kept[1]["rows"][0]["class"] == "primary"
    records = list(csv.DictReader(io.StringIO(sweep_csv(small))))
    assert records[3]["error_leaks_count"] == "900" and records[0]["knobs_intersector"] == "watertight"


def test_the_study_keeps_and_shows_it(tmp_path: Path, result, small) -> None:
    store, asked = stored(tmp_path, result, "bunny")
    asked = asked.model_copy(update={"accuracy": True})
    assert asked.command.endswith("--accuracy")
    step = Step("accuracy", "bunny")
    assert step in plan(asked, gpu=False) and step not in plan(asked.model_copy(update={"accuracy": False}), gpu=False)
    store.save(step, {"seconds": 1.0, "results": [small.model_dump(mode="json", by_alias=True)]})
    study = collect(store, asked, gpu=False)
    assert study.complete
    text = report_html(study)
    assert 'href="#accuracy"' in text and "rays aimed at edges" in text
    assert "speed-error-bunny.png" in write_all(study, tmp_path)


def replies(daemon, *results) -> None:
    daemon.on("POST", "/v1/jobs", *[JOB | {"id": f"j{number}"} for number in range(len(results))])
    for number, one in enumerate(results):
        ended = JOB | {"kind": "accuracy", "spec": {"quick": True}, "id": f"j{number}", "state": "succeeded"}
        content = f"event: job\ndata: {json.dumps(ended | {'result': f'r{number}'})}\n\n"
        daemon.on("GET", f"/v1/jobs/j{number}/events", httpx2.Response(200, content=content, headers=EVENTS))
        daemon.on("GET", f"/v1/results/r{number}", one.model_dump(mode="json", by_alias=True))


def test_the_command_asks_for_cases_and_a_sweep_a_scene(tmp_path: Path, daemon, raywalk, result, small) -> None:
    replies(daemon, accuracy_result(result, [], [case(1)]), small)
    ended = raywalk("accuracy", "--scene", "bunny", "--quick", "--out", tmp_path)
    assert ended.exit_code == 0, ended.output
    sent = [json.loads(one.content) for one in daemon.requests if one.url.path == "/v1/jobs"]
    assert [one["kind"] for one in sent] == ["accuracy", "accuracy"]
    assert sent[0]["spec"] == {"hard_cases": True, "quick": True, "seed": 1}
    assert sent[1]["spec"] == {"scene": "bunny", "hard_cases": False, "quick": True, "seed": 1}
    assert "Hard cases" in ended.stdout and "Speed against error: bunny" in ended.stdout
    assert (tmp_path / "speed-error-bunny.png").is_file()


def test_the_command_fails_with_a_strict_technique(tmp_path: Path, daemon, raywalk, result, small) -> None:
    replies(daemon, accuracy_result(result, [], [case(5, 2), case(6, 1, FAST)]), small)
    ended = raywalk("accuracy", "--scene", "bunny", "--out", tmp_path)
    assert ended.exit_code == 1
    assert "bvh/packet fails hard case 5 (case 5): ray 0x1p0" in ended.stderr
    assert (tmp_path / "accuracy.json").is_file()


def test_what_was_measured_before_a_failure_is_kept(tmp_path: Path, daemon, raywalk, small) -> None:
    replies(daemon, small, small)
    daemon.on("GET", "/v1/results/r1", problem(404, "not_found", "there is no result r1"))
    ended = raywalk("accuracy", "--scene", "bunny", "--scene", "robots", "--no-cases", "--out", tmp_path)
    assert ended.exit_code != 0 and "there is no result r1" in ended.stderr
    kept = json.loads((tmp_path / "accuracy.json").read_text())
    assert [one["scene"]["name"] for one in kept] == ["bunny"]
    assert (tmp_path / "speed-error-bunny.png").is_file()


@pytest.mark.parametrize("words", [["--rays", "3"], ["--seed", "-1"]])
def test_bad_numbers_are_refused(raywalk, words) -> None:
    assert raywalk("accuracy", *words).exit_code == 2
