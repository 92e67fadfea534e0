"""The chart of speed against error: one panel a class of rays, a point for each technique with its knobs."""

import math
from collections.abc import Callable, Sequence

from raywalk.accuracy.axes import LogAxis, around, number_text
from raywalk.accuracy.drawing import Area, Drawing, Line, Part, Place, Text, shape
from raywalk.accuracy.points import SLABS, Point, pareto, points_of, rounded
from raywalk.models import AccuracyResult

INK, FAINT, RULE, BAND, FRONT = "#1d2129", "#5c6470", "#dfe3e9", "#f1f3f6", "#b3261e"
# Colours of structures that the colour-blind can tell (Okabe and Ito), each with a light tint; shapes of techniques.
COLOURS = {"grid": ("#d55e00", "#f6cdb3"), "kdtree": ("#009e73", "#b3e2d5"), "bvh": ("#0072b2", "#b3d5e8")}
COLOURS |= {"embree": ("#5f5f5f", "#d3d3d3")}
OTHER_COLOUR = ("#cc79a7", "#f0d7e5")
SHAPES = {"grid/dda": "square", "kdtree/short-stack-3": "up", "kdtree/short-stack-2": "down"}
SHAPES |= {"bvh/packet": "hexagon", "bvh/while-while": "circle", "embree/intersect": "diamond"}
OTHER_SHAPE = "pentagon"
TITLES = {
    "primary": "primary rays",
    "shadow": "shadow rays, any hit",
    "diffuse": "diffuse bounces",
    "random": "random rays",
    "edge": "rays aimed at edges",
    "vertex": "rays aimed at vertices",
}

COLUMNS = 3
PANEL, PLOT = (388.0, 366.0), (316.0, 196.0)  # with all around it; of the plot above the band
LEFT, TOP, GAP = 54.0, 34.0, 16.0
LANE = 19.0  # of a technique among those without a wrong ray
HEAD, LEGEND, MARGIN = 66.0, 92.0, 20.0
LEGEND_LINE = 24.0
LARGEST = 1e6  # ppm


def chart(result: AccuracyResult, machine: str) -> Drawing:
    """`machine` is the line that says where the figures come from."""
    classes = points_of(result)
    columns = min(COLUMNS, max(1, len(classes)))
    rows = math.ceil(len(classes) / COLUMNS)
    techniques = list(dict.fromkeys(point.technique for points in classes.values() for point in points))
    width = 2 * MARGIN + columns * PANEL[0] + (columns - 1) * GAP
    band = LANE * len(techniques) + 22
    panel_height = PANEL[1] + band - 86
    scene = result.scene.name if result.scene else ""
    title = f"Speed against error: {scene}"
    parts: list[Part] = [Text((MARGIN, 30), title, 20), Text((MARGIN, 50), machine, 11.5, colour=FAINT)]
    for number, (name, points) in enumerate(classes.items()):
        left = MARGIN + (number % COLUMNS) * (PANEL[0] + GAP)
        top = HEAD + (number // COLUMNS) * (panel_height + GAP)
        rays = next(row.error.judged for row in result.rows if row.class_ == name)
        parts += panel(name, points, techniques, rays, (left, top), band)
    below = HEAD + rows * (panel_height + GAP) + 8
    parts += legend(techniques, classes, (MARGIN, below), width)
    return Drawing(width, below + LEGEND, title, parts)


def panel(
    name: str, points: Sequence[Point], techniques: Sequence[str], rays: int, corner: Place, band: float
) -> list[Part]:
    left, top = corner[0] + LEFT, corner[1] + TOP
    right, floor = left + PLOT[0], top + PLOT[1]
    across = LogAxis(*around([point.mrays for point in points]), left, right)
    up = LogAxis(10 ** math.floor(math.log10(0.8e6 / rays)), LARGEST, floor, top)
    parts: list[Part] = [Text((left, corner[1] + 20), TITLES[name], 14)]
    parts.append(Text((right, corner[1] + 20), f"{rays:,} rays judged", 11, "end", FAINT))
    parts.append(Area([(left, floor), (right, floor), (right, floor + band), (left, floor + band)], BAND))
    for mark in up.decades():
        parts.append(Line([(left, up.at(mark)), (right, up.at(mark))], RULE))
        parts.append(Text((left - 6, up.at(mark) + 4), number_text(mark), 11, "end", FAINT))
    for mark in across.decades():
        x = across.at(mark)
        parts.append(Line([(x, top), (x, floor + band)], RULE))
        parts.append(Text((x, floor + band + 15), number_text(mark), 11, "middle", FAINT))
    parts.append(Text((left - 6, top - 8), "ppm", 11, "end", FAINT))
    parts.append(Text((right, floor + band + 29), "Mrays/s", 11, "end", FAINT))
    parts.append(Line([(left, floor), (right, floor)], FAINT))
    places = {id(one): (across.at(one.mrays), height_of(one, up, techniques, floor)) for one in points}
    front = pareto(points)
    parts.append(Line([places[id(one)] for one in front], FRONT, 1.6, dashed=True))
    bound = max((point.bound for point in points if point.ppm == 0), default=None)
    if bound is not None:
        parts.append(
            Text((left + 5, floor + 14), f"none wrong: below {rounded(bound)} ppm (95 %)", 11, colour=FAINT, halo=True)
        )
    for point in sorted(points, key=lambda one: (one.strict, -radius(one))):  # small and strict ones on top
        parts += marker(point, places[id(point)])
    return parts + labels(front, places, left, right)


def height_of(point: Point, up: LogAxis, techniques: Sequence[str], floor: float) -> float:
    """Those without a wrong ray lie below the axis, each technique in a lane of its own."""
    if point.ppm > 0:
        return up.at(max(up.low, min(point.ppm, LARGEST)))
    return floor + 28 + LANE * techniques.index(point.technique)


def radius(point: Point) -> float:
    return radius_of(point.bytes_per_triangle)


def radius_of(size: float) -> float:
    """Grows with the bytes a triangle: a step for each doubling from 16."""
    return min(10.0, 4.5 + math.log2(max(size, 16) / 16))


def colours(structure: str) -> tuple[str, str]:
    return COLOURS.get(structure, OTHER_COLOUR)


def marker(point: Point, at: Place) -> list[Part]:
    """Filled: the padded box test; tinted: Ize's; hollow: the plain one. The letter is the intersector's."""
    colour, tint = colours(point.structure)
    fill = {SLABS[0]: colour, SLABS[1]: tint}.get(point.slab, "#ffffff")
    size = radius(point)
    told = f"{point.technique}, {point.said}: {rounded(point.mrays)} Mrays/s, {point.error_text} ppm wrong"
    told += f", {rounded(point.bytes_per_triangle)} bytes a triangle"
    corners = shape(SHAPES.get(point.technique, OTHER_SHAPE), at, size)
    parts: list[Part] = [Area(corners, fill, INK if point.strict else colour, 2.4 if point.strict else 1.2, told)]
    if point.letter:
        ink = "#ffffff" if fill == colour else INK
        parts.append(Text((at[0], at[1] + 0.36 * size * 1.2), point.letter, 1.2 * size, "middle", ink))
    if point.ppm == 0:
        parts += arrow(at, size, colour)
    return parts


def arrow(at: Place, size: float, colour: str) -> list[Part]:
    """Down: the rate is somewhere below the bound."""
    x, y = at[0], at[1] + size
    return [
        Line([(x, y), (x, y + 3.5)], colour, 1.2),
        Area([(x - 2.6, y + 2.5), (x + 2.6, y + 2.5), (x, y + 6.5)], colour),
    ]


def labels(front: Sequence[Point], places: dict[int, Place], left: float, right: float) -> list[Part]:
    """Knobs of the points on the front that are not all strict, each where no other label stands."""
    parts: list[Part] = []
    taken: list[tuple[float, float, float]] = []
    for point in front:
        if point.ppm == 0:
            continue
        text = point.said
        x, y = places[id(point)]
        wide = 5.6 * len(text)
        at_right = x + radius(point) + 5 + wide < right
        start = x + radius(point) + 5 if at_right else max(left, x - radius(point) - 5 - wide)
        while any(abs(y - other) < 12 and start < end and begin < start + wide for begin, end, other in taken):
            y -= 12
        taken.append((start, start + wide, y))
        parts.append(Text((start, y + 4), text, 10, colour=INK, halo=True))
    return parts


Icon = Callable[[float, float], list[Part]]


def legend(techniques: Sequence[str], classes: dict[str, list[Point]], corner: Place, width: float) -> list[Part]:
    """Shapes and colours of techniques; letters of triangle tests; fills, rims, lines and sizes."""
    letters = {one.letter: one.intersector for points in classes.values() for one in points if one.letter}
    tests = ", ".join(f"{letter} {name}" for letter, name in letters.items())
    colour, tint = colours("bvh")
    meanings: list[tuple[Icon, str]] = [
        (figure("circle", 6.5, colour, colour), "padded boxes"),
        (figure("circle", 6.5, tint, colour), "Ize's boxes"),
        (figure("circle", 6.5, "#ffffff", colour), "plain boxes"),
        (figure("circle", 6.5, tint, INK, 2.4), "strict"),
        (lambda x, y: [Line([(x - 9, y), (x + 7, y)], FRONT, 1.6, dashed=True)], "nothing is faster and less wrong"),
        (lambda x, y: arrow((x, y - 3), 0, INK), "none wrong"),
    ]
    for size in (32, 128, 512):
        meanings.append((figure("circle", radius_of(size), "#ffffff", FAINT), f"{size} bytes a triangle"))
    rows = [[(figure(SHAPES.get(one, OTHER_SHAPE), 6.5, *2 * [colours(family(one))[0]]), one) for one in techniques]]
    rows += [[(lambda x, y: [], f"triangle test: {tests}")]] if tests else []
    parts: list[Part] = []
    y = corner[1]
    for row in [*rows, meanings]:
        x = corner[0]
        for icon, text in row:
            wide = 30 + 6.4 * len(text)
            if x > corner[0] and x + wide > width - MARGIN:
                x, y = corner[0], y + LEGEND_LINE
            parts += [*icon(x + 8, y), Text((x + 20, y + 4), text, 12)]
            x += wide
        y += LEGEND_LINE
    return parts


def figure(kind: str, size: float, fill: str, rim: str, width: float = 1.2) -> Icon:
    return lambda x, y: [Area(shape(kind, (x, y), size), fill, rim, width)]


def family(technique: str) -> str:
    return technique.split("/")[0]
