"""What a study writes: tables in three forms, charts, figures, one page that needs nothing else."""

import csv
import re
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree

import pytest
from PIL import Image
from raywalk.errors import RaywalkError
from raywalk.study.charts import bar_chart, line_chart, ticks
from raywalk.study.collect import collect
from raywalk.study.latex import escaped, latex
from raywalk.study.outputs import write_all
from raywalk.study.report import report_html
from raywalk.study.structures import structure_table
from raywalk.study.times import time_tables
from raywalk.tables.table import Column, Table

from tests.client.study_parts import made, parameters, stored

SCENES = ("bunny", "dragon", "buddha", "robots", "museum", "kitchen", "theatre", "office", "conference")


class Page(HTMLParser):
    """Collects what a page would load, and whether its elements nest."""

    VOID = ("meta", "img", "br")

    def __init__(self, text: str) -> None:
        super().__init__()
        self.loads: list[str] = []
        self.ids: list[str] = []
        self.open: list[str] = []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = dict(attrs)
        self.loads += [value for name, value in attrs if name in ("src", "href", "srcset", "data", "action") and value]
        self.ids += [given["id"]] if given.get("id") else []
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        pass

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


@pytest.fixture
def whole(tmp_path: Path, result):
    store, asked = stored(tmp_path, result, *SCENES)
    return collect(store, asked, gpu=False)


def test_everything_is_written(tmp_path: Path, whole) -> None:
    names = write_all(whole, tmp_path)
    tables = [f"table{number}.{form}" for number in (1, 2) for form in ("md", "tex", "csv")]
    figures = [f"figure{number}.{form}" for number in (1, 2) for form in ("svg", "csv")]
    images = [f"figure{number}.png" for number in (3, 4, 5)]
    assert set(names) == {*tables, *figures, *images, "FINDINGS.md", "report.html"}
    assert all((tmp_path / name).stat().st_size > 100 for name in names)
    assert whole.complete and whole.seconds > 0
    assert Image.open(tmp_path / "figure4.png").width > 3 * 96


def test_the_page_loads_nothing(whole) -> None:
    text = report_html(whole)
    page = Page(text)
    assert page.open == []
    assert all(load.startswith(("data:image/jpeg;base64,", "#")) for load in page.loads), page.loads
    assert sum(load.startswith("data:") for load in page.loads) == len(SCENES)
    assert not re.search(r"url\(|@import|<script|<link|<iframe", text)
    assert {load[1:] for load in page.loads if load.startswith("#")} == set(page.ids)


def test_the_page_has_every_scene_and_chart(whole) -> None:
    text = report_html(whole)
    for scene in SCENES:
        assert f'alt="{scene.title()}"' in text
        assert f"{scene} (original)" in text
    assert text.count("<svg") == 5  # three kinds of rays, two scenes over resolution
    for words in ("Figure 1: dragon, primary and shadow rays", "Table 2c", "the paper&#x27;s", "Table 1"):
        assert words in text or words.replace("&#x27;", "'") in text, words
    assert "prefers-color-scheme:dark" in text and "@media print" in text


def test_names_are_escaped_in_the_page(tmp_path: Path, result) -> None:
    store, asked = stored(tmp_path, result, "bunny")
    study = collect(store, asked, gpu=False, failures={"dragon": "no <file> & so on"})
    study.results["bunny"].scene.title = "<script>alert(1)</script>"
    text = report_html(study)
    assert "<script" not in text
    assert "no &lt;file&gt; &amp; so on" in text


def test_an_unfinished_study_says_so(tmp_path: Path, result) -> None:
    store, asked = stored(tmp_path, result, "bunny", "robots")
    (tmp_path / "steps/robots-measure.json").unlink()
    study = collect(store, asked, gpu=False)
    write_all(study, tmp_path)
    for name in ("report.html", "FINDINGS.md"):
        assert f"{study.steps - 1} of {study.steps} steps are finished" in (tmp_path / name).read_text()


def test_an_empty_study_can_be_written(tmp_path: Path, result) -> None:
    store, _ = stored(tmp_path, result)
    study = collect(store, parameters("bunny"), gpu=False)
    assert write_all(study, tmp_path) == ["FINDINGS.md", "report.html"]
    assert "Nothing was measured yet." in (tmp_path / "report.html").read_text()


def test_a_damaged_step_is_told(tmp_path: Path, result) -> None:
    store, asked = stored(tmp_path, result, "bunny")
    path = tmp_path / "steps/bunny-measure.json"
    for content in ("{", "[]", "{}", '{"seconds": 1, "results": [{}]}', '{"seconds": 1, "results": []}'):
        path.write_text(content)
        with pytest.raises(RaywalkError, match="bunny-measure.*--fresh"):
            collect(store, asked, gpu=False)


def test_table3_on_a_gpu(tmp_path: Path, result, sweep) -> None:
    store, asked = stored(tmp_path, result, "bunny")
    study = collect(store, asked, gpu=False)
    study.kernels = [sweep]
    names = write_all(study, tmp_path)
    assert {"table3.md", "table3.tex", "table3.csv"} <= set(names)
    assert "register caps" in (tmp_path / "report.html").read_text()


def test_latex_is_a_booktabs_tabular(whole) -> None:
    for table in [structure_table(whole), *time_tables(whole)]:
        text = latex(table)
        body = [line for line in text.splitlines() if not line.startswith("%")]
        assert body[0] == "\\begin{tabular}{" + "".join("l" if one.left else "r" for one in table.columns) + "}"
        assert body[1] == "\\toprule" and body[-2:] == ["\\bottomrule", "\\end{tabular}"]
        for line in body[2:-2]:
            if line.endswith(r"\\"):
                spans = sum(int(count) - 1 for count in re.findall(r"\\multicolumn\{(\d+)\}", line))
                assert len(re.findall(r"(?<!\\)&", line)) + spans == len(table.columns) - 1, line
            else:
                assert line.startswith(("\\midrule", "\\addlinespace", "\\cmidrule")), line
        plain = re.sub(r"\\[%&#_$]", "", "\n".join(body))
        assert not re.search(r"[%#~]|[^\x00-\x7f]", plain)
        assert plain.count("{") == plain.count("}")


def test_latex_escapes() -> None:
    text = "50% & $x_1$ #2 {a} ~b^c \\d <e> 95 % ≤ 10³ —"
    assert escaped(text) == (
        r"50\% \& \$x\_1\$ \#2 \{a\} \textasciitilde{}b\textasciicircum{}c \textbackslash{}d "
        r"\textless{}e\textgreater{} 95 \% $\leq$ 10\textsuperscript{3} ---"
    )
    assert escaped("日") == "?"
    table = Table(
        "t", "m", [Column("scene", left=True), Column("a_b", "100 %")], [["  paper", 1.5]], best_cells={(0, 1)}
    )
    assert r"\quad paper & \textbf{1.5} \\" in latex(table)
    assert r"\multicolumn{1}{c}{100 \%}" in latex(table)


def test_csv_can_be_read(tmp_path: Path, whole) -> None:
    write_all(whole, tmp_path)
    with (tmp_path / "table2.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert {row["scene"] for row in rows} == set(SCENES)
    bunny = next(
        row for row in rows if (row["scene"], row["mode"], row["technique"]) == ("bunny", "primary", "grid/dda")
    )
    assert float(bunny["frame_mean_ms"]) == float(bunny["gtx280_frame_ms"]) == 16.0
    with (tmp_path / "figure1.csv").open() as file:
        points = list(csv.DictReader(file))
    assert {row["width_px"] for row in points} == {"32", "48", "64", "96", "128"}
    assert len(points) == 5 * 4


def test_charts_are_well_formed(whole) -> None:
    for chart in (bar_chart(whole, "primary"), line_chart(whole.resolutions["dragon"], "a < b & c", standalone=True)):
        root = ElementTree.fromstring(chart)
        assert root.tag.endswith("svg")
        _, _, width, height = map(float, root.get("viewBox").split())
        for rect in root.iter("{http://www.w3.org/2000/svg}rect"):
            x, y = float(rect.get("x")), float(rect.get("y"))
            assert 0 <= x <= x + float(rect.get("width")) <= width
            assert 0 <= y <= y + float(rect.get("height")) <= height


def test_bars_beyond_the_chart_are_cut_and_told(whole, result) -> None:
    whole.results["museum"] = made(result, "museum", {"primary": (90.0, 2.0, 2.0, 1.0)})
    assert ">9000</text>" in bar_chart(whole, "primary")
    assert bar_chart(whole, "trace") is None


@pytest.mark.parametrize("most", [0.003, 0.7, 1.0, 9.99, 10, 123, 4e5])
def test_ticks_cover_the_range(most) -> None:
    found = ticks(most)
    assert found[0] == 0 and found[-1] >= most * 0.999 and 3 <= len(found) <= 8
