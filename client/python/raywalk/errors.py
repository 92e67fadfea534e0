"""Errors that the client raises; the command line prints their text as one message."""

from raywalk.models import Problem


class RaywalkError(Exception):
    """What went wrong, in a sentence for people."""


class UnreachableError(RaywalkError):
    """No answer came from the daemon."""


class ProblemError(RaywalkError):
    """The daemon refused or failed; `problem` has every field of its application/problem+json."""

    def __init__(self, problem: Problem):
        self.problem = problem
        super().__init__(describe(problem))

    @property
    def status(self) -> int:
        return self.problem.status

    @property
    def code(self) -> str:
        return self.problem.code

    @property
    def retryable(self) -> bool:
        return self.problem.retryable


def describe(problem: Problem) -> str:
    """The problem as text: what happened, each offending field, the names that are known."""
    lines = [problem.detail or problem.title]
    offences = [f"  {offence.pointer or '(body)'}: {offence.detail}" for offence in problem.errors]
    lines += [line for line in offences if line.split(": ", 1)[1] not in lines[0]]
    if problem.known and not all(name in lines[0] for name in problem.known):
        lines.append(f"  known: {', '.join(problem.known)}")
    return "\n".join(lines)
