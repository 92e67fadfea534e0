"""What a study has finished, kept in its folder: one file a step, written at once or not at all."""

import fcntl
import json
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from raywalk.errors import RaywalkError
from raywalk.study.plan import Step

FORM = 1  # of the files
IDENTITY, STEPS, IMAGES, LOCK = "study.json", "steps", "images", ".lock"


class Store:
    """`identity` is the study's parameters, device and scenes: steps of another never mix with these."""

    def __init__(self, folder: Path):
        self.folder = folder

    def open(self, identity: dict[str, Any], fresh: bool = False) -> None:
        """Goes on with what is there. Throws RaywalkError, and changes nothing, when that is another study."""
        identity = json.loads(json.dumps({"form": FORM} | identity))
        kept = self._identity()
        if kept is not None and not fresh and (differences := differing(kept, identity)):
            raise RaywalkError(
                f"{self.folder} holds another study: {'; '.join(differences)}. Nothing was changed: name another folder"
                " with --out, or start over with --fresh"
            )
        if fresh:
            self._clear()
        for name in (STEPS, IMAGES):
            (self.folder / name).mkdir(exist_ok=True)
        if kept is None or fresh:
            write_atomic(self.folder / IDENTITY, json.dumps(identity, indent=1).encode() + b"\n")

    def finished(self, step: Step) -> bool:
        return self._path(step).is_file()

    def save(self, step: Step, record: dict[str, Any]) -> None:
        write_atomic(self._path(step), json.dumps(record, indent=1).encode() + b"\n")

    def load(self, step: Step) -> dict[str, Any]:
        """Throws RaywalkError when the file was damaged."""
        return read_json(self._path(step))

    def image(self, scene: str) -> Path:
        return self.folder / IMAGES / f"{scene}.png"

    @contextmanager
    def locked(self) -> Iterator[None]:
        """Keeps a second study out of the folder; throws RaywalkError when one is running."""
        with (self.folder / LOCK).open("w") as file:
            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except OSError as error:
                raise RaywalkError(f"another study is running in {self.folder}") from error
            yield

    def _path(self, step: Step) -> Path:
        return self.folder / STEPS / f"{step.key}.json"

    def _identity(self) -> dict[str, Any] | None:
        path = self.folder / IDENTITY
        return read_json(path) if path.is_file() else None

    def _clear(self) -> None:
        """Drops steps and images, nothing else."""
        for pattern in (f"{STEPS}/*.json", f"{IMAGES}/*.png"):
            for path in self.folder.glob(pattern):
                path.unlink()


def read_json(path: Path) -> dict[str, Any]:
    try:
        record = json.loads(path.read_bytes())
    except (OSError, ValueError) as error:
        raise RaywalkError(f"{path} cannot be read ({error}); remove it, or start over with --fresh") from error
    if not isinstance(record, dict):
        raise RaywalkError(f"{path} is no file of a study; remove it, or start over with --fresh")
    return record


def write_atomic(path: Path, content: bytes) -> None:
    """The whole content under its name, or what was there before."""
    partial = path.with_name(f".{path.name}.partial")
    with partial.open("wb") as file:
        file.write(content)
        file.flush()
        os.fsync(file.fileno())
    partial.replace(path)


def differing(kept: dict[str, Any], now: dict[str, Any], where: str = "") -> list[str]:
    """A clause for each value that is not the same."""
    clauses = []
    for name in dict.fromkeys([*kept, *now]):
        old, new = kept.get(name), now.get(name)
        if isinstance(old, dict) and isinstance(new, dict):
            clauses += differing(old, new, f"{where}{name} ")
        elif old != new:
            clauses.append(f"{where}{name} is {shown(old)} there and {shown(new)} now")
    return clauses


def shown(value: Any) -> str:
    if isinstance(value, list):
        return ",".join(str(one) for one in value)
    return "absent" if value is None else str(value)
