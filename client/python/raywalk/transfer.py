"""Sends requests: retries with backoff, and problems as exceptions."""

import random
import time
from collections.abc import Callable
from typing import Any
from urllib.parse import urlsplit

import httpx2
from pydantic import ValidationError

from raywalk.errors import ProblemError, RaywalkError, UnreachableError
from raywalk.models import Problem

FIRST_PAUSE_S = 0.2
LONGEST_PAUSE_S = 10.0


class Transfer:
    """One connection pool to one daemon. Operations that may run twice without harm are marked `again`: those are sent
    again after a lost connection; a refused connection and a retryable problem are always tried again."""

    def __init__(
        self,
        base_url: str,
        transport: httpx2.BaseTransport | None,
        timeout_s: float,
        retries: int,
        sleep: Callable[[float], None] = time.sleep,
        on_lost: Callable[[], None] | None = None,
    ):
        address = urlsplit(base_url)
        if address.scheme not in ("http", "https") or not address.hostname:
            raise RaywalkError(f"{base_url!r} is no address of a daemon; it looks like http://127.0.0.1:7979")
        self.base_url = base_url.rstrip("/")
        self._retries = retries
        self._sleep = sleep
        self._on_lost = on_lost
        self._http = httpx2.Client(
            base_url=self.base_url,
            transport=transport,
            timeout=httpx2.Timeout(timeout_s, connect=min(timeout_s, 5.0)),
            trust_env=address.hostname not in ("127.0.0.1", "localhost", "::1"),
        )

    def close(self) -> None:
        self._http.close()

    def send(self, method: str, path: str, *, again: bool = True, **request: Any) -> httpx2.Response:
        """The answer of a request that succeeded. Throws ProblemError, UnreachableError."""
        for attempt in range(self._retries + 1):
            last = attempt == self._retries
            try:
                response = self._http.request(method, path, **request)
            except httpx2.TransportError as error:
                if self._on_lost and not isinstance(error, httpx2.ReadTimeout):
                    self._on_lost()
                lost = not isinstance(error, (httpx2.ConnectError, httpx2.ConnectTimeout))
                if last or (lost and not again) or isinstance(error, httpx2.ReadTimeout):
                    raise self._unreachable(error) from error
                self._sleep(pause_s(attempt))
                continue
            if response.is_success:
                return response
            problem = read_problem(response)
            if last or not problem.retryable:
                raise ProblemError(problem)
            self._sleep(pause_s(attempt, response.headers.get("Retry-After")))
        raise AssertionError("unreachable")

    def stream(self, path: str) -> Any:
        """Context manager of a streamed GET; no read timeout."""
        return self._http.stream("GET", path, timeout=httpx2.Timeout(None, connect=5.0))

    def _unreachable(self, error: Exception) -> UnreachableError:
        return UnreachableError(f"no answer from the daemon at {self.base_url}: {error or type(error).__name__}")


def pause_s(attempt: int, retry_after: str | None = None) -> float:
    """Doubles with every attempt, with jitter; what the server asks for counts if it is longer."""
    asked = float(retry_after) if retry_after and retry_after.isdecimal() else 0.0
    return min(LONGEST_PAUSE_S, max(asked, FIRST_PAUSE_S * 2**attempt * random.uniform(0.8, 1.2)))


def read_problem(response: httpx2.Response) -> Problem:
    """The problem that an answer carries; one made from its status when it carries none."""
    try:
        return Problem.model_validate_json(response.content)
    except ValidationError:
        path = response.request.url.path
        return Problem(
            type="about:blank",
            title=response.reason_phrase or f"HTTP status {response.status_code}",
            status=max(400, response.status_code),
            detail=f"HTTP status {response.status_code} for {path}",
            instance=path,
            code="not_a_problem",
            errors=[],
            retryable=response.status_code in (502, 503, 504),
            request_id=response.headers.get("X-Request-Id", ""),
        )
