"""What a study measures, and the defaults for a CPU and for a GPU."""

from dataclasses import dataclass
from typing import Literal

from pydantic import BaseModel, ConfigDict

from raywalk.errors import RaywalkError

# In the paper's order; each figure shows three of them.
SCENES = ("bunny", "dragon", "buddha", "robots", "museum", "kitchen", "theatre", "office", "conference")
IMAGE_FIGURES = {
    3: ("bunny", "buddha", "dragon"),
    4: ("robots", "museum", "kitchen"),
    5: ("theatre", "office", "conference"),
}
RESOLUTION_FIGURES = {1: "dragon", 2: "robots"}
KERNEL_SCENES = ("robots", "kitchen", "museum")  # of Table 3
UNIFORM_SCENES = ("bunny", "dragon", "buddha")  # uniformly populated, as the paper says
MODES = ("primary", "shadow", "whitted")
PATH_FRAMES = 400
DEPTH = 2
RESOLUTION_STEPS = (0.5, 0.75, 1.0, 1.5, 2.0)  # of the size of the frames
LARGEST_SIDE = 8192  # pixels

Mode = Literal["primary", "shadow", "whitted"]


@dataclass(frozen=True)
class Defaults:
    """`time_limit_s` is for each scene's measuring, so that the whole ends in time; None: as long as it takes."""

    frames: int
    side: int
    image_side: int
    time_limit_s: float | None


# On two cores all nine scenes end within ten minutes; a GPU measures what the paper measured.
ON_CPU = Defaults(frames=6, side=256, image_side=768, time_limit_s=25.0)
ON_GPU = Defaults(frames=PATH_FRAMES, side=1024, image_side=1024, time_limit_s=None)


class Parameters(BaseModel):
    """Everything that decides what is measured; a study goes on only with the same."""

    model_config = ConfigDict(frozen=True)

    scenes: tuple[str, ...]
    modes: tuple[Mode, ...]
    frames: int
    width: int
    height: int
    image_width: int
    image_height: int
    time_limit_s: float | None
    accuracy: bool = False  # the sweep of speed against error on every scene

    @property
    def size(self) -> str:
        return f"{self.width}x{self.height}"

    @property
    def command(self) -> str:
        """What measures this again."""
        words = ["raywalk study"]
        words += [f"--scenes {','.join(self.scenes)}"] if self.scenes != SCENES else []
        words += [f"--frames {self.frames}"] if self.time_limit_s is None else []
        words += [f"--size {self.size}"]
        words += [f"--modes {','.join(self.modes)}"] if self.modes != MODES else []
        words += ["--accuracy"] if self.accuracy else []
        return " ".join(words)


def parameters_of(
    scenes: list[str] | None,
    modes: list[str] | None,
    frames: int | None,
    size: tuple[int, int] | None,
    gpu: bool,
    accuracy: bool | None = None,
) -> Parameters:
    """Fills what is not asked for with the device's defaults; throws RaywalkError for names that are wrong or given
    twice."""
    chosen = list(SCENES) if scenes is None else scenes
    rays = list(MODES) if modes is None else modes
    for what, names in (("scene", chosen), ("mode", rays)):
        if not names:
            raise RaywalkError(f"no {what} is named")
        if twice := sorted({name for name in names if names.count(name) > 1}):
            raise RaywalkError(f"{what} {twice[0]} is named twice")
    if unknown := [mode for mode in rays if mode not in MODES]:
        raise RaywalkError(f"there is no mode {unknown[0]!r} in the study; known: {', '.join(MODES)}")
    defaults = ON_GPU if gpu else ON_CPU
    width, height = size or (defaults.side, defaults.side)
    image = image_shape(width, height, defaults.image_side)
    return Parameters(
        scenes=tuple(chosen),
        modes=tuple(mode for mode in MODES if mode in rays),
        frames=frames or defaults.frames,
        width=width,
        height=height,
        image_width=image[0],
        image_height=image[1],
        time_limit_s=defaults.time_limit_s if frames is None else None,
        accuracy=gpu if accuracy is None else accuracy,
    )


def image_shape(width: int, height: int, side: int) -> tuple[int, int]:
    """Images have the frames' shape and three times their sides, up to `side`; never fewer pixels than a frame."""
    factor = max(1.0, min(3.0, side / max(width, height)))
    return round(width * factor), round(height * factor)
