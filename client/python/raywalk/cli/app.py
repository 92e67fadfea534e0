"""Global options, and all commands under their names."""

import signal
import sys
from enum import StrEnum
from typing import Annotated

import typer

from raywalk import __version__
from raywalk.cli import accuracy, bench, compare, demo, doctor, kernels, render, scenes, structures, study, tables
from raywalk.cli.session import CleanGroup, Settings

app = typer.Typer(
    cls=CleanGroup,
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
    help="Ray-tracing structures on one device, measured and checked. Without --server a local daemon is started, "
    "and stopped afterwards.",
)


class Device(StrEnum):
    AUTO = "auto"
    CPU = "cpu"
    CUDA = "cuda"


def show_version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"raywalk {__version__}")
        raise typer.Exit


@app.callback()
def globals_(
    context: typer.Context,
    server: Annotated[
        str | None, typer.Option(envvar="RAYWALK_SERVER", help="Address of a running daemon.", metavar="URL")
    ] = None,
    device: Annotated[
        Device | None, typer.Option(help="What the daemon that is started here renders on; auto when absent.")
    ] = None,
    version: Annotated[
        bool, typer.Option("--version", callback=show_version, is_eager=True, help="Show the version and exit.")
    ] = False,
) -> None:
    context.obj = context.obj or Settings()
    if server and device:
        raise typer.BadParameter("--device is for a daemon of one's own: the one that --server names has its device")
    context.obj.server = server
    context.obj.device = device.value if device else None


app.add_typer(scenes.app, name="scenes", help="The catalogue of scenes, and the original data.")
app.add_typer(structures.app, name="structures", help="Acceleration structures that are resident.")
app.command()(render.render)
app.command()(render.walk)
app.command()(compare.compare_images)
app.command()(bench.bench)
app.command()(accuracy.accuracy)
app.command()(tables.tables)
app.command()(demo.demo)
app.command()(study.study)
app.command()(doctor.doctor)
app.command()(kernels.kernels)


def main() -> None:
    """Entry of the installed command. SIGTERM ends it in good order, so that its daemon is stopped."""
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))
    app()
