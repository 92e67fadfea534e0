"""What the tests of the study share: results made of times, the paper's Table 2, a folder with a study in it."""

from pathlib import Path

from PIL import Image
from raywalk.models import BenchmarkResult, PaperFigures
from raywalk.study.measure import record_of
from raywalk.study.names import BVH, GRID, KDT2, KDT3
from raywalk.study.parameters import Parameters
from raywalk.study.plan import plan
from raywalk.study.store import Store

TECHNIQUES = (GRID, KDT3, KDT2, BVH)
# Table 2 of the paper as printed: grid, kdt-3, kdt-2, BVH in ms.
PRINTED = {
    "primary": {
        "bunny": (16.0, 41.6, 31.5, 13.8),
        "dragon": (40.2, 55.9, 42.3, 39.0),
        "buddha": (34.6, 45.6, 34.2, 36.8),
        "robots": (27.3, 20.5, 16.2, 25.9),
        "museum": (25.0, 46.2, 35.7, 20.0),
        "kitchen": (41.6, 40.5, 31.9, 29.3),
        "theatre": (43.1, 42.3, 33.1, 34.3),
        "office": (52.9, 44.1, 34.2, 22.7),
        "conference": (83.2, 83.7, 66.2, 28.9),
    },
    "shadow": {
        "bunny": (27.4, 61.7, 52.1, 27.0),
        "dragon": (73.3, 86.0, 73.4, 80.0),
        "buddha": (69.1, 73.5, 62.9, 81.8),
        "robots": (53.8, 35.6, 30.1, 50.0),
        "museum": (68.3, 86.2, 73.4, 53.2),
        "kitchen": (209.6, 130.0, 110.8, 138.8),
        "theatre": (119.7, 87.3, 74.3, 93.6),
        "office": (218.6, 116.1, 101.5, 87.9),
        "conference": (228.2, 153.0, 132.7, 85.2),
    },
    "whitted": {
        "robots": (89.0, 43.8, 38.7, 64.3),
        "museum": (168.5, 184.1, 162.4, 163.7),
        "kitchen": (442.8, 244.4, 214.3, 403.9),
        "theatre": (379.7, 201.6, 177.5, 292.1),
        "office": (224.0, 120.1, 107.7, 94.2),
        "conference": (292.8, None, None, 114.1),
    },
}
Times = dict[str, tuple[float | None, ...]]  # by mode: grid, kdt-3, kdt-2, BVH; None: not measured


def paper_times(scene: str) -> Times:
    return {mode: rows[scene] for mode, rows in PRINTED.items() if scene in rows}


def made(model: BenchmarkResult, scene: str, times: Times, spread: float = 0.001) -> BenchmarkResult:
    """A result with these mean times; `spread` is how far its frames vary, each technique for itself. Mode whitted has
    secondary rays."""
    rows = []
    for mode, row in times.items():
        for number, (technique, mean) in enumerate(zip(TECHNIQUES, row, strict=True)):
            if mean is None:
                continue
            structure, traversal = technique.split("/")
            wave = [1, -1, 1, -1, -1, 1] if number % 2 else [1, 1, -1, 1, -1, -1]
            frames = [mean * (1 + spread * one) for one in wave]
            copy = model.rows[0].model_copy(deep=True)
            copy.structure, copy.traversal, copy.mode = structure, traversal, mode
            copy.structure_id = f"{scene}-{structure}"
            copy.frame_ms.mean = copy.frame_ms.median = mean
            copy.frame_times_ms, copy.steps_per_ray = frames, 10.0
            copy.rays_per_frame = {"primary": 100.0, "shadow": 200.0, "whitted": 300.0}[mode]
            rows.append(copy)
    shown = model.scene.model_copy(update={"name": scene, "title": scene.title(), "paper": figures_of(scene)})
    spec = model.spec.model_copy(update={"scene": scene, "modes": list(times)})
    return model.model_copy(update={"scene": shown, "rows": rows, "spec": spec, "stop_reason": "completed"}, deep=True)


def figures_of(scene: str) -> PaperFigures | None:
    if scene not in PRINTED["primary"]:
        return None
    modes = {
        f"{mode}_ms": dict(zip(("grid", "kdt-3", "kdt-2", "bvh"), rows.get(scene, (None,) * 4), strict=True))
        for mode, rows in PRINTED.items()
    }
    return PaperFigures.model_validate({"table2": modes})


def parameters(*scenes: str) -> Parameters:
    return Parameters(
        scenes=scenes,
        modes=("primary", "shadow", "whitted"),
        frames=6,
        width=64,
        height=48,
        image_width=96,
        image_height=72,
        time_limit_s=None,
    )


def stored(folder: Path, model: BenchmarkResult, *scenes: str) -> tuple[Store, Parameters]:
    """A finished study of these scenes with the paper's times."""
    asked, store = parameters(*scenes), Store(folder)
    store.open({"parameters": asked.model_dump(mode="json")})
    for step in plan(asked, gpu=False):
        times = paper_times(step.scene) or {"primary": (4.0, 3.0, 2.0, 1.0)}
        if step.kind == "image":
            Image.new("RGB", (96, 72), (90, 120, 200)).save(store.image(step.scene))
            view = {"frame": 40, "of": 400, "mode": "whitted", "technique": "bvh/while-while"}
            store.save(step, {"seconds": 1.0, "width": 96, "height": 72} | view)
            continue
        result = made(model, step.scene, times)
        if step.kind == "resolution":
            size = {"width": step.width, "height": step.height, "modes": ["shadow"]}
            result = result.model_copy(update={"spec": result.spec.model_copy(update=size)})
        store.save(step, {"seconds": 2.0} | record_of([result]))
    return store, asked
