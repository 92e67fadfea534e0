"""Real Chromium against the real daemon: its pages as people use them."""

import os
import shutil
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path

import pytest
from playwright.sync_api import Browser, BrowserContext, Error, Locator, Page, Request, expect, sync_playwright

from tests.api.conftest import Daemon, running_daemon

ROOT = Path(__file__).resolve().parents[2]
WEB = ROOT / "client/web"
SCENE = "organic"
TRIANGLES = 3000
LIMIT_MS = 20_000
expect.set_options(timeout=LIMIT_MS)
PAGES = ("preview", "compare", "walkthrough", "benchmarks", "machine")


def find_browser() -> str | None:
    names = (os.environ.get("RAYWALK_BROWSER", "chromium"), "chromium", "google-chrome")
    return next((found for name in names if (found := shutil.which(name))), None)


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    program = find_browser()
    if program is None:
        pytest.skip("no Chromium here; docker/install-browser gets one on Debian")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program, args=["--no-sandbox"])
        yield browser
        browser.close()


@pytest.fixture(scope="session")
def daemon(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Daemon]:
    """One daemon for all tests of pages, with a small scene in it."""
    with running_daemon(tmp_path_factory.mktemp("web")) as daemon:
        daemon.load(SCENE, triangles=TRIANGLES)
        yield daemon


class Visit:
    """A browser's page on a daemon, and what it did wrong."""

    def __init__(self, page: Page, port: int):
        self.page = page
        self.base = f"http://127.0.0.1:{port}"
        self.complaints: list[str] = []
        self.under_way = 0
        self.most_under_way = 0
        page.set_default_timeout(LIMIT_MS)
        page.on("pageerror", lambda error: self.complaints.append(str(error)))
        page.on("console", self._hear)
        page.on("request", self._begin)
        page.on("requestfinished", self._end)
        page.on("requestfailed", self._end)

    def _hear(self, message) -> None:
        is_answer = message.text.startswith("Failed to load resource")
        if message.type == "error" and not is_answer:
            self.complaints.append(message.text)

    def _begin(self, request: Request) -> None:
        if not request.url.startswith((self.base, "blob:", "about:")):
            self.complaints.append(f"asked for {request.url}")
        if request.url.endswith("/v1/frames"):
            self.under_way += 1
            self.most_under_way = max(self.most_under_way, self.under_way)

    def _end(self, request: Request) -> None:
        if request.url.endswith("/v1/frames"):
            self.under_way -= 1

    def open(self, page: str, **parameters: object) -> "Visit":
        query = "&".join(f"{name}={value}" for name, value in parameters.items())
        self.page.goto(f"{self.base}/#/{page}" + (f"?{query}" if query else ""))
        return self

    def preview(self, **parameters: object) -> "Visit":
        """The preview once its image is there in full."""
        self.open("preview", **({"scene": SCENE, "mode": "primary"} | parameters))
        self.await_full()
        return self

    @property
    def canvas(self) -> Locator:
        return self.page.locator("canvas.view").first

    def await_full(self) -> None:
        expect(self.canvas).to_have_attribute("data-quality", "full", timeout=LIMIT_MS)

    def frames(self) -> int:
        return int(self.canvas.get_attribute("data-frames") or 0)

    def await_frames(self, more_than: int) -> None:
        """Until more frames than that were drawn, and the last one in full."""
        self.page.wait_for_function(
            "n => { const c = document.querySelector('canvas.view');"
            " return Number(c.dataset.frames ?? 0) > n && c.dataset.quality === 'full'; }",
            arg=more_than,
        )

    def image(self) -> str:
        return self.canvas.evaluate("canvas => canvas.toDataURL()")

    def drag(self, right: float, down: float, steps: int = 8) -> None:
        box = self.canvas.bounding_box()
        assert box is not None
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        self.page.mouse.move(x, y)
        self.page.mouse.down()
        self.page.mouse.move(x + right, y + down, steps=steps)
        self.page.mouse.up()

    def notice(self, text: str) -> Locator:
        return self.page.locator("#notices .notice", has_text=text)


@pytest.fixture
def context(browser: Browser) -> Iterator[BrowserContext]:
    context = browser.new_context(viewport={"width": 1200, "height": 800})
    context.grant_permissions(["clipboard-read", "clipboard-write"])
    yield context
    with suppress(Error):
        context.close()


@pytest.fixture
def visit(context: BrowserContext, daemon: Daemon) -> Iterator[Visit]:
    """A page on the shared daemon; errors in its scripts fail the test."""
    visit = Visit(context.new_page(), daemon.port)
    yield visit
    assert visit.complaints == []


def eventually(check: Callable[[], bool], limit_s: float = 20.0) -> None:
    end = time.monotonic() + limit_s
    while not check():
        assert time.monotonic() < end, "it did not happen"
        threading.Event().wait(0.05)
