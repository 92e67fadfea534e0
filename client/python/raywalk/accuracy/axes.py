"""Logarithmic axes: where values lie, and which are marked."""

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class LogAxis:
    """From `low` at place `start` to `high` at place `end`; all positive."""

    low: float
    high: float
    start: float
    end: float

    def at(self, value: float) -> float:
        share = math.log(value / self.low) / math.log(self.high / self.low)
        return self.start + (self.end - self.start) * share

    def decades(self) -> list[float]:
        """Powers of ten on the axis, and where fewer than three are on it 2 and 5 times them too."""
        first, last = math.floor(math.log10(self.low)), math.ceil(math.log10(self.high))
        few = math.log10(self.high / self.low) < 2.5
        marks = [factor * 10.0**power for power in range(first, last + 1) for factor in ((1, 2, 5) if few else (1,))]
        return [mark for mark in marks if self.low * 0.999 <= mark <= self.high * 1.001]


def around(values: list[float], room: float = 1.15) -> tuple[float, float]:
    """Ends of an axis that holds all values, at least a factor of four wide."""
    low, high = min(values) / room, max(values) * room
    if high / low < 4:
        middle = math.sqrt(low * high)
        low, high = middle / 2, middle * 2
    return low, high


def number_text(value: float) -> str:
    """As an axis shows it."""
    if value >= 1e6:
        return f"{value / 1e6:g}M"
    if value >= 1e4:
        return f"{value / 1e3:g}k"
    return f"{value:g}"
