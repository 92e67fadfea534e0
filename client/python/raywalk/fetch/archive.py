"""Archives of scene data: hashing, safe unpacking, and the stamp that says what was unpacked."""

import hashlib
import json
import os
import shutil
import tarfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path, PurePosixPath

from raywalk.errors import RaywalkError

STAMP = ".raywalk-archive.json"
CHUNK_BYTES = 1 << 20
Advance = Callable[[int], None]


def sha256_of(path: Path, advance: Advance | None = None) -> str:
    """SHA-256 of a file as lower-case hex; `advance` gets the bytes read."""
    digest = hashlib.sha256()
    with path.open("rb") as stream:
        while chunk := stream.read(CHUNK_BYTES):
            digest.update(chunk)
            if advance:
                advance(len(chunk))
    return digest.hexdigest()


@contextmanager
def opened(archive: Path) -> Iterator[tarfile.TarFile]:
    """A tar archive (plain, gz, bz2, xz); what is wrong with it becomes a RaywalkError."""
    try:
        with tarfile.open(archive, "r:*") as tar:
            yield tar
    except (tarfile.TarError, EOFError, OSError) as error:
        raise RaywalkError(f"{archive.name} cannot be unpacked: {error}") from error


def unpack(archive: Path, folder: Path, total: Advance, advance: Advance) -> None:
    """Unpacks into `folder`. A member that would leave the folder, or is neither file nor folder, refuses the whole
    archive. Throws RaywalkError."""
    with opened(archive) as tar:
        members = tar.getmembers()
        for member in members:
            path = PurePosixPath(member.name)
            if path.is_absolute() or ".." in path.parts:
                raise RaywalkError(f"{archive.name}: the member {member.name!r} points outside")
            if not (member.isfile() or member.isdir()):
                raise RaywalkError(f"{archive.name}: the member {member.name!r} is neither file nor folder")
        total(sum(member.size for member in members))
        for member in members:
            tar.extract(member, folder, filter="data")
            advance(member.size)


def extract_member(archive: Path, member: str, target: Path) -> Path:
    """Writes one file of an archive to `target`. Throws RaywalkError when it is not in there."""
    with opened(archive) as tar:
        try:
            stream = tar.extractfile(member)
        except KeyError:
            stream = None
        if stream is None:
            raise RaywalkError(f"{archive.name} does not hold the file {member}")
        with stream, target.open("wb") as file:
            shutil.copyfileobj(stream, file)
    return target


def files_of(folder: Path) -> dict[str, int]:
    """Relative name to size in bytes of every file but the stamp."""
    files = (path for path in sorted(folder.rglob("*")) if path.is_file() and path.name != STAMP)
    return {path.relative_to(folder).as_posix(): path.stat().st_size for path in files}


def write_stamp(folder: Path, origin: str, sha256: str) -> None:
    record = {"origin": origin, "sha256": sha256, "files": files_of(folder)}
    (folder / STAMP).write_text(json.dumps(record, indent=1) + "\n")


def is_right(folder: Path, sha256: str) -> bool:
    """True if `folder` was unpacked from the archive of this hash and all its files are there with their sizes."""
    try:
        record = json.loads((folder / STAMP).read_text())
        present = files_of(folder)
        return record["sha256"] == sha256 and all(present.get(k) == v for k, v in record["files"].items())
    except (OSError, ValueError, KeyError, AttributeError, TypeError):
        return False


def is_ours(folder: Path) -> bool:
    """True if a fetch made this folder; any other belongs to the user and is left alone."""
    return (folder / STAMP).is_file()


def swap_in(new: Path, target: Path, trash: Path) -> None:
    """Puts `new` in the place of `target` by renaming; an old one is moved to `trash`."""
    if target.exists():
        os.replace(target, trash)
    os.replace(new, target)
