"""Compare: correct structures agree, a changed knob is seen, heat maps have figures."""

import re

import pytest
from playwright.sync_api import expect

from tests.web.conftest import LIMIT_MS, SCENE, Visit


@pytest.fixture
def compared(visit: Visit) -> Visit:
    visit.open("compare", **{"a.scene": SCENE, "a.mode": "shadow", "b.mode": "shadow"})
    visit.page.get_by_label("Size").select_option("256")
    await_figures(visit, re.compile(r"\d"))
    return visit


def await_figures(visit: Visit, mismatches: object) -> None:
    expect(visit.page.get_by_label("Figures")).to_have_attribute("data-mismatches", mismatches, timeout=LIMIT_MS)


def test_two_correct_structures_agree(compared: Visit) -> None:
    await_figures(compared, "0")
    expect(compared.page.get_by_label("Figures")).to_have_attribute("data-changed", "0")
    compared.drag(70, 20)
    await_figures(compared, "0")


def test_a_changed_knob_is_seen(compared: Visit) -> None:
    b = compared.page.locator(".two .card").nth(1)
    b.get_by_text("Kernel options").click()
    b.get_by_label("spawn").select_option("none")  # shadow rays meet the triangles that they leave
    figures = compared.page.get_by_label("Figures")
    expect(figures).to_have_attribute("data-changed", re.compile(r"[1-9]\d*"), timeout=LIMIT_MS)
    compared.page.get_by_role("radio", name="Difference").check()
    expect(compared.page.locator(".legend")).to_contain_text("levels of 255")


def test_another_link_is_followed(compared: Visit) -> None:
    link = f"#/compare?a.scene={SCENE}&a.lights=0&b.structure=grid&b.traversal=dda"
    compared.page.evaluate("link => { location.hash = link; }", link)
    expect(compared.page.locator("figcaption").nth(1)).to_have_text("B: grid/dda, shadow")
    figures = compared.page.get_by_label("Figures")
    expect(figures).to_have_attribute("data-changed", re.compile(r"[1-9]\d*"), timeout=LIMIT_MS)
    await_figures(compared, "0")


def test_a_camera_at_infinity_is_refused(visit: Visit) -> None:
    visit.open("compare", **{"a.scene": SCENE, "eye": "1e999,0,0", "target": "0,0,0"})
    visit.await_full()
    expect(visit.notice("cannot be used")).to_be_visible()


def test_heat_maps_and_the_figures_of_a_pixel(compared: Visit) -> None:
    for sight in ("Steps", "Tests"):
        compared.page.get_by_role("radio", name=sight).check()
        expect(compared.page.locator(".legend")).to_contain_text(f"{sight.lower()} and more")
        expect(compared.page.locator("canvas.overlay").nth(1)).to_be_visible()
    compared.canvas.hover()
    pixel = compared.page.locator("table.pixel")
    expect(pixel).to_contain_text(re.compile(r"Pixel \d+, \d+"))
    steps = pixel.locator("tr", has_text="steps").locator("td")
    assert all(int(text.replace(",", "")) > 0 for text in steps.all_inner_texts())
    compared.canvas.focus()
    before = pixel.locator("caption").inner_text()
    compared.page.keyboard.press("Alt+ArrowRight")
    expect(pixel.locator("caption")).not_to_have_text(before)


def test_wiper(compared: Visit) -> None:
    compared.page.get_by_role("radio", name="Wiper").check()
    wiper = compared.page.get_by_role("slider", name="Wiper")
    wiper.focus()
    compared.page.keyboard.press("Home")
    half = compared.page.locator(".half.b")
    assert "0%" in half.evaluate("half => half.style.clipPath")
    compared.page.keyboard.press("End")
    assert "100%" in half.evaluate("half => half.style.clipPath")


def test_cameras_go_together(compared: Visit) -> None:
    images = compared.page.locator("canvas.view")
    before = [image.evaluate("canvas => canvas.toDataURL()") for image in images.all()]
    compared.drag(80, 0)
    await_figures(compared, re.compile(r"\d"))
    after = [image.evaluate("canvas => canvas.toDataURL()") for image in images.all()]
    assert all(old != new for old, new in zip(before, after, strict=True))
    assert after[0] == after[1]
