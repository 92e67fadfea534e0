"""The contact sheet: every technique's image, its steps and its difference to the reference, and the walkthrough."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFilter, ImageFont

from raywalk.heat import heat

PAPER, INK, FAINT = (18, 20, 26), (236, 238, 242), (140, 148, 160)
ACCENT, GOOD = (250, 168, 40), (110, 200, 120)
MARGIN, GAP, TITLE, LABEL = 28, 12, 92, 44
FEWEST = 6  # places in the strip of the walkthrough
GROWN = 9  # pixels to a side
DIFFERENCE_FULL = 1 / 16  # of the range of sRGB values: red in the difference map


@dataclass
class Panel:
    """One technique: image (h, w, 3) of 8 bits; steps a primary ray (h, w), None where it cannot count."""

    name: str
    caption: str
    image: NDArray[np.uint8]
    steps: NDArray[np.float32] | None


@dataclass
class Reference:
    """What every image is compared with."""

    name: str
    image: NDArray[np.uint8]


def contact_sheet(
    title: str,
    subtitle: str,
    panels: Sequence[Panel],
    reference: Reference,
    walk: Sequence[Image.Image],
    tile: int = 248,
) -> Image.Image:
    """Images, steps and (if there are any) differences in one column a technique, then a strip of the walkthrough."""
    columns = len(panels)
    height = round(tile * panels[0].image.shape[0] / panels[0].image.shape[1])
    width = 2 * MARGIN + columns * tile + (columns - 1) * GAP
    strip = strip_of(walk, width - 2 * MARGIN)
    rows = [image_row(panels), steps_row(panels)]
    same = all(np.array_equal(panel.image, reference.image) for panel in panels)
    if not same:
        rows.append(difference_row(panels, reference))
    bottom = TITLE + len(rows) * (LABEL + height + GAP)
    sheet = Image.new("RGB", (width, bottom + 2 * LABEL + strip.height + MARGIN), PAPER)
    draw = ImageDraw.Draw(sheet)
    draw.text((MARGIN, 22), title, INK, font(28))
    draw.text((MARGIN, 60), fitted(draw, subtitle, font(14), width - 2 * MARGIN), FAINT, font(14))
    for number, row in enumerate(rows):
        top = TITLE + number * (LABEL + height + GAP)
        for column, (image, name, caption) in enumerate(row):
            left = MARGIN + column * (tile + GAP)
            draw.text((left, top + 4), fitted(draw, name, font(15), tile), INK, font(15))
            draw.text((left, top + 24), fitted(draw, caption, font(12), tile), FAINT, font(12))
            sheet.paste(image.resize((tile, height), Image.Resampling.LANCZOS), (left, top + LABEL))
    same_text, other_text = "every pixel is the same in all images", "pixels that differ are drawn larger than they are"
    verdict = same_text if same else other_text
    draw.text((MARGIN, bottom + 6), f"compared with {reference.name}: {verdict}", GOOD if same else FAINT, font(15))
    draw.text((MARGIN, bottom + LABEL + 14), f"walkthrough, {len(walk)} of its frames", ACCENT, font(15))
    sheet.paste(strip, (MARGIN, bottom + 2 * LABEL))
    return sheet


Tile = tuple[Image.Image, str, str]


def image_row(panels: Sequence[Panel]) -> list[Tile]:
    return [(Image.fromarray(panel.image), panel.name, panel.caption) for panel in panels]


def steps_row(panels: Sequence[Panel]) -> list[Tile]:
    """One scale for all, so that the colours can be compared."""
    counted = [panel.steps for panel in panels if panel.steps is not None]
    full = max((float(np.percentile(steps, 99.5)) for steps in counted), default=1.0)
    tiles = []
    for panel in panels:
        if panel.steps is None:
            tiles.append((blank(panel), "steps", "this technique cannot count"))
        else:
            caption = f"mean {panel.steps.mean():.1f} a primary ray, red from {full:.0f}"
            tiles.append((Image.fromarray(heat(panel.steps, full)), "steps", caption))
    return tiles


def difference_row(panels: Sequence[Panel], reference: Reference) -> list[Tile]:
    tiles = []
    for panel in panels:
        difference = np.abs(panel.image.astype(float) - reference.image.astype(float)).max(axis=2) / 255
        count = int((difference > 0).sum())
        caption = (
            f"{count} pixel{'s differ' if count != 1 else ' differs'}, by {255 * difference.max():.0f}/255 at most"
            if count
            else "none"
        )
        tiles.append((Image.fromarray(heat(grown(difference), DIFFERENCE_FULL)), "difference", caption))
    return tiles


def grown(difference: NDArray[np.float64]) -> NDArray[np.float64]:
    """Every pixel takes the largest difference around it, so that a single one can be seen in a small tile."""
    levels = Image.fromarray(np.round(255 * difference).astype(np.uint8))
    return np.asarray(levels.filter(ImageFilter.MaxFilter(GROWN))) / 255


def blank(panel: Panel) -> Image.Image:
    return Image.new("RGB", (panel.image.shape[1], panel.image.shape[0]), (28, 31, 39))


def strip_of(images: Sequence[Image.Image], width: int) -> Image.Image:
    """Images side by side over the width of the sheet; a few of them stay small."""
    count = max(FEWEST, len(images))
    each = (width - (count - 1) * GAP) // count
    height = round(each * images[0].height / images[0].width) if images else 1
    strip = Image.new("RGB", (width, height), PAPER)
    for number, image in enumerate(images):
        strip.paste(image.resize((each, height), Image.Resampling.LANCZOS), (number * (each + GAP), 0))
    return strip


def font(size: int) -> ImageFont.FreeTypeFont | ImageFont.ImageFont:
    return ImageFont.load_default(size)


def fitted(draw: ImageDraw.ImageDraw, text: str, face: ImageFont.FreeTypeFont | ImageFont.ImageFont, width: int) -> str:
    """The text, cut where it would leave its place."""
    if draw.textlength(text, face) <= width:
        return text
    while text and draw.textlength(text + "…", face) > width:
        text = text[:-1]
    return text + "…"
