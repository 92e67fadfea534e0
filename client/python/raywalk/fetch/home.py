"""Public homes: the file that a manifest names under `source.original`, with its address and hash."""

import json
import os
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from raywalk.errors import RaywalkError
from raywalk.fetch.archive import extract_member, sha256_of
from raywalk.fetch.download import download
from raywalk.fetch.source import Outcome, Watcher


@dataclass(frozen=True)
class HomeFile:
    """One file of a scene. `home` is the address of the file itself, or of an archive that holds it as `member`."""

    name: str
    home: str
    file: str  # below the data folder
    sha256: str | None = None  # of the file
    member: str | None = None

    def bring(self, data_dir: Path, watcher: Watcher) -> Outcome:
        target = data_dir / self.file
        if target.is_file() and self.sha256 in (None, sha256_of(target)):
            return Outcome(self.name, "there")
        with TemporaryDirectory(prefix=".fetch-", dir=data_dir) as scratch:
            got = download(self.name, self.home, Path(scratch), watcher)
            if self.member:
                watcher.step(self.name, "unpacking", None)
                got = extract_member(got, self.member, Path(scratch) / "member")
            found = sha256_of(got)
            if self.sha256 and found != self.sha256:
                raise RaywalkError(
                    f"{target.name} from {self.home} has the SHA-256 {found}, the manifest says {self.sha256}; "
                    "nothing was kept"
                )
            target.parent.mkdir(parents=True, exist_ok=True)
            os.replace(got, target)
        return Outcome(self.name, "fetched", "" if self.sha256 else "no hash is known for it; taken as it came")


def home_sources(scenes_dir: Path) -> list[HomeFile]:
    """Files with a public home, by scene. Throws RaywalkError that names a bad manifest."""
    sources = []
    for manifest in sorted(scenes_dir.glob("*/scene.json")):
        try:
            original = json.loads(manifest.read_text())["source"].get("original") or {}
            if original.get("home"):
                keys = ("home", "file", "sha256", "member")
                sources.append(HomeFile(manifest.parent.name, **{key: original.get(key) for key in keys}))
        except (ValueError, KeyError, AttributeError) as error:
            raise RaywalkError(f"{manifest} is no manifest of a scene: {error!r}") from error
        if sources and not is_inside(sources[-1].file):
            raise RaywalkError(f"{manifest}: source.original.file must be a path inside the data folder")
    return sources


def is_inside(file: str | None) -> bool:
    return bool(file) and not Path(str(file)).is_absolute() and ".." not in Path(str(file)).parts
