"""Figures 3 to 5 and the report's images: the rendered scenes, side by side with what they show."""

import base64
import io
from collections.abc import Sequence
from pathlib import Path

from PIL import Image, ImageDraw

from raywalk.contact import ACCENT, FAINT, INK, PAPER, fitted, font
from raywalk.errors import RaywalkError
from raywalk.images import opened
from raywalk.study.collect import Picture, Study

MARGIN, GAP, TITLE, CAPTION = 24, 14, 56, 50
TILE = 640  # pixels of a tile's longer side
QUALITY = 86  # of the report's JPEGs


def loaded(picture: Picture) -> Image.Image:
    try:
        return opened(picture.path.read_bytes())
    except OSError as error:
        raise RaywalkError(f"{picture.path} cannot be read ({error.strerror}); start over with --fresh") from error


def montage(study: Study, names: Sequence[str], title: str, path: Path) -> None:
    """The scenes that have an image, in one row under a title."""
    pictures = [study.pictures[name] for name in names if name in study.pictures]
    images = [loaded(picture) for picture in pictures]
    for image in images:
        image.thumbnail((TILE, TILE), Image.Resampling.LANCZOS)
    width = sum(image.width for image in images) + GAP * (len(images) - 1) + 2 * MARGIN
    sheet = Image.new("RGB", (width, TITLE + max(image.height for image in images) + CAPTION + MARGIN), PAPER)
    draw = ImageDraw.Draw(sheet)
    draw.text((MARGIN, 16), fitted(draw, title, font(22), width - 2 * MARGIN), INK, font(22))
    left = MARGIN
    for picture, image in zip(pictures, images, strict=True):
        sheet.paste(image, (left, TITLE))
        below = TITLE + image.height
        scene = study.scene(picture.scene)
        draw.text((left, below + 8), fitted(draw, picture.scene, font(18), image.width), ACCENT, font(18))
        facts = f"{scene.triangles:,} triangles, {scene.fidelity}" if scene else ""
        draw.text((left, below + 32), fitted(draw, facts, font(14), image.width), FAINT, font(14))
        left += image.width + GAP
    content = io.BytesIO()
    sheet.save(content, "PNG")
    path.write_bytes(content.getvalue())


def data_url(picture: Picture) -> str:
    """The image inside the page, as JPEG."""
    content = io.BytesIO()
    loaded(picture).save(content, "JPEG", quality=QUALITY, optimize=True)
    return "data:image/jpeg;base64," + base64.b64encode(content.getvalue()).decode()
