"""The steps of a study in order: all of a scene's follow each other, so that it can be evicted after its last."""

from dataclasses import dataclass
from typing import Literal

from raywalk.study.parameters import (
    KERNEL_SCENES,
    LARGEST_SIDE,
    RESOLUTION_FIGURES,
    RESOLUTION_STEPS,
    Parameters,
)

Kind = Literal["measure", "image", "resolution", "kernels", "accuracy"]
WORDS = {
    "measure": "measuring",
    "image": "image",
    "resolution": "resolution",
    "kernels": "register caps",
    "accuracy": "accuracy",
}


@dataclass(frozen=True)
class Step:
    """`width` and `height` are of a resolution step, 0 for the others."""

    kind: Kind
    scene: str
    width: int = 0
    height: int = 0

    @property
    def key(self) -> str:
        """Its name in the store."""
        size = f"-{self.width}x{self.height}" if self.width else ""
        return f"{self.scene}-{self.kind}{size}"

    @property
    def label(self) -> str:
        return f"{self.scene}: {WORDS[self.kind]}" + (f" {self.width}x{self.height}" if self.width else "")


def plan(parameters: Parameters, gpu: bool) -> list[Step]:
    steps = []
    for scene in parameters.scenes:
        steps += [Step("measure", scene), Step("image", scene)]
        if scene in RESOLUTION_FIGURES.values():
            steps += [Step("resolution", scene, *size) for size in resolutions(parameters)]
        if gpu and scene in KERNEL_SCENES:
            steps.append(Step("kernels", scene))
        if parameters.accuracy:
            steps.append(Step("accuracy", scene))
    return steps


def resolutions(parameters: Parameters) -> list[tuple[int, int]]:
    """The sizes of Figures 1 and 2, around the size of the frames; each once."""
    longest = LARGEST_SIDE / max(parameters.width, parameters.height)
    factors = [min(factor, longest) for factor in RESOLUTION_STEPS]
    sizes = [
        (max(1, round(parameters.width * factor)), max(1, round(parameters.height * factor))) for factor in factors
    ]
    return list(dict.fromkeys(sizes))
