"""Brings sources into the data folder one by one."""

from collections.abc import Callable, Iterable
from pathlib import Path
from tempfile import TemporaryDirectory

from raywalk.errors import RaywalkError
from raywalk.fetch.source import Outcome, Source, Unwatched, Watcher


def fill(
    sources: Iterable[Source],
    data_dir: Path,
    watcher: Watcher | None = None,
    on_outcome: Callable[[Outcome], None] | None = None,
) -> list[Outcome]:
    """Brings each source into `data_dir`; one that fails leaves nothing behind and does not stop the others. Throws
    RaywalkError when the folder cannot be written."""
    try:
        data_dir.mkdir(parents=True, exist_ok=True)
        with TemporaryDirectory(prefix=".fetch-", dir=data_dir):
            pass
    except OSError as error:
        raise RaywalkError(f"the data folder {data_dir} cannot be written: {error.strerror or error}") from error
    outcomes = []
    for source in sources:
        try:
            outcome = source.bring(data_dir, watcher or Unwatched())
        except (RaywalkError, OSError) as error:
            outcome = Outcome(source.name, "failed", str(error))
        outcomes.append(outcome)
        if on_outcome:
            on_outcome(outcome)
    return outcomes
