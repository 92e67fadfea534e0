"""Scene data from a mirror folder and from public homes, and what goes wrong with both."""

import hashlib
import io
import json
import tarfile
import threading
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest
from raywalk.errors import RaywalkError
from raywalk.fetch import HomeFile, MirrorArchive, fill, home_sources, mirror_sources

MESH = b"ply\n" + b"x" * 5000


def archive(members: dict[str, bytes | None], mode: str = "w:xz") -> bytes:
    """A tar archive; None makes a link."""
    out = io.BytesIO()
    with tarfile.open(fileobj=out, mode=mode) as tar:
        for name, content in members.items():
            entry = tarfile.TarInfo(name)
            if content is None:
                entry.type, entry.linkname = tarfile.SYMTYPE, "/etc/passwd"
            else:
                entry.size = len(content)
            tar.addfile(entry, io.BytesIO(content or b""))
    return out.getvalue()


def mirror_of(folder: Path, archives: dict[str, bytes]) -> list[MirrorArchive]:
    folder.mkdir(exist_ok=True)
    sums = []
    for name, content in archives.items():
        (folder / f"{name}.tar.xz").write_bytes(content)
        sums.append(f"{hashlib.sha256(content).hexdigest()}  {name}.tar.xz\n")
    (folder / "SHA256SUMS").write_text("".join(sums))
    return mirror_sources(folder)


def states(outcomes) -> dict[str, str]:
    return {outcome.name: outcome.state for outcome in outcomes}


def test_mirror_fills_and_skips_what_is_there(tmp_path) -> None:
    sources = mirror_of(
        tmp_path / "mirror", {"bunny": archive({"bunny/a/mesh.ply": MESH}), "box": archive({"box/b": b""})}
    )
    data = tmp_path / "data"
    assert states(fill(sources, data)) == {"bunny": "fetched", "box": "fetched"}
    assert (data / "bunny/a/mesh.ply").read_bytes() == MESH
    assert states(fill(sources, data)) == {"bunny": "there", "box": "there"}


def test_mirror_mends_what_is_damaged(tmp_path) -> None:
    sources = mirror_of(tmp_path / "mirror", {"bunny": archive({"bunny/mesh.ply": MESH})})
    fill(sources, tmp_path / "data")
    (tmp_path / "data/bunny/mesh.ply").write_bytes(b"short")
    assert states(fill(sources, tmp_path / "data")) == {"bunny": "fetched"}
    assert (tmp_path / "data/bunny/mesh.ply").read_bytes() == MESH


def test_mirror_takes_up_a_new_archive(tmp_path) -> None:
    fill(mirror_of(tmp_path / "mirror", {"bunny": archive({"bunny/old.ply": MESH})}), tmp_path / "data")
    fill(mirror_of(tmp_path / "mirror", {"bunny": archive({"bunny/new.ply": MESH})}), tmp_path / "data")
    assert sorted(path.name for path in (tmp_path / "data/bunny").glob("*.ply")) == ["new.ply"]


def test_the_users_own_folder_is_kept(tmp_path) -> None:
    sources = mirror_of(tmp_path / "mirror", {"bunny": archive({"bunny/mesh.ply": MESH})})
    (tmp_path / "data/bunny").mkdir(parents=True)
    (tmp_path / "data/bunny/mine").write_text("mine")
    assert states(fill(sources, tmp_path / "data")) == {"bunny": "kept"}
    assert (tmp_path / "data/bunny/mine").read_text() == "mine"


@pytest.mark.parametrize(
    ("members", "message"),
    [
        ({"bunny/../../evil": b"x"}, "points outside"),
        ({"/tmp/evil": b"x"}, "points outside"),
        ({"bunny/link": None}, "neither file nor folder"),
        ({"other/mesh.ply": b"x"}, "should hold one folder bunny"),
        ({"bunny/mesh.ply": b"x", "more": b"x"}, "should hold one folder bunny"),
    ],
)
def test_hostile_archives_leave_nothing(tmp_path, members, message) -> None:
    sources = mirror_of(tmp_path / "mirror", {"bunny": archive(members)})
    (outcome,) = fill(sources, tmp_path / "data")
    assert outcome.state == "failed"
    assert message in outcome.detail
    assert list((tmp_path / "data").iterdir()) == []
    assert sorted(path.name for path in tmp_path.iterdir()) == ["data", "mirror"]


@pytest.mark.parametrize("spoil", [lambda content: content[:-20], lambda content: content[:-1] + b"!"])
def test_wrong_hash_is_refused_before_unpacking(tmp_path, spoil) -> None:
    content = archive({"bunny/mesh.ply": MESH})
    sources = mirror_of(tmp_path / "mirror", {"bunny": content, "box": archive({"box/b": b"b"})})
    (tmp_path / "mirror/bunny.tar.xz").write_bytes(spoil(content))
    failed, other = fill(sources, tmp_path / "data")
    assert "SHA256SUMS says" in failed.detail
    assert other.state == "fetched"
    assert [path.name for path in (tmp_path / "data").iterdir()] == ["box"]


def test_truncated_archive_of_the_right_hash(tmp_path) -> None:
    sources = mirror_of(tmp_path / "mirror", {"bunny": archive({"bunny/mesh.ply": MESH})[:100]})
    (outcome,) = fill(sources, tmp_path / "data")
    assert "cannot be unpacked" in outcome.detail
    assert list((tmp_path / "data").iterdir()) == []


def test_bad_mirrors(tmp_path) -> None:
    with pytest.raises(RaywalkError, match="holds no SHA256SUMS"):
        mirror_sources(tmp_path)
    (tmp_path / "SHA256SUMS").write_text("nonsense\n")
    with pytest.raises(RaywalkError, match="SHA256SUMS:1: expected"):
        mirror_sources(tmp_path)
    (tmp_path / "SHA256SUMS").write_text("0" * 64 + "  ../evil.tar.xz\n")
    with pytest.raises(RaywalkError, match="SHA256SUMS:1"):
        mirror_sources(tmp_path)
    (tmp_path / "SHA256SUMS").write_text("0" * 64 + "  gone.tar.xz\n")
    assert "is not there" in fill(mirror_sources(tmp_path), tmp_path / "data")[0].detail


def test_unwritable_data_folder(tmp_path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(RaywalkError, match="cannot be written"):
        fill([], tmp_path / "file")


# Public homes, played by a server of our own
PACKED = archive({"bunny/deep/mesh.ply": MESH, "bunny/other": b"o"}, "w:gz")
HASH = hashlib.sha256(MESH).hexdigest()


class Home(BaseHTTPRequestHandler):
    def do_GET(self) -> None:  # noqa: N802 (the name is the library's)
        path = self.path.removeprefix("/moved")
        if path != self.path:
            self.send_response(302)
            self.send_header("Location", path)
            self.end_headers()
            return
        content = {"/mesh.ply": MESH, "/bunny.tar.gz": PACKED, "/cut.tar.gz": PACKED}.get(path)
        self.send_response(404 if content is None else 200)
        self.send_header("Content-Length", str(len(content or b"")))
        self.end_headers()
        self.wfile.write((content or b"")[: 100 if path == "/cut.tar.gz" else None])

    def log_message(self, *_: object) -> None:
        pass


@pytest.fixture
def home() -> Iterator[str]:
    with ThreadingHTTPServer(("127.0.0.1", 0), Home) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_address[1]}"
        server.shutdown()


def bunny(home: str, path: str, sha256: str | None = HASH, member: str | None = "bunny/deep/mesh.ply") -> HomeFile:
    return HomeFile("bunny", home + path, "bunny/mesh.ply", sha256, member)


@pytest.mark.parametrize("path", ["/bunny.tar.gz", "/moved/bunny.tar.gz"])
def test_home_archive(tmp_path, home, path) -> None:
    source = bunny(home, path)
    assert states(fill([source], tmp_path)) == {"bunny": "fetched"}
    assert (tmp_path / "bunny/mesh.ply").read_bytes() == MESH
    assert states(fill([source], tmp_path)) == {"bunny": "there"}
    (tmp_path / "bunny/mesh.ply").write_bytes(b"damaged")
    assert states(fill([source], tmp_path)) == {"bunny": "fetched"}


def test_home_file(tmp_path, home) -> None:
    assert fill([bunny(home, "/mesh.ply", member=None)], tmp_path)[0].state == "fetched"
    (outcome,) = fill([HomeFile("box", home + "/mesh.ply", "box/mesh.ply")], tmp_path)
    assert (outcome.state, outcome.detail) == ("fetched", "no hash is known for it; taken as it came")


@pytest.mark.parametrize(
    ("path", "sha256", "member", "message"),
    [
        ("/gone.tar.gz", HASH, "bunny/deep/mesh.ply", "answers with status 404"),
        ("/bunny.tar.gz", "0" * 64, "bunny/deep/mesh.ply", "the manifest says 000000"),
        ("/bunny.tar.gz", HASH, "bunny/none.ply", "does not hold the file bunny/none.ply"),
        ("/cut.tar.gz", HASH, "bunny/deep/mesh.ply", "/cut.tar.gz"),
        ("/mesh.ply", HASH, "bunny/deep/mesh.ply", "cannot be unpacked"),
    ],
)
def test_home_failures_leave_nothing(tmp_path, home, path, sha256, member, message) -> None:
    (outcome,) = fill([bunny(home, path, sha256, member)], tmp_path)
    assert outcome.state == "failed"
    assert message in outcome.detail
    assert list(tmp_path.iterdir()) == []


def test_no_home(tmp_path) -> None:
    (outcome,) = fill([bunny("http://127.0.0.1:9", "/x")], tmp_path)
    assert "could not be downloaded" in outcome.detail


def test_homes_of_manifests(tmp_path) -> None:
    original = {"home": "http://h/x.gz", "file": "bunny/m.ply", "sha256": HASH, "member": "m", "credit": "someone"}
    for name, source in {"bunny": {"original": original}, "soup": {"generator": {"name": "soup"}}}.items():
        (tmp_path / name).mkdir()
        (tmp_path / name / "scene.json").write_text(json.dumps({"source": source}))
    assert home_sources(tmp_path) == [HomeFile("bunny", "http://h/x.gz", "bunny/m.ply", HASH, "m")]
    (tmp_path / "bunny/scene.json").write_text(json.dumps({"source": {"original": original | {"file": "../m"}}}))
    with pytest.raises(RaywalkError, match="inside the data folder"):
        home_sources(tmp_path)
    (tmp_path / "bunny/scene.json").write_text("{")
    with pytest.raises(RaywalkError, match="bunny/scene.json is no manifest"):
        home_sources(tmp_path)


def test_homes_of_the_catalogue() -> None:
    sources = home_sources(Path(__file__).resolve().parents[2] / "scenes")
    assert all(source.home.startswith(("http://", "https://")) and source.sha256 for source in sources)
    assert "bunny" in [source.name for source in sources]
