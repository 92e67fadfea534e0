"""One description of a drawing and its two writers: SVG as text, and PNG."""

import io
import math
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape

from PIL import Image, ImageDraw

from raywalk.contact import font
from raywalk.study.svg import element, tip

Place = tuple[float, float]
SCALE = 2  # pixels of the PNG for one unit of the drawing
FINER = 2  # drawn so much larger, then made smaller: smooth edges
TURNS = {"circle": (24, 0.0), "square": (4, 45.0), "diamond": (4, 0.0), "up": (3, 30.0), "down": (3, -30.0)}
TURNS |= {"hexagon": (6, 0.0), "pentagon": (5, -18.0)}
AREAS = {"square": 1.12, "diamond": 1.22, "up": 1.35, "down": 1.35, "hexagon": 1.05, "pentagon": 1.12}  # look alike
ANCHORS = {"start": "ls", "middle": "ms", "end": "rs"}


@dataclass(frozen=True)
class Text:
    """`at` is on the base line."""

    at: Place
    text: str
    size: float = 12
    anchor: str = "start"
    colour: str = "#1d2129"
    halo: bool = False  # a white rim, for text over lines


@dataclass(frozen=True)
class Line:
    points: Sequence[Place]
    colour: str
    width: float = 1
    dashed: bool = False


@dataclass(frozen=True)
class Area:
    """A filled polygon with a rim; `tip` is what a reader sees who points at it in a browser."""

    points: Sequence[Place]
    fill: str
    rim: str | None = None
    width: float = 1
    tip: str = ""


Part = Text | Line | Area


@dataclass(frozen=True)
class Drawing:
    width: float
    height: float
    title: str
    parts: Sequence[Part]


def shape(kind: str, at: Place, radius: float) -> list[Place]:
    """Corners of a regular figure; all kinds look alike large."""
    corners, turn = TURNS[kind]
    reach = radius * AREAS.get(kind, 1.0)
    angles = [math.radians(turn + 360 * number / corners) for number in range(corners)]
    return [(at[0] + reach * math.cos(angle), at[1] + reach * math.sin(angle)) for angle in angles]


def svg_of(drawing: Drawing, standalone: bool = True) -> str:
    """On white paper whatever the reader's colours: they are part of what the chart says."""
    paper = element("rect", width=round(drawing.width), height=round(drawing.height), fill="#ffffff")
    inner = element("title", escape(drawing.title)) + paper + "".join(svg_part(part) for part in drawing.parts)
    shown = {"viewBox": f"0 0 {drawing.width:.0f} {drawing.height:.0f}", "role": "img"}
    own = {"width": f"{drawing.width:.0f}", "height": f"{drawing.height:.0f}"} if standalone else {}
    return element("svg", inner, xmlns="http://www.w3.org/2000/svg", **shown, **own)


def svg_part(part: Part) -> str:
    if isinstance(part, Text):
        style = f"font-family:'DejaVu Sans',sans-serif;font-size:{part.size:g}px;fill:{part.colour}"
        style += ";paint-order:stroke;stroke:#ffffff;stroke-width:3px" if part.halo else ""
        return element("text", escape(part.text), x=part.at[0], y=part.at[1], text_anchor=part.anchor, style=style)
    places = " ".join(f"{x:.1f},{y:.1f}" for x, y in part.points)
    if isinstance(part, Line):
        style = f"fill:none;stroke:{part.colour};stroke-width:{part.width:g}"
        style += ";stroke-dasharray:5 4" if part.dashed else ""
        return element("polyline", points=places, style=style)
    style = f"fill:{part.fill}" + (f";stroke:{part.rim};stroke-width:{part.width:g}" if part.rim else "")
    return element("polygon", tip(part.tip) if part.tip else "", points=places, style=style)


def png_of(drawing: Drawing) -> bytes:
    factor = SCALE * FINER
    size = (round(drawing.width * factor), round(drawing.height * factor))
    image = Image.new("RGB", size, "#ffffff")
    draw = ImageDraw.Draw(image)
    for part in drawing.parts:
        png_part(draw, part, factor)
    small = image.resize((size[0] // FINER, size[1] // FINER), Image.Resampling.LANCZOS)
    content = io.BytesIO()
    small.save(content, "PNG", optimize=True)
    return content.getvalue()


def png_part(draw: ImageDraw.ImageDraw, part: Part, factor: float) -> None:
    if isinstance(part, Text):
        place = (part.at[0] * factor, part.at[1] * factor)
        rim = {"stroke_width": round(1.5 * factor), "stroke_fill": "#ffffff"} if part.halo else {}
        draw.text(place, part.text, part.colour, font(round(part.size * factor)), anchor=ANCHORS[part.anchor], **rim)
        return
    places = [(x * factor, y * factor) for x, y in part.points]
    if isinstance(part, Line):
        for one in dashes(places, 5 * factor, 4 * factor) if part.dashed else [places]:
            draw.line(one, part.colour, round(part.width * factor), joint="curve")
        return
    draw.polygon(places, part.fill)
    if part.rim:
        draw.line([*places, places[0], places[1]], part.rim, round(part.width * factor), joint="curve")


def dashes(points: Sequence[Place], on: float, off: float) -> list[list[Place]]:
    """The strokes of a dashed line."""
    strokes: list[list[Place]] = []
    for (x0, y0), (x1, y1) in zip(points, points[1:], strict=False):
        length = math.hypot(x1 - x0, y1 - y0)
        done = 0.0
        while done < length:
            ends = [done / length, min(done + on, length) / length]
            strokes.append([(x0 + (x1 - x0) * end, y0 + (y1 - y0) * end) for end in ends])
            done += on + off
    return strokes
