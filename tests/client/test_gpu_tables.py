"""Tables 2 and 3 from results of a GPU."""

import csv
import io

import pytest
from raywalk.errors import RaywalkError
from raywalk.kernel_options import common_options, swept_caps
from raywalk.models import BenchmarkResult
from raywalk.tables import markdown, table2, table3, table_text, tables_of
from raywalk.tables.machine import command_of, machine_line
from raywalk.tables.paper3 import KERNELS, paper_kernel


def rows_of(table) -> list[dict[str, str]]:
    titles = [column.title for column in table.columns]
    return [
        dict(zip(titles, [column.show(cell) for column, cell in zip(table.columns, row, strict=True)], strict=True))
        for row in table.rows
    ]


def records_of(number: int, *results: BenchmarkResult) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(table_text(number, results, "csv"))))


def changed(result: BenchmarkResult, **spec) -> BenchmarkResult:
    return result.model_copy(update={"spec": result.spec.model_copy(update=spec)})


def test_latency_and_throughput_stand_apart(gpu) -> None:
    row = next(row for row in rows_of(table2([gpu])) if row["technique"].startswith("bvh/packet"))
    assert (row["frame ms"], row["16 a launch ms"]) == ("0.073", "0.041")
    assert (row["Mrays/s"], row["16 a launch Mrays/s"]) == ("14563.60", "26214.4")


def test_the_gain_over_the_papers_gpu(gpu) -> None:
    shown = {(row["mode"], row["technique"]): row["GTX 280 faster"] for row in rows_of(table2([gpu]))}
    assert shown["primary", "grid/dda[block=128,registers=64]"] == "142.6x"
    assert shown["", "bvh/while-while[block=128,registers=64]"] == "—"


@pytest.mark.parametrize("update", [{"width": 512, "height": 512}, {"width": 2048}])
def test_other_sizes_have_no_gain(gpu, update) -> None:
    table = table2([changed(gpu, **update)])
    assert "GTX 280 faster" not in [column.title for column in table.columns]
    assert not any("faster than" in note for note in table.notes)


def test_a_cpu_has_the_columns_that_it_had(result) -> None:
    titles = [column.title for column in table2([result]).columns]
    assert titles[-2:] == ["GTX 280 ms", "GTX 280 %"]
    assert not any("launch" in title for title in titles)
    assert tables_of([result]) == [1, 2]


def test_mixed_results_leave_out_what_is_missing(gpu, result) -> None:
    rows = rows_of(table2([gpu, result]))
    assert {row["16 a launch ms"] for row in rows if "[" not in row["technique"]} == {"—"}
    assert tables_of([gpu, result]) == [1, 2, 3]


def test_telemetry_is_told(gpu, sweep) -> None:
    said = (
        "bunny: while it measured, core clock 1980 MHz (1755 to 1980), memory clock 2619 MHz, power 402 W (310 to 455) "
        "of 700 W, temperature 45 °C (41 to 48), throttle reasons: sw_power_cap."
    )
    assert said in table2([gpu]).notes
    assert said in table3([gpu]).notes
    assert not any("throttle" in note for note in table3([sweep]).notes)
    gpu.telemetry.throttle_reasons = []
    assert any(note.endswith("throttle reasons: none.") for note in table2([gpu]).notes)


def test_a_machine_with_a_gpu(gpu) -> None:
    words = "NVIDIA H100 80GB HBM3, architecture sm_90, driver 580.95, nvrtc 13.0, commit 0123456789ab, 2026-11-22, `"
    assert machine_line([gpu]).startswith(words)


def test_table3_has_a_row_a_cap(sweep) -> None:
    table = table3([sweep])
    free, small, middle = rows_of(table)[:3]
    assert [row["cap"] for row in (free, small, middle)] == ["none", "32", "40"]
    assert (small["registers"], small["local B"], small["shared B"], small["block threads"]) == ("32", "96", "0", "128")
    assert (small["multiprocessor blocks"], small["multiprocessor occupancy %"]) == ("16", "100.0")
    assert [row["frame ms"] for row in (free, small, middle)] == ["0.110", "0.130", "0.100"]
    assert [row["frame of best"] for row in (free, small, middle)] == ["1.10x", "1.30x", "1.00x"]
    assert table.best == {2, 3}
    assert table.sections == {0, 3}


def test_table3_beside_the_paper(sweep) -> None:
    theirs = [(row["GTX 280 registers"], row["GTX 280 occupancy %"]) for row in rows_of(table3([sweep]))]
    assert theirs == [("59", "25.0"), ("32", "50.0"), ("—", "—"), ("56", "25.0"), ("—", "—"), ("40", "37.5")]
    assert any("WSCG 2010, Table 3" in note for note in table3([sweep]).notes)


def test_table3_has_the_papers_times_for_its_scenes_and_rays(sweep) -> None:
    robots = sweep.model_copy(update={"scene": sweep.scene.model_copy(update={"name": "robots"})})
    assert "GTX 280 ms" not in rows_of(table3([robots]))[0]
    for row in robots.rows:
        row.mode = "whitted"
    assert [row["GTX 280 ms"] for row in rows_of(table3([robots]))] == ["430.7", "350.2", "—", "110.7", "—", "96.0"]


def test_the_papers_kernels() -> None:
    assert all([kernel.cap == 0 for kernel in pair] == [True, False] for pair in KERNELS.values())
    assert paper_kernel("bvh/packet", 32).frame_ms == {"robots": 129.9, "kitchen": 762.4, "museum": 214.4}
    assert paper_kernel("bvh/packet", 64) is None
    assert paper_kernel("bvh/while-while", 0) is None


def test_table3_of_one_cap_ranks_nothing(gpu) -> None:
    table = table3([gpu])
    assert "frame of best" not in rows_of(table)[0]
    assert table.best == set()
    assert [row["mode"] for row in rows_of(table)] == ["trace", "", "", "", "primary", "", "", ""]
    assert rows_of(table)[0]["technique"] == "grid/dda[block=128]"


def test_table3_needs_a_gpu(result) -> None:
    for make in (lambda: table3([result]), lambda: table_text(3, [result], "csv")):
        with pytest.raises(RaywalkError, match="about GPU kernels, and these results were measured without a GPU"):
            make()


def test_table3_as_markdown_and_csv(sweep) -> None:
    assert "**Table 3: kernels under register caps, 512x512**" in markdown(table3([sweep]))
    records = records_of(3, sweep)
    assert len({(record["technique"], record["register_cap"]) for record in records}) == 6
    first = records[0]
    assert (first["register_cap"], first["registers"], first["occupancy"]) == ("0", "58", "0.5")
    assert (first["gtx280_registers"], first["gtx280_occupancy"]) == ("59", "0.25")
    assert float(first["time_of_best"]) == pytest.approx(1.1)


def test_csv_of_times_has_throughput_apart(gpu) -> None:
    first = records_of(2, gpu)[0]
    assert (first["technique"], first["kernel_options"]) == ("grid/dda", "block=128,registers=64")
    assert (first["frame_mean_ms"], first["launch_frames"], first["launch_frame_mean_ms"]) == (
        "0.08976",
        "16",
        "0.05712",
    )
    assert "throttle reasons: sw_power_cap" in first["telemetry"]


def test_the_command_of_kernel_options(gpu) -> None:
    assert common_options(gpu) == {"registers": 64, "block": 128}  # the packet has no choice of a block
    assert "--kernel registers=64,block=128 --repeats" in command_of(gpu)
    gpu.spec.techniques[0].kernel = {"registers": 32}
    assert common_options(gpu) is None
    assert command_of(gpu).endswith("(and kernel options for each technique, which only a specification can give)")


def test_the_command_of_a_sweep(sweep, gpu) -> None:
    command = "raywalk bench bunny --table 3 --frames 8 --size 512x512 --modes primary "
    command += "--techniques grid/dda,kdtree/short-stack-2 --registers 0,32,40 --repeats 1 --warmup 5"
    assert command_of(sweep) == command
    assert command_of(changed(sweep, batch=4)).endswith("--batch 4")
    assert swept_caps(gpu.spec) is None
    sweep.spec.techniques.pop()
    assert swept_caps(sweep.spec) is None
