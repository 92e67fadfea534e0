"""The charts of a study: bars for each scene and technique, time against resolution."""

import math
from collections.abc import Sequence

from raywalk.gate import is_open
from raywalk.models import BenchmarkResult
from raywalk.study import svg
from raywalk.study.collect import Study
from raywalk.study.names import BASES, NAMES, RAYS, row_of, techniques_in
from raywalk.study.times import closed_times_of, paper_times, percents

LEFT, TOP, BOTTOM = 52.0, 56.0, 54.0
BAR, GAP = 13.0, 26.0  # a bar's width; between scenes
PLOT = 230.0  # height
MOST_PERCENT = 400.0  # bars beyond it are cut and say so
LINES_WIDTH, LINES_HEIGHT = 640.0, 300.0


def ticks(most: float, count: int = 5) -> list[float]:
    """Round numbers from 0 to at least `most`."""
    rough = max(most, 1e-9) / count
    power = 10 ** math.floor(math.log10(rough))
    step = next(power * factor for factor in (1, 2, 2.5, 5, 10) if power * factor >= rough * 0.999)
    return [step * number for number in range(math.ceil(most / step - 1e-9) + 1)]


def legend(techniques: Sequence[str], y: float, extra: str = "") -> str:
    parts, x = [], LEFT
    for technique in techniques:
        parts.append(svg.element("rect", x=x, y=y - 10, width=12, height=12, rx=2, class_=svg.CLASSES[technique]))
        parts.append(svg.words(x + 17, y, NAMES[technique]))
        x += 30 + 7.2 * len(NAMES[technique])
    if extra:
        parts += [svg.line(x, y - 4, x + 13, y - 4, "mark"), svg.words(x + 18, y, extra)]
    return "".join(parts)


def bar_chart(study: Study, mode: str) -> str | None:
    """Percentages of the mode's 100 %, a group of bars a scene, the paper's as marks; None without any. Open rows
    have no bar."""
    results = [result for result in study.all_results if closed_times_of(result, mode)]
    if not results:
        return None
    techniques = techniques_in(results)
    group = BAR * len(techniques)
    width = max(LEFT + 620.0, LEFT + len(results) * (group + GAP) + GAP)
    gap = (width - LEFT - len(results) * group) / (len(results) + 1)
    shares = [percents(closed_times_of(result, mode), mode) for result in results]
    theirs = [percents(paper_times(result, mode), mode) for result in results]
    most = min(MOST_PERCENT, max((max(one.values()) for one in shares + theirs if one), default=100.0))
    scale = ticks(most)
    parts = [legend(techniques, 38, "the paper's" if any(theirs) else "")]
    parts.append(svg.words(LEFT, 16, f"{RAYS[mode].capitalize()}: {NAMES[BASES[mode]]} is 100 %", class_="heading"))
    for tick in scale:
        y = level(tick, scale[-1])
        parts.append(svg.line(LEFT, y, width, y, "base" if tick == 100 else "rule"))
        parts.append(svg.words(LEFT - 8, y + 4, f"{tick:.0f} %", "end", "small"))
    for number, result in enumerate(results):
        left = LEFT + gap + number * (group + gap)
        for place, technique in enumerate(techniques):
            x, times = left + place * BAR, closed_times_of(result, mode)
            if technique in shares[number]:
                parts.append(bar(x, shares[number][technique], scale[-1], technique, result, times[technique]))
            if technique in theirs[number]:
                y = level(min(theirs[number][technique], scale[-1]), scale[-1])
                parts.append(svg.line(x, y, x + BAR - 2, y, "mark"))
        middle = left + group / 2
        parts.append(svg.words(middle, TOP + PLOT + 18, result.scene.name, "middle"))
        parts.append(svg.words(middle, TOP + PLOT + 34, result.scene.fidelity, "middle", "small"))
    return svg.document(width, TOP + PLOT + BOTTOM, "".join(parts), f"Table 2 as bars, {RAYS[mode]}")


def level(value: float, most: float) -> float:
    return TOP + PLOT * (1 - value / most)


def bar(x: float, percent: float, most: float, technique: str, result: BenchmarkResult, ms: float) -> str:
    top = level(min(percent, most), most)
    told = svg.tip(f"{result.scene.name}, {NAMES[technique]}: {ms:.2f} ms, {percent:.0f} %")
    height = max(0.5, TOP + PLOT - top)
    drawn = svg.element("rect", told, x=x, y=top, width=BAR - 2, height=height, rx=1.5, class_=svg.CLASSES[technique])
    over = svg.words(x + BAR / 2 - 1, top - 3, f"{percent:.0f}", "middle", "small") if percent > most else ""
    return drawn + over


def resolution_points(results: Sequence[BenchmarkResult]) -> dict[str, list[tuple[int, int, float, float, float]]]:
    """By technique: width, height, median, least and most ms of a frame, by growing size; closed rows alone."""
    ordered = sorted(results, key=lambda result: (result.spec.width or 0) * (result.spec.height or 0))
    points: dict[str, list[tuple[int, int, float, float, float]]] = {}
    for result in ordered:
        for technique in techniques_in([result]):
            row = row_of(result, (result.spec.modes or ["primary"])[-1], technique)
            if row and not is_open(row):
                seen = row.frame_ms
                frames = row.frame_times_ms or [seen.median]
                size = (result.spec.width or 0, result.spec.height or 0)
                points.setdefault(technique, []).append((*size, seen.median, min(frames), max(frames)))
    return points


def line_chart(results: Sequence[BenchmarkResult], title: str, standalone: bool = False) -> str:
    """Time against resolution: one line a technique; pixels along x, evenly, and the spread of the frames as bars."""
    points = resolution_points(results)
    sizes = sorted({(width, height) for row in points.values() for width, height, *_ in row}, key=math.prod)
    most_pixels = math.prod(sizes[-1])
    scale = ticks(max(high for row in points.values() for *_, high in row))
    right = LINES_WIDTH - 24

    def x_of(width: int, height: int) -> float:
        return LEFT + (right - LEFT) * width * height / most_pixels

    def y_of(ms: float) -> float:
        return TOP + LINES_HEIGHT * (1 - ms / scale[-1])

    parts = [svg.words(LEFT, 16, title, class_="heading"), legend(list(points), 38)]
    for tick in scale:
        parts.append(svg.line(LEFT, y_of(tick), right, y_of(tick), "rule"))
        parts.append(svg.words(LEFT - 8, y_of(tick) + 4, f"{tick:g}", "end", "small"))
    parts.append(svg.words(LEFT - 8, TOP - 8, "ms", "end", "small"))
    for number, (width, height) in enumerate(sizes):
        x, low = x_of(width, height), 18 + 14 * (number % 2)  # neighbours in two lines
        parts.append(svg.words(x, TOP + LINES_HEIGHT + low, f"{width}x{height}", "middle", "small"))
        parts.append(svg.line(x, TOP + LINES_HEIGHT, x, TOP + LINES_HEIGHT + 4, "rule"))
    for technique, row in points.items():
        class_ = svg.CLASSES[technique]
        path = " ".join(f"{x_of(width, height):.1f},{y_of(median):.1f}" for width, height, median, *_ in row)
        parts.append(svg.element("polyline", points=path, class_=f"line {class_}"))
        for width, height, median, low, high in row:
            x = x_of(width, height)
            parts.append(svg.line(x, y_of(low), x, y_of(high), f"whisker {class_}"))
            told = svg.tip(f"{NAMES[technique]}, {width}x{height}: {median:.2f} ms ({low:.2f} to {high:.2f})")
            parts.append(svg.element("circle", told, cx=x, cy=y_of(median), r=4, class_=class_))
    return svg.document(LINES_WIDTH, TOP + LINES_HEIGHT + BOTTOM, "".join(parts), title, standalone)
