"""A study as it stands: everything that its folder holds so far."""

from dataclasses import dataclass, field
from pathlib import Path

from raywalk.errors import RaywalkError
from raywalk.models import AccuracyResult, BenchmarkResult, Machine, Scene
from raywalk.study.parameters import Parameters
from raywalk.study.plan import Step, plan
from raywalk.study.store import Store
from raywalk.tables.machine import describe


@dataclass(frozen=True)
class Picture:
    """One rendered image of a scene."""

    scene: str
    path: Path
    width: int
    height: int
    mode: str
    technique: str
    frame: int
    of: int


@dataclass
class Study:
    """Results by scene, in the order of the parameters; a missing one is not measured yet, or failed."""

    parameters: Parameters
    results: dict[str, BenchmarkResult] = field(default_factory=dict)
    resolutions: dict[str, list[BenchmarkResult]] = field(default_factory=dict)
    kernels: list[BenchmarkResult] = field(default_factory=list)
    accuracy: dict[str, AccuracyResult] = field(default_factory=dict)
    pictures: dict[str, Picture] = field(default_factory=dict)
    failures: dict[str, str] = field(default_factory=dict)
    steps: int = 0
    finished: int = 0
    seconds: float = 0.0

    @property
    def all_results(self) -> list[BenchmarkResult]:
        return list(self.results.values())

    @property
    def machine(self) -> Machine | None:
        """Every result is of the same."""
        every = [*self.all_results, *self.kernels, *(one for row in self.resolutions.values() for one in row)]
        return every[0].machine if every else None

    @property
    def line(self) -> str:
        """Device, dates and the command that measures this again."""
        days = sorted({result.created_at[:10] for result in self.all_results})
        date = "" if not days else days[0] if days[0] == days[-1] else f"{days[0]} to {days[-1]}"
        parts = [describe(self.machine) if self.machine else "", date, f"`{self.parameters.command}`"]
        return ", ".join(part for part in parts if part)

    @property
    def complete(self) -> bool:
        return self.finished == self.steps

    def scene(self, name: str) -> Scene | None:
        return self.results[name].scene if name in self.results else None


def collect(store: Store, parameters: Parameters, gpu: bool, failures: dict[str, str] | None = None) -> Study:
    """Throws RaywalkError for a damaged file."""
    steps = plan(parameters, gpu)
    study = Study(parameters, failures=dict(failures or {}), steps=len(steps))
    for step in steps:
        if store.finished(step):
            study.finished += 1
            add(study, store, step)
    return study


def add(study: Study, store: Store, step: Step) -> None:
    record = store.load(step)
    try:
        study.seconds += float(record["seconds"])
        if step.kind == "image":
            view = {name: record[name] for name in ("width", "height", "mode", "technique", "frame", "of")}
            study.pictures[step.scene] = Picture(step.scene, store.image(step.scene), **view)
            return
        if step.kind == "accuracy":
            study.accuracy[step.scene] = AccuracyResult.model_validate(record["results"][0])
            return
        found = [BenchmarkResult.model_validate(result) for result in record["results"]]
        if step.kind == "measure":
            study.results[step.scene] = found[0]
        elif step.kind == "resolution":
            study.resolutions.setdefault(step.scene, []).extend(found)
        else:
            study.kernels += found
    except (LookupError, TypeError, ValueError) as error:
        raise RaywalkError(f"the file of step {step.key} is damaged: remove it, or start over with --fresh") from error
