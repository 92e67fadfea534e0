"""Colours for heat maps: dark blue through magenta and orange to pale yellow, even steps in lightness."""

import numpy as np
from numpy.typing import NDArray

STOPS = np.array(
    [(4, 6, 24), (46, 16, 92), (112, 24, 110), (178, 42, 90), (230, 92, 48), (250, 168, 40), (252, 246, 170)],
    np.float64,
)


def heat(values: NDArray, full: float) -> NDArray[np.uint8]:
    """Colours (h, w, 3) of values (h, w); 0 is the darkest, `full` and more the lightest."""
    place = np.clip(values / max(full, 1e-12), 0, 1) * (len(STOPS) - 1)
    low = np.minimum(place.astype(int), len(STOPS) - 2)
    share = (place - low)[..., None]
    return np.round(STOPS[low] * (1 - share) + STOPS[low + 1] * share).astype(np.uint8)
