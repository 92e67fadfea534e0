"""For everybody: axe finds nothing, narrow screens are enough, the keyboard reaches all."""

import json

import pytest
from playwright.sync_api import Browser, expect

from tests.api.conftest import Daemon
from tests.web.conftest import PAGES, SCENE, WEB, Visit

AXE = WEB / "node_modules/axe-core/axe.min.js"
OUTSIDE = """() => [...document.querySelectorAll("main button, main input, main select")]
  .filter((one) => !one.closest(".scroll, .scenes") && one.getBoundingClientRect().right > 360)
  .map((one) => one.outerHTML)"""
READY = {
    "preview": "canvas.view[data-quality=full]",
    "compare": "[data-mismatches]",
    "walkthrough": "canvas.view[data-frame]",
    "benchmarks": ".bench-form",
    "machine": ".facts dd",
}


def opened(browser: Browser, daemon: Daemon, name: str, **options: object) -> Visit:
    context = browser.new_context(**{"viewport": {"width": 1200, "height": 800}} | options)
    visit = Visit(context.new_page(), daemon.port)
    scene = {"compare": {"a.scene": SCENE}, "preview": {"scene": SCENE}, "walkthrough": {"scene": SCENE}}
    visit.open(name, **scene.get(name, {}))
    visit.page.wait_for_selector(READY[name])
    return visit


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("name", PAGES)
def test_axe_finds_nothing(browser: Browser, daemon: Daemon, name: str, scheme: str) -> None:
    visit = opened(browser, daemon, name, color_scheme=scheme)
    visit.page.evaluate(AXE.read_text(encoding="utf-8"))
    found = visit.page.evaluate("axe.run()")["violations"]
    shown = [(one["id"], one["help"], [node["html"][:200] for node in one["nodes"]]) for one in found]
    visit.page.context.close()
    assert not found, json.dumps(shown, indent=1)


@pytest.mark.parametrize("name", PAGES)
def test_a_phone_is_wide_enough(browser: Browser, daemon: Daemon, name: str) -> None:
    visit = opened(browser, daemon, name, viewport={"width": 360, "height": 740}, has_touch=True)
    assert visit.page.evaluate("document.documentElement.scrollWidth") <= 360
    assert visit.page.evaluate(OUTSIDE) == []  # what is cut off without a way to scroll there
    visit.page.context.close()


def test_pages_by_keyboard(visit: Visit) -> None:
    visit.preview()
    visit.page.keyboard.press("Tab")
    expect(visit.page.get_by_role("link", name="Skip to content")).to_be_focused()
    for name in ("Raywalk", "Preview", "Compare"):
        visit.page.keyboard.press("Tab")
        expect(visit.page.get_by_role("link", name=name, exact=True)).to_be_focused()
    visit.page.keyboard.press("Enter")
    expect(visit.page).to_have_title("Compare · Raywalk")


def test_the_skip_link_and_the_way_back(visit: Visit) -> None:
    visit.preview(structure="grid", traversal="dda")
    visit.page.keyboard.press("Tab")
    visit.page.keyboard.press("Enter")
    expect(visit.page.locator("main")).to_be_focused()
    visit.page.get_by_role("link", name="Machine").click()
    expect(visit.page).to_have_title("Machine · Raywalk")
    visit.page.get_by_role("link", name="Preview", exact=True).click()
    visit.await_full()
    expect(visit.page.get_by_label("Structure")).to_have_value("grid")  # as it was left


def test_two_fingers_zoom(browser: Browser, daemon: Daemon) -> None:
    visit = opened(browser, daemon, "preview", has_touch=True, viewport={"width": 400, "height": 800})
    before, frames = visit.image(), visit.frames()
    box = visit.canvas.bounding_box()
    assert box is not None
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    session = visit.page.context.new_cdp_session(visit.page)

    def touch(kind: str, spread: float) -> None:
        points = [{"x": x - spread, "y": y, "id": 1}, {"x": x + spread, "y": y, "id": 2}]
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [] if kind == "touchEnd" else points})

    touch("touchStart", 20)
    for spread in (30, 40, 60, 80):
        touch("touchMove", spread)
    touch("touchEnd", 0)
    visit.await_frames(frames)
    assert visit.image() != before
    visit.page.context.close()
