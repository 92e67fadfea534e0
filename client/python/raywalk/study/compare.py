"""Two times compared: their ratio, how sure it is, and many such ratios together."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

NOISE = 1.035  # repeats of the same frame may spread by so much before a time is called unstable
LEAST_FRAMES = 4  # fewer give no interval worth the name
RESAMPLES, SEED = 2000, 1
Z95 = 1.96
Side = Literal["faster", "slower", "even"]


@dataclass(frozen=True)
class Times:
    """The mean time in ms of a walkthrough's frames, and each frame's where they are known."""

    mean: float
    frames: tuple[float, ...] = ()


@dataclass(frozen=True)
class Ratio:
    """One time over another; `low` and `high` are the 95 % interval, equal to the ratio where there is none."""

    value: float
    low: float
    high: float

    @property
    def side(self) -> Side:
        """`faster`: the divisor is, beyond noise and interval."""
        if self.value > NOISE and self.low > 1:
            return "faster"
        if self.value < 1 / NOISE and self.high < 1:
            return "slower"
        return "even"

    @property
    def interval(self) -> str:
        """The ratio alone where there is no interval."""
        return f"{self.value:.2f}x" if self.low == self.high else f"{self.low:.2f} to {self.high:.2f}"

    def __str__(self) -> str:
        return f"{self.value:.2f}x" + ("" if self.low == self.high else f" ({self.interval})")


def ratio(slow: Times, fast: Times) -> Ratio:
    """The time of `slow` over that of `fast`, with the bootstrap interval over their common frames."""
    value = slow.mean / fast.mean
    if len(slow.frames) != len(fast.frames) or len(slow.frames) < LEAST_FRAMES:
        return Ratio(value, value, value)
    pairs = np.array([slow.frames, fast.frames])
    chosen = np.random.default_rng(SEED).integers(0, pairs.shape[1], (RESAMPLES, pairs.shape[1]))
    sums = pairs[:, chosen].sum(axis=2)
    low, high = np.percentile(sums[0] / sums[1], [2.5, 97.5])
    return Ratio(value, float(low), float(high))


def overall(ratios: Sequence[Ratio]) -> Ratio:
    """The geometric mean; its interval is that of the measurement, not of the choice of scenes."""
    logs = [math.log(one.value) for one in ratios]
    spreads = [(math.log(one.high) - math.log(one.low)) / (2 * Z95) for one in ratios]
    mean = sum(logs) / len(logs)
    half = Z95 * math.sqrt(sum(spread * spread for spread in spreads)) / len(logs)
    return Ratio(math.exp(mean), math.exp(mean - half), math.exp(mean + half))
