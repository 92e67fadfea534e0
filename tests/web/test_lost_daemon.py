"""The daemon is killed: the pages say so, and go on when it is back."""

from pathlib import Path

import pytest
from playwright.sync_api import BrowserContext, expect

from tests.api.conftest import start, wait_for_port
from tests.web.conftest import SCENE, Visit

TEXT = "The daemon does not answer"


@pytest.mark.parametrize("name", ["preview", "walkthrough", "machine"])
def test_lost_and_back(context: BrowserContext, tmp_path: Path, name: str) -> None:
    flags = ("--device", "cpu", "--log-level", "error")
    process = start(tmp_path / "state", "--port", "0", *flags)
    port = wait_for_port(process)
    visit = Visit(context.new_page(), port)
    try:
        if name == "preview":
            visit.preview(scene=SCENE)
        elif name == "walkthrough":
            visit.open(name, scene=SCENE, frames=2000, size=128, techniques="bvh/while-while")
            visit.page.get_by_role("button", name="Play").click()
            visit.page.wait_for_function("() => document.querySelector('canvas.view').dataset.frame > 2")
        else:
            visit.open(name)
            expect(visit.page.get_by_label("Device")).to_contain_text("CPU")
        process.kill()
        process.communicate()
        expect(visit.notice(TEXT)).to_be_visible(timeout=15_000)
        expect(visit.page.locator(".connection")).to_have_text("no daemon")
        frames = visit.frames() if name == "preview" else 0
        process = start(tmp_path / "state", "--port", str(port), *flags)
        wait_for_port(process)
        expect(visit.notice(TEXT)).to_have_count(0, timeout=15_000)
        expect(visit.page.locator(".connection")).to_have_text("connected")
        if name == "preview":
            visit.await_frames(frames)
            frames = visit.frames()
            visit.drag(60, 0)
            visit.await_frames(frames)
        if name == "walkthrough":
            frame = visit.canvas.get_attribute("data-frame")
            visit.page.wait_for_function(
                "n => document.querySelector('canvas.view').dataset.frame > n + 3", arg=int(frame or 0)
            )
        assert visit.complaints == []
    finally:
        process.kill()
        process.communicate()
