"""Benchmarks: a job is started, watched, cancelled, and read."""

import csv
import json

from playwright.sync_api import Locator, expect

from tests.web.conftest import SCENE, Visit


def start(visit: Visit, frames: int) -> Locator:
    """Starts a small benchmark and gives the job's section."""
    form = visit.open("benchmarks").page.get_by_label("New benchmark")
    form.get_by_label("Scene").select_option(SCENE)
    form.get_by_label("Size").select_option("128")
    form.get_by_label("Frames").fill(str(frames))
    for name in ("kdtree/short-stack-2", "bvh/packet"):
        form.get_by_label(name).uncheck()
    form.get_by_role("button", name="Start benchmark").click()
    return visit.page.get_by_role("region", name="Job", exact=True)


def test_a_job_runs_to_its_table(visit: Visit) -> None:
    job = start(visit, frames=4)
    expect(job).to_have_attribute("data-state", "succeeded", timeout=60_000)
    table = visit.page.get_by_role("region", name="Results").locator("table")
    rows = table.locator("tbody tr")
    expect(rows).to_have_count(8)  # four techniques, two modes
    table.get_by_role("button", name="Median ms").click()
    times = [float(text) for text in table.locator("tbody td:nth-child(3)").all_inner_texts()]
    assert times == sorted(times) and times[0] > 0
    table.get_by_role("button", name="Median ms").click()
    assert [float(text) for text in table.locator("tbody td:nth-child(3)").all_inner_texts()] == times[::-1]
    expect(table.locator("th[aria-sort=descending]")).to_have_text("Median ms")
    for _ in range(2):  # in either order what the study has no time of comes last
        table.get_by_role("button", name="Steps/ray").click()
        steps = table.locator("tbody td:nth-child(9)").all_inner_texts()
        assert "–" in steps and "–" not in steps[: -steps.count("–")]
    expect(visit.page.locator(".plot canvas")).to_be_visible()
    with visit.page.expect_download() as download:
        visit.page.get_by_role("button", name="CSV").click()
    assert len(list(csv.DictReader(download.value.path().read_text().splitlines()))) == 8
    with visit.page.expect_download() as download:
        visit.page.get_by_role("button", name="JSON").click()
    assert len(json.loads(download.value.path().read_text())["rows"]) == 8


def test_a_job_is_cancelled(visit: Visit) -> None:
    job = start(visit, frames=20000)
    expect(job).to_have_attribute("data-state", "running")
    expect(job.get_by_role("progressbar")).to_be_visible()
    job.get_by_role("button", name="Cancel").click()
    expect(job).to_have_attribute("data-state", "cancelled")
    expect(job.get_by_role("button", name="Cancel")).to_be_hidden()


def test_nothing_to_measure_cannot_be_started(visit: Visit) -> None:
    form = visit.open("benchmarks").page.get_by_label("New benchmark")
    for mode in ("primary", "shadow"):
        form.get_by_label(mode, exact=True).uncheck()
    expect(form.get_by_role("button", name="Start benchmark")).to_be_disabled()


def test_an_unknown_job_is_said(visit: Visit) -> None:
    job = start(visit, frames=1)
    expect(job).to_have_attribute("data-state", "succeeded", timeout=60_000)
    visit.open("benchmarks", job="nothing")
    expect(visit.notice("nothing")).to_be_visible()
    expect(job).to_be_hidden()
    visit.page.get_by_role("region", name="Jobs").get_by_role("button").first.click()
    expect(job).to_be_visible()
    expect(visit.notice("nothing")).to_have_count(0)
