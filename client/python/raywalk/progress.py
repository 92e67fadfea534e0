"""Progress on the terminal: bars with rates; plain lines where there is no terminal."""

import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager

from rich.console import Console
from rich.progress import (
    BarColumn,
    DownloadColumn,
    MofNCompleteColumn,
    Progress,
    SpinnerColumn,
    TaskID,
    TextColumn,
    TimeElapsedColumn,
    TimeRemainingColumn,
    TransferSpeedColumn,
)

from raywalk.models import BenchmarkSpec, Job

LINE_EVERY_S = 5.0


def messages() -> Console:
    """Where progress and messages go; results go to stdout."""
    return Console(file=sys.stderr, highlight=False, soft_wrap=True)


class Bar:
    """One bar that counts frames; `note` stands behind it and holds the rate."""

    def __init__(self, progress: Progress, task: TaskID, console: Console):
        self._progress, self._task, self._console = progress, task, console
        self._start = self._last_line = time.monotonic()

    def update(self, done: float, total: float | None = None, note: str = "", what: str | None = None) -> None:
        changes = {} if what is None else {"description": what}
        self._progress.update(self._task, completed=done, total=total, note=note, **changes)
        now = time.monotonic()
        if not self._console.is_terminal and now - self._last_line > LINE_EVERY_S:
            self._last_line = now
            share = f" {100 * done / total:.0f} %" if total else ""
            self._console.print(f"{what or self._progress.tasks[self._task].description}{share} {note}")

    def rate(self, done: float) -> float:
        """Per second since the bar began."""
        return done / max(1e-9, time.monotonic() - self._start)


@contextmanager
def bar(what: str, total: float | None = None, console: Console | None = None) -> Iterator[Bar]:
    console = console or messages()
    columns = (
        SpinnerColumn(),
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("{task.fields[note]}"),
        TimeElapsedColumn(),
        TimeRemainingColumn(),
    )
    with Progress(*columns, console=console, transient=True, disable=not console.is_terminal) as progress:
        yield Bar(progress, progress.add_task(what, total=total, note=""), console)


@contextmanager
def job_bar(what: str, rays_per_frame: int, console: Console | None = None) -> Iterator["JobBar"]:
    with bar(what, None, console) as inner:
        yield JobBar(inner, what, rays_per_frame)


class JobBar:
    """Shows a job's stage, frames and rate while it measures, the compared frames while it compares; primary rays are
    counted."""

    def __init__(self, inner: Bar, what: str, rays_per_frame: int):
        self._bar, self._what, self._rays = inner, what, rays_per_frame
        self._job = ""
        self._first: tuple[float, int] | None = None
        self._compare_from: float | None = None  # progress of the job when comparing began

    def __call__(self, job: Job) -> None:
        if job.id != self._job:
            self._job, self._first, self._compare_from = job.id, None, None
        if job.state == "validating" and isinstance(job.spec, BenchmarkSpec):
            return self._compare(job, job.spec)
        done, total = job.frames_done or 0, job.frames_total
        note = ""
        if done and job.state == "running":
            now = time.monotonic()
            self._first = self._first or (now, done)
            if done > self._first[1]:
                rate = (done - self._first[1]) / max(1e-9, now - self._first[0])
                note = f"{rate:.1f} frames/s  {rate * self._rays / 1e6:.2f} Mrays/s"
        stage = job.stage if job.state != "queued" else f"queued behind {job.position}"
        self._bar.update(done, total, note, f"{self._what}: {stage}")

    def _compare(self, job: Job, spec: BenchmarkSpec) -> None:
        """The job tells its progress alone: what is left of it is shared evenly by the frames to compare."""
        self._compare_from = job.progress if self._compare_from is None else self._compare_from
        frames = min(spec.error_frames or 1, spec.frames or 1)
        total = frames * len(spec.techniques or [None]) * len(spec.modes or [None])
        done = round(total * (job.progress - self._compare_from) / max(1e-9, 1 - self._compare_from))
        self._bar.update(done, total, "compared", f"{self._what}: {job.stage}")


class StageBar:
    """Shows a job that has no frames: its stage and its share of the whole."""

    def __init__(self, inner: Bar, what: str):
        self._bar, self._what = inner, what

    def __call__(self, job: Job) -> None:
        stage = job.stage if job.state != "queued" else f"queued behind {job.position}"
        self._bar.update(round(100 * job.progress), 100, what=f"{self._what}: {stage}")


@contextmanager
def stage_bar(what: str, console: Console | None = None) -> Iterator[StageBar]:
    with bar(what, 100, console) as inner:
        yield StageBar(inner, what)


class ByteBars:
    """Watcher of a fetch: one bar that shows the step of the moment."""

    def __init__(self, console: Console | None = None):
        console = console or messages()
        columns = (TextColumn("{task.description}"), BarColumn(), DownloadColumn(), TransferSpeedColumn())
        self._progress = Progress(*columns, console=console, transient=True, disable=not console.is_terminal)
        self._task = self._progress.add_task("", total=None)

    def __enter__(self) -> "ByteBars":
        self._progress.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._progress.stop()

    def step(self, name: str, what: str, total_bytes: int | None) -> None:
        self._progress.reset(self._task, description=f"{name}: {what}", total=total_bytes)

    def advance(self, count: int) -> None:
        self._progress.advance(self._task, count)
