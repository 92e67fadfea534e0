"""What is shown of a job while it runs."""

from typing import Any

from raywalk.models import Job
from raywalk.progress import JobBar

from tests.client.test_client import JOB


class Shown:
    """A bar that keeps what it is told."""

    def __init__(self) -> None:
        self.updates: list[tuple[Any, ...]] = []

    def update(self, *update: Any) -> None:
        self.updates.append(update)


def job(**more: Any) -> Job:
    spec = {"scene": "bunny", "frames": 8, "error_frames": 4, "modes": ["primary", "shadow"]}
    spec["techniques"] = [{"structure": "bvh", "traversal": name} for name in ("packet", "while-while")]
    return Job.model_validate(JOB | {"spec": spec, "frames_done": 32, "frames_total": 32} | more)


def test_comparing_counts_compared_frames_without_a_rate() -> None:
    shown = Shown()
    bar = JobBar(shown, "bunny", 100)
    bar(job(state="running", stage="measuring bvh/packet", frames_done=16))
    bar(job(state="running", stage="measuring bvh/packet", frames_done=20))
    assert "frames/s" in shown.updates[-1][2]
    for progress, compared in ((0.8, 0), (0.85, 4), (0.9, 8), (1.0, 16)):
        bar(job(state="validating", stage="comparing with the reference", progress=progress))
        assert shown.updates[-1] == (compared, 16, "compared", "bunny: comparing with the reference")


def test_the_next_job_counts_anew() -> None:
    shown = Shown()
    bar = JobBar(shown, "bunny", 100)
    bar(job(state="validating", stage="comparing", progress=0.5))
    bar(job(state="succeeded", stage="done", progress=1))
    assert shown.updates[-1] == (32, 32, "", "bunny: done")
    bar(job(id="j2", state="validating", stage="comparing", progress=0.8))
    assert shown.updates[-1][:2] == (0, 16)
