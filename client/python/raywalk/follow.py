"""Waiting: for structures to be built, for jobs to end."""

import time
from collections.abc import Callable, Iterator
from contextlib import suppress

import httpx2

from raywalk.client import Client
from raywalk.errors import RaywalkError
from raywalk.models import AccuracyResult, AccuracySpec, BenchmarkResult, BenchmarkSpec, Job, Structure

ENDED = ("succeeded", "failed", "cancelled", "interrupted")
POLL_S = 0.1


def built(client: Client, scene: str, kind: str, options: dict[str, float | str] | None = None) -> Structure:
    """Builds a structure and waits for it; throws RaywalkError with the cause when the build failed."""
    structure = client.build_structure(scene, kind, options)
    while structure.state == "building":
        time.sleep(POLL_S)
        structure = client.get_structure(structure.id)
    if structure.state == "failed":
        raise RaywalkError(f"{kind} of {scene} could not be built: {structure.error or 'no cause given'}")
    return structure


def job_states(client: Client, job: Job) -> Iterator[Job]:
    """The job after every change, the last one ended. Lost event streams are taken up again."""
    yield job
    while job.state not in ENDED:
        try:
            for seen in client.stream_job_events(job.id):
                yield seen
                if seen.state in ENDED:
                    return
        except httpx2.HTTPError:
            time.sleep(POLL_S)
        job = client.get_job(job.id)
        yield job


def benchmark(client: Client, spec: BenchmarkSpec, on_change: Callable[[Job], None] | None = None) -> BenchmarkResult:
    """Runs a benchmark to its end; an interruption (Ctrl-C too) cancels it. Throws RaywalkError when it failed."""
    job = finished(client, spec, f"the benchmark of {spec.scene}", on_change)
    return client.get_result(job.result or job.id)


def accuracy(client: Client, spec: AccuracySpec, on_change: Callable[[Job], None] | None = None) -> AccuracyResult:
    """The same for a measurement of accuracy."""
    what = f"the measurement of accuracy on {spec.scene}" if spec.scene else "the run of the hard cases"
    job = finished(client, spec, what, on_change)
    return client.get_accuracy_result(job.result or job.id)


def finished(
    client: Client, spec: BenchmarkSpec | AccuracySpec, what: str, on_change: Callable[[Job], None] | None
) -> Job:
    """The job that has succeeded."""
    job = client.submit_job(spec)
    try:
        for now in job_states(client, job):
            job = now
            if on_change:
                on_change(now)
    except BaseException:
        if job.state not in ENDED:
            with suppress(RaywalkError):  # the first cause is the one to tell
                client.cancel_job(job.id)
        raise
    if job.state != "succeeded":
        cause = job.error.detail if job.error else "no cause given"
        raise RaywalkError(f"{what} ended as {job.state}: {cause}")
    return job
