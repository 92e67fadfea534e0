"""Where things are, in a bundle or a checkout: the scenes, original scene data, the daemon's program."""

import os
import shutil
import tempfile
from pathlib import Path

from raywalk.errors import RaywalkError


def bundle() -> Path | None:
    """The folder of the bundle (./run bundle) that holds this package."""
    folder = Path(__file__).resolve().parents[2]
    return folder if (folder / "bin" / "raywalkd").is_file() else None


def checkout() -> Path | None:
    """The folder of the sources: the one that holds this package, else the one that holds the working folder."""
    for start in (Path(__file__).resolve(), Path.cwd().resolve() / "x"):
        for folder in start.parents:
            if (folder / "proto" / "openapi.yaml").is_file() and (folder / "scenes").is_dir():
                return folder
    return None


def scenes_dir() -> Path:
    """The catalogue's manifests."""
    if root := bundle():
        return root / "share" / "raywalk" / "scenes"
    if root := checkout():
        return root / "scenes"
    raise RaywalkError("the folder scenes/ was not found; run this inside the checkout of Raywalk")


def data_dir() -> Path:
    """Original scene data: RAYWALK_SCENE_DATA, else the folder data among the scenes."""
    named = os.environ.get("RAYWALK_SCENE_DATA")
    return Path(named) if named else scenes_dir() / "data"


def kernel_cache_dir() -> Path:
    """Compiled GPU kernels, kept from one daemon of one's own to the next: they are found by their content."""
    if named := os.environ.get("XDG_CACHE_HOME"):
        root = Path(named)
    else:
        try:
            root = Path.home() / ".cache"
        except RuntimeError:  # a user without a home
            root = Path(tempfile.gettempdir())
    return root / "raywalk" / "kernels"


def daemon_places() -> list[Path]:
    """Where the daemon is looked for, in order."""
    places = []
    if named := os.environ.get("RAYWALKD"):
        places.append(Path(named))
    if root := bundle():
        places.append(root / "bin" / "raywalkd")
    if root := checkout():
        places.append(root / "build" / "release" / "server" / "raywalkd")
    if found := shutil.which("raywalkd"):
        places.append(Path(found))
    return places


def daemon_program() -> Path:
    """The daemon's program. One that RAYWALKD names must be there: no other takes its place."""
    places = daemon_places()
    for place in places[:1] if os.environ.get("RAYWALKD") else places:
        if place.is_file() and os.access(place, os.X_OK):
            return place
    looked = ", ".join(str(place) for place in places) or "PATH"
    raise RaywalkError(
        f"raywalkd was not found (looked for {looked}); build it with ./run build, name it in RAYWALKD, "
        "or name a running daemon with --server"
    )
