"""Prints what the web client must reach: .venv/bin/python tests/measure/web.py [SCENE ...]

Size of the bundle, first paint over loopback, and on the CPU at 512x512 the time from a move of the camera to the
first image that shows it. A benchmark, not a test: other programs' load counts. Needs a Chromium."""

import gzip
import re
import statistics
import sys
import time

from playwright.sync_api import Browser, sync_playwright
from raywalk import Client, LocalDaemon
from raywalk.follow import built

from tests.web.conftest import ROOT, Visit, find_browser

PAINTS = 12
MOVES = 400
MOVE_S = 1 / 60
LISTEN = """() => {
  window.drawn = [];
  document.addEventListener("drawn", (event) => {
    const { timing, size, full, latencies } = event.detail;
    window.drawn.push({ trace: timing.trace, total: timing.total, side: size.width, full, latencies });
  });
}"""


def share(values: list[float], part: float) -> float:
    return sorted(values)[min(len(values) - 1, int(part * len(values)))]


def print_bundle() -> None:
    built_sites = sorted(ROOT.glob("build/*/server/web"), key=lambda path: path.stat().st_mtime)
    sizes: dict[str, int] = {}
    for path in built_sites[-1].rglob("*"):
        if path.is_file():
            packed = len(gzip.compress(path.read_bytes(), 9))
            sizes[path.suffix] = sizes.get(path.suffix, 0) + min(packed, path.stat().st_size)
    code = sum(size for suffix, size in sizes.items() if suffix != ".webp")
    pictures = sizes.get(".webp", 0)
    print(f"bundle: {code / 1e3:.1f} kB compressed (goal at most 150), {pictures / 1e3:.1f} kB of pictures")


def print_first_paint(browser: Browser, base: str) -> None:
    paints, contents = [], []
    for _ in range(PAINTS):
        context = browser.new_context()  # nothing cached
        page = context.new_page()
        page.goto(f"{base}/#/machine")
        page.wait_for_selector(".facts dd")
        entries = page.evaluate(
            "() => Object.fromEntries(performance.getEntriesByType('paint').map((e) => [e.name, e.startTime]))"
        )
        paints.append(entries["first-contentful-paint"])
        contents.append(page.evaluate("() => performance.now()"))
        context.close()
    print(
        f"first contentful paint, nothing cached, {PAINTS} visits: median {statistics.median(paints):.0f} ms, "
        f"longest {max(paints):.0f} ms (goal at most 300); page with its data {statistics.median(contents):.0f} ms"
    )


def print_drag(browser: Browser, base: str, scene: str, mode: str) -> None:
    context = browser.new_context(viewport={"width": 1280, "height": 800})
    visit = Visit(context.new_page(), int(re.search(r":(\d+)$", base)[1]))
    visit.preview(scene=scene, mode=mode)
    frames = visit.frames()
    visit.page.get_by_label("Size").select_option("512")
    visit.await_frames(frames)
    visit.page.evaluate(LISTEN)
    box = visit.canvas.bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    visit.page.mouse.move(x, y)
    visit.page.mouse.down()
    begin = time.monotonic()
    for move in range(MOVES):
        visit.page.mouse.move(x + 150 * ((move % 80) / 40 - 1), y + 20 * (move % 7))
        time.sleep(max(0.0, begin + (move + 1) * MOVE_S - time.monotonic()))
    visit.page.mouse.up()
    took_s = time.monotonic() - begin
    frames = visit.frames()
    visit.page.wait_for_function("() => window.drawn.length > 0 && window.drawn.at(-1).full")
    drawn = visit.page.evaluate("() => window.drawn")
    latencies = [latency for one in drawn for latency in one["latencies"]]
    sides = [one["side"] for one in drawn if not one["full"]] or [512]
    full = [one["total"] for one in drawn if one["full"]]
    print(
        f"{scene}, {mode}, 512x512: move to new image p50 {share(latencies, 0.5):.0f} ms, "
        f"p95 {share(latencies, 0.95):.0f} ms (goal at most 250), longest {max(latencies):.0f} ms; "
        f"{len(drawn) / took_s:.0f} images/s of side {statistics.median(sides):.0f} while moving; "
        f"at rest in full {statistics.median(full):.0f} ms; at most {visit.most_under_way} request under way"
    )
    context.close()


def main(scenes: list[str]) -> None:
    print_bundle()
    program = find_browser()
    if program is None:
        sys.exit("no Chromium here")
    with (
        sync_playwright() as playwright,
        LocalDaemon(arguments=("--device", "cpu")) as daemon,
        Client(daemon.base_url) as client,
    ):
        browser = playwright.chromium.launch(executable_path=program, args=["--no-sandbox"])
        print_first_paint(browser, daemon.base_url)
        for scene in scenes:
            client.load_scene(scene)
            built(client, scene, "bvh")
            for mode in ("primary", "shadow"):
                print_drag(browser, daemon.base_url, scene, mode)
        browser.close()


if __name__ == "__main__":
    main(sys.argv[1:] or ["bunny", "robots"])
