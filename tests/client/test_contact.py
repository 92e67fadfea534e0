"""The contact sheet and its heat maps."""

import re
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from raywalk.contact import DIFFERENCE_FULL, Panel, Reference, contact_sheet, difference_row, steps_row
from raywalk.heat import STOPS, heat


@pytest.fixture
def panels() -> list[Panel]:
    image = np.full((32, 48, 3), 100, np.uint8)
    other = image.copy()
    other[3, 4] = 105
    steps = np.tile(np.arange(48, dtype=np.float32), (32, 1))
    return [Panel("bvh/packet", "1 ms", other, steps), Panel("embree/intersect", "2 ms", image, None)]


def test_heat_runs_from_end_to_end() -> None:
    colours = heat(np.array([[0, 0.5, 1, 9]]), 1)
    assert colours[0, 0].tolist() == np.round(STOPS[0]).tolist()
    assert colours[0, 2].tolist() == colours[0, 3].tolist() == np.round(STOPS[-1]).tolist()


def test_heat_is_the_palette_of_the_daemon() -> None:
    source = (Path(__file__).parents[2] / "server/image/viewable.cpp").read_text()
    table = source.split("kStops = {{{")[1].split("}}};")[0]
    numbers = [float(text) for text in re.findall(r"([\d.]+)f", table)]
    assert np.allclose(STOPS.ravel(), 255 * np.array(numbers))


def test_sheet_has_a_column_for_each_technique(panels) -> None:
    walk = [Image.new("RGB", (48, 32), (10, 200, 10))] * 4
    sheet = contact_sheet("title", "machine", panels, Reference("embree", panels[1].image), walk, tile=120)
    assert sheet.width == 2 * 28 + 2 * 120 + 12
    assert (10, 200, 10) in {colour for _, colour in sheet.getcolors(1 << 24)}


def test_sheet_of_equal_images_has_no_row_of_differences(panels) -> None:
    walk = [Image.new("RGB", (48, 32))]
    equal = [Panel(panel.name, "", panels[1].image, panel.steps) for panel in panels]
    reference = Reference("embree", panels[1].image)
    tall, short = (contact_sheet("t", "m", chosen, reference, walk, tile=120) for chosen in (panels, equal))
    assert tall.height - short.height == 80 + 44 + 12


def test_difference_is_counted(panels) -> None:
    (tile, _, caption), (_, _, same) = difference_row(panels, Reference("embree", panels[1].image))
    assert caption == "1 pixel differs, by 5/255 at most"
    assert same == "none"
    expected = heat(np.array([[5 / 255]]), DIFFERENCE_FULL)[0, 0]
    assert np.asarray(tile)[3, 4].tolist() == expected.tolist()


def test_steps_say_when_they_are_missing(panels) -> None:
    (_, _, counted), (_, _, missing) = steps_row(panels)
    assert counted.startswith("mean 23.5 a primary ray")
    assert missing == "this technique cannot count"
