"""Runs what is left of a study, scene after scene, and keeps every finished step."""

import time
from contextlib import suppress

from raywalk.client import Client
from raywalk.errors import RaywalkError, UnreachableError
from raywalk.models import Scene, System
from raywalk.progress import bar, job_bar, messages, stage_bar
from raywalk.study.measure import Measurer
from raywalk.study.parameters import Parameters
from raywalk.study.plan import Step, plan
from raywalk.study.store import Store


def identity_of(parameters: Parameters, system: System, scenes: list[Scene]) -> dict:
    """What must be the same for a study to go on; throws RaywalkError for a scene that the daemon does not have."""
    known = {scene.name: scene for scene in scenes}
    if missing := [name for name in parameters.scenes if name not in known]:
        raise RaywalkError(f"there is no scene {missing[0]!r}; known: {', '.join(sorted(known))}")
    machine = system.machine
    device = {"name": machine.device, "kind": system.device.kind, "threads": machine.threads}
    device |= {"commit": machine.git_commit, "fingerprint": machine.fingerprint}
    data = {name: f"{known[name].fidelity} ({known[name].source or 'no source'})" for name in parameters.scenes}
    return {"parameters": parameters.model_dump(mode="json"), "device": device, "scene": data}


class Run:
    """`failures` tells by scene why its steps are missing; a lost daemon ends the run instead."""

    def __init__(self, client: Client, store: Store, parameters: Parameters, gpu: bool):
        self._client, self._parameters = client, parameters
        self._store, self._measurer = store, Measurer(client, store, parameters)
        self._steps = plan(parameters, gpu)
        self._console = messages()
        self.failures: dict[str, str] = {}

    def run(self) -> None:
        """Throws UnreachableError when the daemon is gone."""
        done = sum(self._store.finished(step) for step in self._steps)
        if done:
            self._console.print(f"{done} of {len(self._steps)} steps were finished before")
        for name in self._parameters.scenes:
            steps = [step for step in self._steps if step.scene == name and not self._store.finished(step)]
            if steps:
                self._run_scene(name, steps)

    def _run_scene(self, name: str, steps: list[Step]) -> None:
        """Loads, runs, and evicts the scene again unless somebody else had it loaded."""
        ours = not self._client.get_scene(name).loaded
        try:
            with bar(f"loading {name}", console=self._console):
                scene = self._client.load_scene(name)
            self._console.print(f"{scene.title}: {scene.triangles:,} triangles, {scene.fidelity}")
            for step in steps:
                self._run_step(step, scene)
        except UnreachableError:
            raise
        except RaywalkError as error:
            self.failures[name] = str(error)
            self._console.print(f"{name} is left out: {error}", markup=False)
        finally:
            if ours:
                with suppress(RaywalkError):  # the first cause is the one to tell
                    self._client.delete_scene(name)

    def _run_step(self, step: Step, scene: Scene) -> None:
        start = time.monotonic()
        place = f"{self._steps.index(step) + 1}/{len(self._steps)} {step.label}"
        with self._watching(step, place) as watch:
            record = self._measurer.run(step, scene, watch)
        seconds = time.monotonic() - start
        self._store.save(step, {"step": step.key, "seconds": round(seconds, 2)} | record)
        self._console.print(f"{place}, {seconds:.1f} s", markup=False)

    def _watching(self, step: Step, place: str):
        if step.kind == "accuracy":
            return stage_bar(place, self._console)
        width, height = (step.width, step.height) if step.width else (self._parameters.width, self._parameters.height)
        return job_bar(place, width * height, self._console)
