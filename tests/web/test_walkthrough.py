"""Walkthrough: it plays, scrubs, and plots every technique."""

from playwright.sync_api import expect

from tests.web.conftest import SCENE, Visit


def test_plays_to_the_end_with_times_of_every_technique(visit: Visit) -> None:
    techniques = "bvh/while-while,grid/dda,embree/intersect"
    visit.open("walkthrough", scene=SCENE, frames=8, size=128, techniques=techniques)
    canvas = visit.canvas
    expect(canvas).to_have_attribute("data-frame", "0")
    first = visit.image()
    visit.page.get_by_role("button", name="Play").click()
    expect(canvas).to_have_attribute("data-frame", "7")
    expect(visit.page.get_by_role("button", name="Play")).to_be_visible()
    assert visit.image() != first
    rows = visit.page.get_by_label("Table of times").locator("tbody tr")
    for name in techniques.split(","):
        cells = rows.filter(has=visit.page.get_by_role("rowheader", name=name)).locator("td")
        expect(cells.nth(0)).to_have_text("8")
        assert float(cells.nth(1).inner_text()) > 0
    expect(visit.page.locator(".plot canvas")).to_be_visible()
    visit.page.get_by_label("Image of").select_option("grid/dda")
    expect(rows.first.locator("td").first).to_have_text("8")  # the times stay
    assert visit.most_under_way == 1


def test_scrubs(visit: Visit) -> None:
    visit.open("walkthrough", scene=SCENE, frames=20, size=128, techniques="bvh/while-while")
    expect(visit.canvas).to_have_attribute("data-frame", "0")
    slider = visit.page.get_by_role("slider", name="Frame")
    slider.focus()
    for _ in range(3):
        visit.page.keyboard.press("ArrowRight")
    expect(visit.canvas).to_have_attribute("data-frame", "3")
    visit.page.keyboard.press("End")
    expect(visit.canvas).to_have_attribute("data-frame", "19")
    expect(visit.page.get_by_text("20 of 20")).to_be_visible()


def test_pauses(visit: Visit) -> None:
    visit.open("walkthrough", scene=SCENE, frames=500, size=128, techniques="bvh/while-while")
    visit.page.get_by_role("button", name="Play").click()
    visit.page.wait_for_function("() => Number(document.querySelector('canvas.view').dataset.frame) > 3")
    visit.page.get_by_role("button", name="Pause").click()
    visit.page.wait_for_timeout(300)
    frame = visit.canvas.get_attribute("data-frame")
    visit.page.wait_for_timeout(300)
    assert visit.canvas.get_attribute("data-frame") == frame
