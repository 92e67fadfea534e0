"""What a fetch brings in, what comes of it, and who watches."""

from dataclasses import dataclass
from pathlib import Path
from typing import Literal, Protocol


@dataclass(frozen=True)
class Outcome:
    """What came of one source: fetched, there (and right), kept (the user's own), failed."""

    name: str
    state: Literal["fetched", "there", "kept", "failed"]
    detail: str = ""


class Watcher(Protocol):
    """Sees a fetch go on: a new step of a source with its total in bytes (None: unknown), then bytes done."""

    def step(self, name: str, what: str, total_bytes: int | None) -> None: ...
    def advance(self, count: int) -> None: ...


class Unwatched:
    def step(self, name: str, what: str, total_bytes: int | None) -> None:
        pass

    def advance(self, count: int) -> None:
        pass


class Source(Protocol):
    """One thing to bring in. `bring` leaves either everything or nothing behind, and throws RaywalkError."""

    @property
    def name(self) -> str: ...
    def bring(self, data_dir: Path, watcher: Watcher) -> Outcome: ...
