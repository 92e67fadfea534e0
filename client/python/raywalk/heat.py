"""Colours for heat maps: dark blue through green and yellow to red, as the daemon's PNG of output `steps`."""

import numpy as np
from numpy.typing import NDArray

# The control points of server/image/viewable.cpp, so that sheets and rendered frames agree.
STOPS = 255 * np.array(
    [
        (0.05, 0.03, 0.20),
        (0.16, 0.22, 0.58),
        (0.10, 0.55, 0.60),
        (0.35, 0.78, 0.32),
        (0.96, 0.86, 0.22),
        (0.86, 0.16, 0.12),
    ]
)


def heat(values: NDArray, full: float) -> NDArray[np.uint8]:
    """Colours (h, w, 3) of values (h, w); 0 is dark blue, `full` and more are red."""
    place = np.clip(values / max(full, 1e-12), 0, 1) * (len(STOPS) - 1)
    low = np.minimum(place.astype(int), len(STOPS) - 2)
    share = (place - low)[..., None]
    return np.round(STOPS[low] * (1 - share) + STOPS[low + 1] * share).astype(np.uint8)
