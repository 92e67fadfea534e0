"""A daemon made of answers: requests are recorded, replies are looked up by method and path."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import httpx2
import pytest
from raywalk.cli import app
from raywalk.cli.session import Settings
from raywalk.client import Client
from raywalk.models import BenchmarkResult
from typer.testing import CliRunner

HERE = Path(__file__).resolve().parent
JOB = {"id": "j1", "kind": "benchmark", "spec": {"scene": "bunny"}, "state": "running", "position": 0}
JOB |= {"progress": 0.5, "stage": "measuring", "attempt": 1, "created_at": "2026-01-01T00:00:00Z"}
Reply = httpx2.Response | Callable[[httpx2.Request], httpx2.Response] | dict | list | str | bytes


class FakeDaemon:
    """`on` sets the replies to a request; several are given in turn, the last one for good."""

    def __init__(self) -> None:
        self.requests: list[httpx2.Request] = []
        self.pauses: list[float] = []
        self._replies: dict[tuple[str, str], list[Any]] = {}

    def on(self, method: str, path: str, *replies: Any) -> None:
        self._replies[method, path] = list(replies)

    def handle(self, request: httpx2.Request) -> httpx2.Response:
        self.requests.append(request)
        replies = self._replies.get((request.method, request.url.path))
        if not replies:
            return problem(404, "not_found", f"no reply is set for {request.method} {request.url.path}")
        reply = replies.pop(0) if len(replies) > 1 else replies[0]
        if isinstance(reply, Exception):
            raise reply
        if callable(reply):
            return reply(request)
        if isinstance(reply, httpx2.Response):
            return reply
        if isinstance(reply, (str, bytes)):
            return httpx2.Response(200, content=reply)
        return httpx2.Response(200, json=reply)

    @property
    def transport(self) -> httpx2.MockTransport:
        return httpx2.MockTransport(self.handle)

    def sent(self, number: int = -1) -> Any:
        """JSON body of a request."""
        return json.loads(self.requests[number].content)


def problem(status: int, code: str, detail: str, retryable: bool = False, **more: Any) -> httpx2.Response:
    headers = more.pop("headers", {})
    body = {"type": "about:blank", "title": code, "status": status, "detail": detail, "instance": "/x", "code": code}
    body |= {"errors": [], "retryable": retryable, "request_id": "r1"} | more
    return httpx2.Response(status, json=body, headers=headers | {"Content-Type": "application/problem+json"})


@pytest.fixture
def daemon() -> FakeDaemon:
    return FakeDaemon()


@pytest.fixture
def client(daemon: FakeDaemon) -> Client:
    return Client("http://daemon", transport=daemon.transport, sleep=daemon.pauses.append)


@pytest.fixture
def result() -> BenchmarkResult:
    """A small result of a run on the bunny."""
    return BenchmarkResult.model_validate_json((HERE / "data/result.json").read_bytes())


@pytest.fixture
def gpu() -> BenchmarkResult:
    """A result of a GPU, made by hand: four techniques with a register cap, throughput and telemetry."""
    return BenchmarkResult.model_validate_json((HERE / "data/gpu.json").read_bytes())


@pytest.fixture
def sweep() -> BenchmarkResult:
    """A result of `bench --table 3`, made by hand: two techniques, three register caps."""
    return BenchmarkResult.model_validate_json((HERE / "data/sweep.json").read_bytes())


@pytest.fixture
def raywalk(daemon: FakeDaemon) -> Callable[..., Any]:
    """Runs a command line; gives exit code, stdout and stderr."""

    def run(*words: object) -> Any:
        return CliRunner().invoke(app, [str(word) for word in words], obj=Settings(transport=daemon.transport))

    return run


EVENTS = {"Content-Type": "text/event-stream"}


def job_that_gives(daemon: FakeDaemon, *results: BenchmarkResult) -> None:
    """One job after the other, each at its end at once."""
    daemon.on("POST", "/v1/jobs", *[JOB | {"id": f"j{number}"} for number in range(len(results))])
    for number, result in enumerate(results):
        ended = JOB | {"id": f"j{number}", "state": "succeeded", "result": f"r{number}"}
        stream = f"event: job\ndata: {json.dumps(ended)}\n\n"
        daemon.on("GET", f"/v1/jobs/j{number}/events", httpx2.Response(200, content=stream, headers=EVENTS))
        daemon.on("GET", f"/v1/results/r{number}", result.model_dump(mode="json"))


def specs_sent(daemon: FakeDaemon) -> list[dict[str, Any]]:
    """The specifications of the jobs that were asked for."""
    return [json.loads(one.content)["spec"] for one in daemon.requests if one.url.path == "/v1/jobs"]
