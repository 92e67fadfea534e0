"""Problems as exceptions, retries with backoff."""

import httpx2
import pytest
from raywalk.client import Client
from raywalk.errors import ProblemError, UnreachableError
from raywalk.transfer import LONGEST_PAUSE_S, pause_s

from tests.client.conftest import problem


def test_problem_has_every_field(client, daemon) -> None:
    answer = problem(404, "unknown_scene", "There is no scene 'hare'.", known=["bunny", "room"])
    daemon.on("GET", "/v1/scenes/hare", answer)
    with pytest.raises(ProblemError) as caught:
        client.get_scene("hare")
    error = caught.value
    assert (error.status, error.code, error.retryable) == (404, "unknown_scene", False)
    assert error.problem.known == ["bunny", "room"]
    assert str(error) == "There is no scene 'hare'.\n  known: bunny, room"
    assert len(daemon.requests) == 1


def test_offences_are_named(client, daemon) -> None:
    offences = [{"pointer": "/name", "detail": "is no name"}]
    daemon.on("GET", "/v1/scenes/x", problem(422, "invalid_request", "The request is wrong.", errors=offences))
    with pytest.raises(ProblemError, match="/name: is no name"):
        client.get_scene("x")


def test_an_error_without_a_problem(client, daemon) -> None:
    daemon.on("GET", "/v1/scenes/x", httpx2.Response(500, content=b"<html>"))
    with pytest.raises(ProblemError, match="HTTP status 500 for /v1/scenes/x"):
        client.get_scene("x")


def test_retryable_problems_are_tried_again(client, daemon) -> None:
    busy = problem(503, "busy", "busy", retryable=True, headers={"Retry-After": "2"})
    daemon.on("GET", "/livez", busy, busy, "ok")
    assert client.get_livez() == "ok"
    assert len(daemon.requests) == 3
    assert daemon.pauses == [2.0, 2.0]


def test_retries_end(client, daemon) -> None:
    daemon.on("GET", "/livez", problem(503, "busy", "busy", retryable=True))
    with pytest.raises(ProblemError):
        client.get_livez()
    assert len(daemon.requests) == 4
    assert daemon.pauses == sorted(daemon.pauses)


def test_lost_connections_are_taken_up(client, daemon) -> None:
    daemon.on("GET", "/livez", httpx2.ReadError("lost"), httpx2.ConnectError("refused"), "ok")
    assert client.get_livez() == "ok"


def test_what_may_have_happened_is_not_repeated(client, daemon) -> None:
    daemon.on("DELETE", "/v1/scenes/mine", httpx2.ReadError("lost"))
    with pytest.raises(UnreachableError, match="no answer from the daemon at http://daemon: lost"):
        client.delete_scene("mine")
    assert len(daemon.requests) == 1
    daemon.on("DELETE", "/v1/scenes/mine", httpx2.ConnectError("refused"), httpx2.Response(204))
    client.delete_scene("mine")


def test_a_slow_answer_is_not_asked_for_again(client, daemon) -> None:
    daemon.on("GET", "/livez", httpx2.ReadTimeout("slow"))
    with pytest.raises(UnreachableError):
        client.get_livez()
    assert len(daemon.requests) == 1


def test_no_daemon() -> None:
    with pytest.raises(UnreachableError, match="127.0.0.1:9"):
        Client("http://127.0.0.1:9", retries=0).get_livez()


def test_pauses() -> None:
    assert pause_s(20) == LONGEST_PAUSE_S
    assert pause_s(0, "3") == 3
    assert pause_s(0, "Wed, 21 Oct 2026 07:28:00 GMT") < 1
