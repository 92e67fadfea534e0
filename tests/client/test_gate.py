"""Tiers and gates in tables, ratios and findings: what is open is shown, and counts for nothing."""

import csv
import io

import pytest
from raywalk.gate import choice_notes, is_open, open_notes
from raywalk.kernel_options import label
from raywalk.models import BenchmarkResult, Gate, KnobChoice, Technique
from raywalk.ratios import ratios
from raywalk.study.collect import collect
from raywalk.study.findings import findings_markdown
from raywalk.study.times import time_tables
from raywalk.study.winners import winner
from raywalk.tables import markdown, table2, table3, table_text
from raywalk.tables.machine import command_of

from tests.client.conftest import job_that_gives, specs_sent
from tests.client.study_parts import made, paper_times, stored

WHY = "3 wrong of 1,048,576 rays (2.86 ppm: 3 leaks of primary rays); tier strict allows none."
OPEN = {"status": "open", "wrong": 3, "wrong_ppm": 2.86, "wrong_ppm_upper95": 7.4, "reason": WHY}
KINDS = {
    "kinds": [
        {
            "name": "bvh",
            "help": "",
            "options": [],
            "traversals": [
                {
                    "name": "while-while",
                    "help": "",
                    "options": [
                        {"name": "intersector", "type": "choice", "help": "", "default": "a", "choices": ["a", "b"]}
                    ],
                }
            ],
        },
        {"name": "embree", "help": "", "options": [], "traversals": [{"name": "intersect", "help": "", "options": []}]},
    ]
}


def opened(result: BenchmarkResult, technique: str, *modes: str) -> BenchmarkResult:
    """A copy in which these rows are open."""
    copy = result.model_copy(deep=True)
    for row in copy.rows:
        if f"{row.structure}/{row.traversal}" == technique and row.mode in modes:
            row.gate = Gate.model_validate(row.gate.model_dump() | OPEN)
    return copy


def in_tier(result: BenchmarkResult, tier: str, faster: float, **more) -> BenchmarkResult:
    """A copy with a second primary row of bvh/while-while."""
    copy = result.model_copy(deep=True)
    row = next(r for r in copy.rows if (r.traversal, r.mode) == ("while-while", "primary")).model_copy(deep=True)
    row.gate = Gate.model_validate(row.gate.model_dump() | {"tier": tier} | more)
    row.frame_ms.median /= faster
    row.kernel_options = row.kernel_options | {"slab": "plain"}
    copy.rows.append(row)
    return copy


def cells_of(table, technique: str, mode: int = 0) -> dict[str, object]:
    titles = [column.title for column in table.columns]
    rows = [dict(zip(titles, row, strict=True)) for row in table.rows]
    return [row for row in rows if str(row["technique"]).startswith(technique)][mode]


def test_table2_shows_tier_and_gate(result) -> None:
    table = table2([result])
    ours, engine = cells_of(table, "bvh/while-while"), cells_of(table, "embree/intersect")
    assert (ours["tier"], ours["gate"], ours["error wrong ppm"]) == ("strict", "closed", "0")
    assert (engine["tier"], engine["gate"]) == (None, "closed")
    assert any(note.startswith("gate: closed when") for note in table.notes)
    assert not any("open" in note for note in table.notes if not note.startswith("gate:"))


def test_an_open_row_is_marked_and_not_compared(result) -> None:
    table = table2([opened(result, "embree/intersect", "trace")])
    open_, other = cells_of(table, "embree/intersect"), cells_of(table, "bvh/packet")
    assert (open_["technique"], open_["gate"]) == ("embree/intersect (OPEN)", "OPEN")
    assert (open_["frame %"], other["frame %"]) == (None, "100%")
    assert open_["frame ms"] is not None
    best = {table.rows[number][2] for number in table.best}
    assert len(best) == 2
    assert "embree/intersect (OPEN)" not in best
    (note,) = [note for note in table.notes if "rows is open" in note]
    assert f"bunny: 1 of {len(result.rows)} rows is open, in no comparison: embree/intersect (trace): 3 wrong" in note
    assert "OPEN" in markdown(table)


def test_the_base_of_100_percent_is_closed(result) -> None:
    table = table2([opened(result, "bvh/packet", "primary")])
    percents = [cells_of(table, name, 1)["frame %"] for name in ("bvh/packet", "embree/intersect")]
    assert percents == [None, "100%"]


def test_all_open_is_no_comparison(result) -> None:
    rows = [row for row in result.rows if (row.structure, row.mode) == ("grid", "primary")]
    table = table2([opened(result.model_copy(update={"rows": rows}), "grid/dda", "primary")])
    assert not table.best
    assert cells_of(table, "grid/dda")["frame %"] is None


def test_csv_has_tier_and_gate(result) -> None:
    records = list(csv.DictReader(io.StringIO(table_text(2, [opened(result, "grid/dda", "shadow")], "csv"))))
    row = next(r for r in records if (r["technique"], r["mode"]) == ("grid/dda", "shadow"))
    assert (row["tier"], row["gate"], row["wrong_rays"], row["frame_percent"]) == ("strict", "open", "3", "")
    assert row["gate_reason"] == WHY


def test_results_without_gates_stay_readable(result) -> None:
    for row in result.rows:
        row.gate, row.kernel_options = None, None
    table = table2([result])
    assert not {"tier", "gate"} & {column.title for column in table.columns}
    assert not any(is_open(row) for row in result.rows)
    assert not any(note.startswith("gate:") for note in table.notes)


def test_ratios_leave_open_rows_out(result) -> None:
    said = ratios(opened(result, "bvh/while-while", "trace"))
    assert not any("traces" in line for line in said)
    assert said[-1] == "1 open row is left out of these ratios"


def test_ratios_of_tiers(result) -> None:
    said = ratios(in_tier(result, "fast", 1.05))
    assert any(line.startswith("bvh/while-while, primary: strict takes 1.05x the time of fast") for line in said)
    said = ratios(in_tier(result, "fast", 1.05, **OPEN))
    assert not any("the time of fast" in line for line in said)


def test_the_same_knobs_are_no_ratio(result) -> None:
    copy = in_tier(result, "auto", 1.05)
    copy.rows[-1].kernel_options["slab"] = "padded"
    assert not any("the time of auto" in line for line in ratios(copy))


def test_what_is_open_for_one_reason_is_told_together(result) -> None:
    copy = opened(opened(result, "grid/dda", "trace", "shadow"), "bvh/packet", "trace")
    (note,) = open_notes([copy])
    assert note == (
        f"bunny: 3 of {len(result.rows)} rows are open, in no comparison: grid/dda strict (trace shadow), "
        f"bvh/packet strict (trace): {WHY}"
    )


def test_what_auto_chose_is_told(result) -> None:
    candidates = [{"kernel": {}, "name": "plain", "frame_ms": 1.0, "wrong": 0, "rays": 8}]
    choice = KnobChoice.model_validate({"candidates": candidates, "chosen": 0, "reason": "plain: 1.06x, chosen."})
    copy = in_tier(result, "auto", 1.06, choice=choice.model_dump())
    assert choice_notes([copy]) == ["bunny: bvh/while-while auto (primary): plain: 1.06x, chosen."]
    assert choice_notes([copy])[0] in table2([copy]).notes


def test_knobs_of_a_cpu_stand_in_the_label(result) -> None:
    row = next(row for row in result.rows if row.traversal == "while-while")
    named = Technique(structure="bvh", traversal="while-while", kernel={"slab": "plain"})
    row.kernel_options = {"intersector": "watertight", "slab": "plain"}
    spec = result.spec.model_copy(update={"techniques": [named]})
    assert label(spec, row) == "bvh/while-while[slab=plain]"


def test_table3_leaves_open_rows_out(sweep) -> None:
    fastest = min((row for row in sweep.rows if row.structure == "grid"), key=lambda row: row.frame_ms.median)
    fastest.gate = Gate.model_validate(fastest.gate.model_dump() | OPEN)
    table = table3([sweep])
    names = [table.rows[number][2] for number in table.best]
    assert names
    assert not any("OPEN" in str(name) for name in names)
    assert any("OPEN" in str(row[2]) for row in table.rows)
    assert any("is open" in note for note in table.notes)


def test_an_open_row_cannot_win(result) -> None:
    study = made(result, "office", paper_times("office"))
    for row in study.rows:
        row.gate = Gate.model_validate(row.gate.model_dump() | {"tier": "strict"})
    assert winner(study, "primary").family == "BVH"
    open_ = opened(study, "bvh/packet", "primary")
    assert winner(open_, "primary").family == "kd-tree"
    assert open_notes([open_])[0].startswith("office: 1 of ")


@pytest.mark.parametrize("tiers", ["strict,fast,auto", "fast"])
def test_bench_asks_for_tiers(daemon, raywalk, result, tiers: str) -> None:
    daemon.on("GET", "/v1/kinds", KINDS)
    job_that_gives(daemon, result)
    ran = raywalk("bench", "bunny", "--tier", tiers, "--frames", 2)
    assert ran.exit_code == 0, ran.output
    (spec,) = specs_sent(daemon)
    asked = [(one["structure"], one["tier"]) for one in spec["techniques"]]
    words = tiers.split(",")
    assert asked == [("bvh", tier) for tier in words] + [("embree", words[0])]


def test_bad_tiers_are_refused(raywalk) -> None:
    for words in (["--tier", "exact"], ["--tier", ","], ["--tier", "fast", "--table", "3"]):
        assert raywalk("bench", "bunny", *words).exit_code == 2, words


def test_the_command_names_the_tiers(result) -> None:
    techniques = [Technique(structure="bvh", traversal="packet", tier=tier) for tier in ("strict", "auto")]
    copy = result.model_copy(update={"spec": result.spec.model_copy(update={"techniques": techniques})})
    assert "--tier strict,auto" in command_of(copy)
    assert "--tier" not in command_of(result)


def test_findings_say_what_is_open(result, tmp_path) -> None:
    store, asked = stored(tmp_path, opened(result, "grid/dda", "trace"), "bunny")
    study = collect(store, asked, gpu=False)
    text = findings_markdown(study)
    assert "An open row, which has more wrong rays than its tier allows, cannot win." in text
    assert "rows are open, in no comparison" in text
    assert any("OPEN" in str(cell) for table in time_tables(study) for row in table.rows for cell in row)
