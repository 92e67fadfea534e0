"""One step of a study: the request for it, and what is kept of the answer."""

from collections.abc import Callable, Sequence
from itertools import permutations
from typing import Any

from raywalk import sweep
from raywalk.client import Client
from raywalk.follow import accuracy, benchmark, built
from raywalk.models import (
    AccuracySpec,
    BenchmarkResult,
    BenchmarkSpec,
    Bounds,
    FrameRequest,
    Job,
    PathFrame,
    Scene,
    Technique,
)
from raywalk.study.parameters import DEPTH, MODES, PATH_FRAMES, Parameters
from raywalk.study.plan import Step
from raywalk.study.store import Store, write_atomic
from raywalk.tables.paper import Paper
from raywalk.techniques import measured

CUBIC = 1.1  # a paper's grid cell may be so much longer than wide before the scene counts as another one
IMAGE_TECHNIQUE = "bvh/while-while"
IMAGE_FRAMES = {"robots": 160, "museum": 200, "kitchen": 0}  # of PATH_FRAMES: views that show the scene
OTHER_IMAGE_FRAME = 40
IMAGE_MODE = "whitted"
RESOLUTION_FRAMES = 3
KERNEL_FRAMES = 20  # of Table 3, as `raywalk bench` takes
ERROR_FRAMES = 2  # compared with the reference, of every technique and mode
PNG = "image/png"
Watch = Callable[[Job], None]


class Measurer:
    """Runs steps against a daemon; `scene` in every call is the loaded one."""

    def __init__(self, client: Client, store: Store, parameters: Parameters):
        self._client, self._store, self._parameters = client, store, parameters

    def run(self, step: Step, scene: Scene, watch: Watch) -> dict[str, Any]:
        """The record of the step, as the store keeps it."""
        if step.kind == "image":
            return self._image(step)
        if step.kind == "accuracy":
            found = accuracy(self._client, self._accuracy_spec(scene), watch)
            return {"results": [found.model_dump(mode="json", by_alias=True)]}
        if step.kind == "kernels":
            return record_of([benchmark(self._client, spec, watch) for spec in self._kernel_specs(scene)])
        spec = self._spec(scene) if step.kind == "measure" else self._resolution_spec(step, scene)
        return record_of([benchmark(self._client, spec, watch)])

    def _spec(self, scene: Scene, **changes: Any) -> BenchmarkSpec:
        own = self._parameters
        values = {"scene": scene.name, "techniques": self._techniques(scene), "modes": modes_of(scene, own.modes)}
        values |= {"width": own.width, "height": own.height, "frames": own.frames, "depth": DEPTH, "warmup": 1}
        values |= {"error_frames": ERROR_FRAMES}
        values |= {"time_limit_s": own.time_limit_s} if own.time_limit_s else {}
        return BenchmarkSpec.model_validate(values | changes)

    def _techniques(self, scene: Scene) -> list[Technique]:
        """All of the device, the grid in the paper's resolution."""
        options = grid_options(scene)
        return [
            one.model_copy(update={"options": options}) if one.structure == "grid" and options else one
            for one in measured(self._client.get_kinds())
        ]

    def _resolution_spec(self, step: Step, scene: Scene) -> BenchmarkSpec:
        """The richest of the scene's rays, by our own techniques."""
        own = [one for one in self._techniques(scene) if one.structure != "embree"]
        frames = min(RESOLUTION_FRAMES, self._parameters.frames)
        size = {"width": step.width, "height": step.height}
        chosen = {"modes": modes_of(scene, self._parameters.modes)[-1:], "techniques": own, "frames": frames}
        return self._spec(scene, batch=0, error_frames=1, **size, **chosen)

    def _kernel_specs(self, scene: Scene) -> list[BenchmarkSpec]:
        spec = self._spec(
            scene,
            techniques=None,
            modes=modes_of(scene, self._parameters.modes)[-1:],
            frames=min(KERNEL_FRAMES, self._parameters.frames),
            batch=sweep.BATCH,
            error_frames=sweep.ERROR_FRAMES,
        )
        return sweep.sweep_specs(self._client, spec, sweep.CAPS, {})

    def _accuracy_spec(self, scene: Scene) -> AccuracySpec:
        limit = self._parameters.time_limit_s
        values = {"scene": scene.name, "hard_cases": False, "quick": True}
        return AccuracySpec.model_validate(values | ({"time_limit_s": limit} if limit else {}))

    def _image(self, step: Step) -> dict[str, Any]:
        own = self._parameters
        structure, traversal = IMAGE_TECHNIQUE.split("/")
        shown = IMAGE_FRAMES.get(step.scene, OTHER_IMAGE_FRAME)
        built(self._client, step.scene, structure)
        request = FrameRequest(
            scene=step.scene,
            structure=structure,
            traversal=traversal,
            width=own.image_width,
            height=own.image_height,
            mode=IMAGE_MODE,
            depth=DEPTH,
            camera=PathFrame(frame=shown, of=PATH_FRAMES),
        )
        frame = self._client.render_frame(request, PNG)
        write_atomic(self._store.image(step.scene), frame.content)
        view = {"frame": shown, "of": PATH_FRAMES, "mode": IMAGE_MODE, "technique": IMAGE_TECHNIQUE}
        return view | {"width": frame.width, "height": frame.height, "trace_ms": frame.timing_ms.get("trace")}


def record_of(results: list[BenchmarkResult]) -> dict[str, Any]:
    return {"results": [result.model_dump(mode="json") for result in results]}


def modes_of(scene: Scene, asked: tuple[str, ...]) -> list[str]:
    """What was asked for, but no secondary rays where the paper calls them meaningless (single objects), unless
    nothing else was asked for."""
    paper = Paper(scene.paper)
    if paper.has_times and paper.frame_ms("whitted", "grid/dda") is None and len(asked) > 1:
        return [mode for mode in MODES if mode in asked and mode != "whitted"]
    return [mode for mode in MODES if mode in asked]


def grid_options(scene: Scene) -> dict[str, float | str] | None:
    """The paper's cells, where they are cubes in this scene's box as in the paper's, if need be with other axes up;
    else None, the builder's own choice."""
    cells = Paper(scene.paper).structure("grid", "size")
    if not cells or scene.bounds is None:
        return None
    for turned in permutations(cells):  # as they are comes first
        if are_cubes(scene.bounds, turned):
            return {f"resolution_{axis}": float(count) for axis, count in zip("xyz", turned, strict=True)}
    return None


def are_cubes(bounds: Bounds, cells: Sequence[int]) -> bool:
    sides = [(high - low) / count for low, high, count in zip(bounds.lo, bounds.hi, cells, strict=True)]
    return min(sides) > 0 and max(sides) / min(sides) <= CUBIC
