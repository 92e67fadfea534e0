"""What commands share: errors as one message, the daemon they talk to, ways to print."""

import json
import math
import re
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryFile
from typing import Any

import httpx2
import typer
from pydantic import BaseModel, ValidationError
from rich.console import Console
from typer.core import TyperGroup

from raywalk.client import Client
from raywalk.daemon import LocalDaemon
from raywalk.errors import RaywalkError

PIPED_WIDTH = 200  # characters: room for the widest table


@dataclass
class Settings:
    """Global options; `transport` replaces the network in tests."""

    server: str | None = None
    device: str | None = None  # of a daemon of one's own; its own choice when absent
    transport: httpx2.BaseTransport | None = None


class CleanGroup(TyperGroup):
    """Prints what went wrong as one message and exits with 1; a traceback is left to programming errors."""

    def invoke(self, ctx: Any) -> Any:
        try:
            return super().invoke(ctx)
        except ValidationError as error:
            first = error.errors()[0]
            where = ".".join(str(step) for step in first["loc"])
            fail(f"{where}: {first['msg']}")
        except RaywalkError as error:
            fail(str(error))
        except BrokenPipeError:
            raise  # the reader has seen enough, as in `| head`: Click ends quietly
        except OSError as error:
            fail(f"{error.filename}: {error.strerror}" if error.filename else str(error))
        except KeyboardInterrupt:
            fail("interrupted", code=130)


def fail(message: str, code: int = 1) -> None:
    print(f"raywalk: {message}", file=sys.stderr)
    raise typer.Exit(code)


@contextmanager
def connected(context: typer.Context) -> Iterator[Client]:
    """A client of the daemon that --server names; else of one that lives as long as the block."""
    settings: Settings = context.obj
    if settings.server or settings.transport:
        with Client(settings.server or "http://daemon", transport=settings.transport) as client:
            yield client
    else:
        arguments = ("--device", settings.device) if settings.device else ()
        with LocalDaemon(arguments=arguments) as daemon, Client(daemon.base_url, on_lost=daemon.check_alive) as client:
            yield client


def results() -> Console:
    """Where results go. Piped tables keep their width."""
    width = None if sys.stdout.isatty() else PIPED_WIDTH
    return Console(file=sys.stdout, highlight=False, width=width)


def print_json(value: BaseModel | list[Any] | dict[str, Any]) -> None:
    def plain(item: Any) -> Any:
        return item.model_dump(mode="json", exclude_none=True) if isinstance(item, BaseModel) else item

    shown = [plain(item) for item in value] if isinstance(value, list) else plain(value)
    typer.echo(json.dumps(shown, indent=1))


def size(text: str) -> tuple[int, int]:
    """WxH in pixels."""
    match = re.fullmatch(r"(\d{1,5})[xX](\d{1,5})", text)
    if not match or not all(1 <= int(side) <= 8192 for side in match.groups()):
        raise typer.BadParameter(f"{text!r} is no size like 512x512 with sides of 1 to 8192 pixels")
    return int(match[1]), int(match[2])


def vector(text: str) -> list[float]:
    """X,Y,Z."""
    try:
        numbers = [float(part) for part in text.split(",")]
    except ValueError:
        numbers = []
    if len(numbers) != 3:
        raise typer.BadParameter(f"{text!r} are no three numbers like 0,1.5,2")
    if not all(math.isfinite(number) for number in numbers):
        raise typer.BadParameter(f"{text!r} holds a number that is not finite")
    return numbers


def technique(text: str) -> tuple[str, str]:
    """STRUCTURE/TRAVERSAL."""
    structure, slash, traversal = text.partition("/")
    if not (structure and slash and traversal):
        raise typer.BadParameter(f"{text!r} is no technique like bvh/while-while")
    return structure, traversal


def options(given: list[str] | None, example: str = "bins=32") -> dict[str, float | str] | None:
    """name=value pairs, each name once; what looks like a number is one."""
    parsed: dict[str, float | str] = {}
    for pair in given or []:
        name, equals, value = pair.partition("=")
        if not (name and equals and value):
            raise typer.BadParameter(f"{pair!r} is no option like {example}")
        if name in parsed:
            raise typer.BadParameter(f"{name!r} is given twice")
        try:
            number = float(value)
        except ValueError:
            parsed[name] = value
            continue
        if not math.isfinite(number):
            raise typer.BadParameter(f"{pair!r} is not finite")
        parsed[name] = number
    return parsed or None


def words(text: str) -> list[str]:
    """A list separated by commas."""
    return [word.strip() for word in text.split(",") if word.strip()]


def writable_folder(folder: Path) -> Path:
    """Makes the folder; throws RaywalkError when nothing can be written in it."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with TemporaryFile(dir=folder):
            pass
    except OSError as error:
        raise RaywalkError(f"the out folder {folder} cannot be written: {error.strerror or error}") from error
    return folder


def writable_file(path: Path) -> Path:
    """Makes the file's folder and checks that it can be written; throws RaywalkError."""
    writable_folder(path.parent)
    if path.is_dir():
        raise RaywalkError(f"{path} is a folder")
    return path
