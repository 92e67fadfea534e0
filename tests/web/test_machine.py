"""Machine: what it is, what lies in memory, pins and evictions."""

from playwright.sync_api import expect

from tests.api.conftest import Daemon
from tests.web.conftest import Visit


def test_device_and_versions(visit: Visit, daemon: Daemon) -> None:
    machine = daemon.json("GET", "/v1/system", 200)["machine"]
    visit.open("machine")
    expect(visit.page.get_by_label("Device")).to_contain_text(machine["device"])
    expect(visit.page.get_by_label("Versions")).to_contain_text(machine["git_commit"])


def test_pin_and_evict(visit: Visit, daemon: Daemon) -> None:
    daemon.load("soup", triangles=500)
    daemon.build("soup", "bvh")
    visit.open("machine")
    page = visit.page
    pin, evict = page.get_by_label("pin soup.bvh"), page.get_by_role("button", name="Evict soup.bvh")
    pin.focus()
    visit.page.keyboard.press("Space")
    expect(evict).to_be_disabled()
    expect(pin).to_be_focused()
    daemon.problem("DELETE", "/v1/structures/soup.bvh", 409, "pinned")
    page.get_by_role("button", name="Evict soup", exact=True).click()
    expect(visit.notice("'soup.bvh' is pinned")).to_be_visible()
    pin.uncheck()
    evict.click()
    expect(evict).to_have_count(0)
    page.get_by_role("button", name="Evict soup", exact=True).click()
    expect(page.get_by_role("button", name="Evict soup", exact=True)).to_have_count(0)


def test_why_there_is_no_gpu(visit: Visit) -> None:
    def without_gpu(route) -> None:
        system = route.fetch().json()
        system["device"]["no_cuda"] = "No library libcuda.so.1 <b>here</b>."
        system["warnings"] = ["The governor is powersave."]
        route.fulfill(json=system)

    visit.page.route("**/v1/system", without_gpu)
    visit.open("machine")
    warnings = visit.page.locator(".warnings")
    expect(warnings).to_contain_text("No GPU is used: No library libcuda.so.1 <b>here</b>.")
    expect(warnings).to_contain_text("The governor is powersave.")
