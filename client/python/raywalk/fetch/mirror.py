"""A mirror: a folder of archives NAME.tar.xz, each of which unpacks to a folder NAME, with their SHA256SUMS."""

import re
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from raywalk.errors import RaywalkError
from raywalk.fetch.archive import is_ours, is_right, sha256_of, swap_in, unpack, write_stamp
from raywalk.fetch.source import Outcome, Watcher

SUFFIX = ".tar.xz"
SUM_LINE = re.compile(r"^([0-9a-f]{64}) [ *](\S+)$")


@dataclass(frozen=True)
class MirrorArchive:
    """An archive that is unpacked to the folder `name` of the data folder, after its hash is verified."""

    name: str
    archive: Path
    sha256: str

    def bring(self, data_dir: Path, watcher: Watcher) -> Outcome:
        target = data_dir / self.name
        if is_right(target, self.sha256):
            return Outcome(self.name, "there")
        if target.exists() and not is_ours(target):
            return Outcome(self.name, "kept", f"{target} was not made by a fetch; move it away to have it replaced")
        self._verify(watcher)
        with TemporaryDirectory(prefix=".fetch-", dir=data_dir) as scratch:
            unpacked = Path(scratch) / "unpacked"
            unpacked.mkdir()
            unpack(self.archive, unpacked, lambda total: watcher.step(self.name, "unpacking", total), watcher.advance)
            folder = unpacked / self.name
            if [entry.name for entry in unpacked.iterdir()] != [self.name] or not folder.is_dir():
                raise RaywalkError(f"{self.archive.name} should hold one folder {self.name}; nothing was unpacked")
            write_stamp(folder, self.archive.name, self.sha256)
            swap_in(folder, target, Path(scratch) / "old")
        return Outcome(self.name, "fetched")

    def _verify(self, watcher: Watcher) -> None:
        if not self.archive.is_file():
            raise RaywalkError(f"{self.archive} is listed in SHA256SUMS but is not there")
        watcher.step(self.name, "verifying", self.archive.stat().st_size)
        found = sha256_of(self.archive, watcher.advance)
        if found != self.sha256:
            raise RaywalkError(
                f"{self.archive.name} has the SHA-256 {found}, SHA256SUMS says {self.sha256}; nothing was unpacked"
            )


def mirror_sources(mirror: Path) -> list[MirrorArchive]:
    """Archives that the SHA256SUMS of a mirror folder lists. Throws RaywalkError for a bad or missing list."""
    listing = mirror / "SHA256SUMS"
    if not listing.is_file():
        raise RaywalkError(f"{mirror} is no mirror of scene data: it holds no SHA256SUMS")
    sources = []
    for number, line in enumerate(listing.read_text(errors="replace").splitlines(), 1):
        if not line.strip():
            continue
        match = SUM_LINE.match(line)
        if not match or "/" in match[2] or match[2].startswith("."):
            raise RaywalkError(f"{listing}:{number}: expected a SHA-256 and the name of an archive")
        if match[2].endswith(SUFFIX):
            sources.append(MirrorArchive(match[2].removesuffix(SUFFIX), mirror / match[2], match[1]))
    return sources
