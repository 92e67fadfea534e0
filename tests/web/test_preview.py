"""Preview: the camera moves, the image follows, and what goes wrong is said."""

from urllib.parse import parse_qs

import pytest
from playwright.sync_api import expect

from tests.api.conftest import Daemon
from tests.web.conftest import SCENE, TRIANGLES, Visit


def test_drag_changes_the_image_with_one_request_at_a_time(visit: Visit) -> None:
    visit.preview()
    before, frames = visit.image(), visit.frames()
    visit.drag(160, 40, steps=25)
    visit.await_frames(frames)
    assert visit.image() != before
    assert visit.most_under_way == 1


def test_the_address_holds_the_view(visit: Visit) -> None:
    visit.preview()
    frames = visit.frames()
    visit.drag(120, 60)
    visit.await_frames(frames)
    visit.page.wait_for_function("() => location.hash.includes('eye=')")
    visit.page.wait_for_timeout(400)
    image, address = visit.image(), visit.page.url
    query = parse_qs(address.split("?", 1)[1])
    assert len(query["eye"][0].split(",")) == 3
    other = Visit(visit.page.context.new_page(), int(visit.base.rsplit(":", 1)[1]))
    other.page.goto(address)
    other.await_full()
    assert other.image() == image


def test_keyboard_turns_and_goes_home(visit: Visit) -> None:
    visit.preview()
    first, frames = visit.image(), visit.frames()
    visit.canvas.focus()
    visit.page.keyboard.down("ArrowLeft")
    visit.page.wait_for_timeout(200)
    visit.page.keyboard.up("ArrowLeft")
    visit.await_frames(frames + 1)
    assert visit.image() != first
    frames = visit.frames()
    visit.page.keyboard.press("Home")
    visit.await_frames(frames)
    assert visit.image() == first


def test_wheel_and_fly(visit: Visit) -> None:
    visit.preview()
    first, frames = visit.image(), visit.frames()
    visit.canvas.hover()
    visit.page.mouse.wheel(0, -300)
    visit.await_frames(frames)
    near = visit.image()
    assert near != first
    visit.page.get_by_role("radio", name="Fly").check()
    frames = visit.frames()
    visit.drag(60, 0)
    visit.await_frames(frames)
    assert visit.image() != near


def test_a_key_stops_when_it_is_released(visit: Visit) -> None:
    visit.preview()
    visit.canvas.focus()
    first, frames = visit.image(), visit.frames()
    for press in (visit.page.keyboard.down, visit.page.keyboard.up):
        press("Shift")
        press("Equal")  # "+" while Shift is held, "=" when it is released first
    visit.await_frames(frames)
    still, frames = visit.image(), visit.frames()
    assert still != first
    visit.page.wait_for_timeout(400)
    assert visit.frames() == frames


def test_a_tap_moves_the_camera(visit: Visit) -> None:
    visit.preview()
    visit.canvas.focus()
    image, frames = visit.image(), visit.frames()
    visit.page.keyboard.press("ArrowLeft")
    visit.await_frames(frames)
    assert visit.image() != image


def test_a_scene_that_was_left_moves_no_camera(visit: Visit, daemon: Daemon) -> None:
    daemon.load("soup", triangles=500)
    expected = visit.preview().image()
    visit.page.evaluate("() => { window.location.hash = '#/preview?scene=nowhere'; }")
    expect(visit.notice("no scene 'nowhere'")).to_be_visible()

    def late(route) -> None:
        visit.page.wait_for_timeout(1500)
        route.continue_()

    visit.page.route("**/v1/scenes/soup/cameras*", late)
    visit.page.get_by_role("button", name="soup").click()
    visit.page.wait_for_timeout(300)
    frames = visit.frames()
    visit.page.get_by_role("button", name=SCENE).click()
    visit.page.get_by_label("Mode", exact=True).select_option("primary")
    visit.await_frames(frames)
    visit.page.wait_for_timeout(2000)
    assert visit.image() == expected


def test_structure_and_output(visit: Visit) -> None:
    visit.preview()
    image, frames = visit.image(), visit.frames()
    visit.page.get_by_label("Structure").select_option("grid")
    visit.await_frames(frames)
    assert visit.image() == image  # another structure, the same picture
    expect(visit.page.get_by_label("Traversal")).to_have_value("dda")
    frames = visit.frames()
    visit.page.get_by_label("Show").select_option("normal")
    visit.await_frames(frames)
    assert visit.image() != image


def test_lights(visit: Visit) -> None:
    visit.preview(mode="primary")
    image, frames = visit.image(), visit.frames()
    lights = visit.page.get_by_label("Lights")
    expect(lights).to_have_value("all")
    lights.select_option("0")
    visit.await_frames(frames)
    assert visit.image() != image
    visit.page.wait_for_function("() => location.hash.includes('lights=0')")
    frames = visit.frames()
    lights.select_option("all")
    visit.await_frames(frames)
    assert visit.image() == image


def test_options_stay_under_the_hand(visit: Visit) -> None:
    visit.preview()
    visit.page.get_by_text("Build options").click()
    leaf = visit.page.get_by_label("max_leaf")
    before = int(leaf.input_value())
    leaf.focus()
    for _ in range(2):
        frames = visit.frames()
        visit.page.keyboard.press("ArrowUp")
        visit.await_frames(frames)
    expect(leaf).to_be_focused()
    expect(leaf).to_have_value(str(before + 2))
    visit.page.get_by_label("Mode").select_option("shadow")
    expect(leaf).to_be_visible()


@pytest.mark.parametrize(
    "parameters", [{"structure": "kdtree"}, {"structure": "kdtree", "traversal": "packet", "build": '{"nothing":3}'}]
)
def test_a_link_with_another_structures_traversal(visit: Visit, parameters: dict[str, str]) -> None:
    visit.preview(**parameters)
    expect(visit.page.get_by_label("Traversal", exact=True)).to_have_value("short-stack-3")
    expect(visit.page.locator("#notices .notice")).to_have_count(0)


def test_timing_is_shown(visit: Visit) -> None:
    visit.preview()
    text = visit.page.get_by_label("Timing").inner_text()
    assert all(part in text for part in ("queue", "trace", "readback", "encode", "network", "ms"))


def test_downloads_and_command(visit: Visit) -> None:
    visit.preview(mode="shadow")
    for label, beginning in (("PNG", b"\x89PNG"), ("EXR", b"\x76\x2f\x31\x01")):
        with visit.page.expect_download() as download:
            visit.page.get_by_role("button", name=label, exact=True).click()
        assert download.value.path().read_bytes().startswith(beginning)
    visit.page.get_by_role("button", name="Copy command").click()
    expect(visit.notice("Command copied")).to_be_visible()
    command = visit.page.evaluate("navigator.clipboard.readText()")
    assert command.startswith(f"raywalk --server {visit.base} render {SCENE} --structure bvh")
    assert "--eye=" in command and "--up=" in command


def test_a_camera_at_infinity_is_refused(visit: Visit) -> None:
    for eye in ("1e999,0,0", "1e30,0,0", "nonsense", "0,0,0"):
        visit.page.goto("about:blank")
        visit.preview(eye=eye, target="0,0,0")
        expect(visit.notice("cannot be used")).to_be_visible()


def test_an_evicted_scene_is_said_and_loaded_again(visit: Visit, daemon: Daemon) -> None:
    visit.preview()
    daemon.client.delete(f"/v1/scenes/{SCENE}")
    visit.drag(50, 0)
    notice = visit.notice("not loaded")
    expect(notice).to_be_visible()
    daemon.load(SCENE, triangles=TRIANGLES)
    frames = visit.frames()
    notice.get_by_role("button", name="Load it again").click()
    visit.await_frames(frames)
    expect(notice).to_have_count(0)


def test_an_unknown_scene_is_said(visit: Visit) -> None:
    visit.open("preview", scene="nowhere")
    expect(visit.notice("There is no scene 'nowhere'.")).to_be_visible()
    visit.page.get_by_role("button", name=SCENE).click()
    visit.await_full()
    expect(visit.notice("nowhere")).to_have_count(0)


def test_resize_in_mid_drag(visit: Visit) -> None:
    visit.preview()
    box = visit.canvas.bounding_box()
    assert box is not None
    visit.page.mouse.move(box["x"] + 200, box["y"] + 200)
    visit.page.mouse.down()
    visit.page.mouse.move(box["x"] + 250, box["y"] + 210, steps=4)
    visit.page.set_viewport_size({"width": 800, "height": 700})
    visit.page.mouse.move(box["x"] + 150, box["y"] + 220, steps=4)
    visit.page.mouse.up()
    visit.page.wait_for_function(
        "() => { const c = document.querySelector('canvas.view');"
        " return c.dataset.quality === 'full' && c.width === c.clientWidth && c.height === c.clientHeight; }"
    )


def test_a_refused_token_is_asked_for(visit: Visit) -> None:
    seen: list[str | None] = []

    def guard(route) -> None:
        seen.append(route.request.headers.get("authorization"))
        if seen[-1] == "Bearer open-sesame":
            route.continue_()
        else:
            problem = '{"type":"about:blank","title":"Unauthorized","status":401,"detail":"No.","code":"unauthorized"}'
            route.fulfill(status=401, content_type="application/problem+json", body=problem)

    visit.page.route("**/v1/**", guard)
    visit.open("preview", scene=SCENE)
    field = visit.page.get_by_label("Access token")
    field.fill("open-sesame")
    field.press("Enter")
    visit.await_full()
    assert None in seen
    expect(field).to_have_count(0)


def test_a_busy_device_is_said(visit: Visit) -> None:
    visit.preview()

    def late(route) -> None:
        visit.page.wait_for_timeout(2500)
        route.continue_()

    visit.page.route("**/v1/frames", late, times=1)
    visit.page.get_by_label("Show").select_option("depth")
    expect(visit.page.get_by_text("Waiting for the device")).to_be_visible()
    expect(visit.page.get_by_text("Waiting for the device")).to_have_count(0)


def test_an_overloaded_daemon_is_asked_again(visit: Visit) -> None:
    visit.preview()
    frames = visit.frames()
    problem = '{"status":503,"code":"queue_full","detail":"The device is busy.","retryable":true}'
    busy = {"status": 503, "content_type": "application/problem+json", "body": problem}
    visit.page.route("**/v1/frames", lambda route: route.fulfill(**busy), times=2)
    visit.drag(40, 0)
    visit.await_frames(frames)
    expect(visit.notice("The device is busy.")).to_have_count(0)
