"""A daemon made of answers: requests are recorded, replies are looked up by method and path."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import httpx2
import pytest
from raywalk.client import Client
from raywalk.models import BenchmarkResult

HERE = Path(__file__).resolve().parent
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
