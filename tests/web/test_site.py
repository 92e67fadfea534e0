"""The embedded files: types, caching, compression, the browser's rules, size."""

import gzip
import re

import pytest

from tests.api.conftest import Daemon
from tests.web.conftest import WEB

BUNDLE_LIMIT = 150_000  # bytes, compressed


def assets(daemon: Daemon) -> list[str]:
    page = daemon.client.get("/").text
    return re.findall(r'(?:src|href)="(/assets/[^"]+)"', page)


def test_the_page_has_strict_rules_and_is_asked_for_again(daemon: Daemon) -> None:
    answer = daemon.client.get("/")
    assert answer.status_code == 200
    assert answer.headers["content-type"] == "text/html; charset=utf-8"
    assert answer.headers["cache-control"] == "no-cache"
    assert answer.headers["x-content-type-options"] == "nosniff"
    policy = answer.headers["content-security-policy"]
    assert "default-src 'none'" in policy and "script-src 'self';" in policy and "style-src 'self';" in policy
    assert "unsafe" not in policy and "frame-ancestors 'none'" in policy
    again = daemon.client.get("/", headers={"If-None-Match": answer.headers["etag"]})
    assert again.status_code == 304 and again.content == b""
    assert again.headers["etag"] == answer.headers["etag"]


@pytest.mark.parametrize("suffix", [".js", ".css"])
def test_assets_are_compressed_and_kept(daemon: Daemon, suffix: str) -> None:
    path = next(path for path in assets(daemon) if path.endswith(suffix))
    plain = daemon.client.get(path, headers={"Accept-Encoding": "identity"})
    packed = daemon.client.get(path, headers={"Accept-Encoding": "br, gzip;q=0.8"})
    assert "content-encoding" not in plain.headers
    assert packed.headers["content-encoding"] == "gzip"
    assert packed.headers["vary"] == "Accept-Encoding"
    assert int(packed.headers["content-length"]) < int(plain.headers["content-length"])
    assert packed.content == plain.content
    assert "immutable" in plain.headers["cache-control"]
    refused = daemon.client.get(path, headers={"Accept-Encoding": "gzip;q=0, identity"})
    assert "content-encoding" not in refused.headers


def test_head_has_no_body(daemon: Daemon) -> None:
    answer = daemon.client.head("/")
    assert answer.status_code == 200 and answer.content == b""


def test_other_methods_and_paths_are_problems(daemon: Daemon) -> None:
    daemon.problem("GET", "/assets/nothing.js", 404, "not_found")
    daemon.problem("GET", "/assets/", 404, "not_found")
    daemon.problem("POST", "/", 404, "not_found")


def test_foreign_pages_are_refused(daemon: Daemon) -> None:
    daemon.problem("GET", "/", 403, "foreign_host", headers={"Host": "example.org"})
    daemon.problem("GET", "/v1/system", 403, "foreign_origin", headers={"Origin": "http://example.org"})
    own = daemon.client.get("/v1/system", headers={"Origin": f"http://127.0.0.1:{daemon.port}"})
    assert own.status_code == 200


def test_the_bundle_is_small(daemon: Daemon) -> None:
    built = sorted(WEB.parents[1].glob("build/*/server/web"), key=lambda path: path.stat().st_mtime)[-1]
    files = [path for path in built.rglob("*") if path.suffix in (".html", ".js", ".css", ".svg")]
    size = sum(len(gzip.compress(path.read_bytes(), 9)) for path in files)
    assert files and size <= BUNDLE_LIMIT


def test_data_never_becomes_markup() -> None:
    forbidden = re.compile(r"innerHTML|outerHTML|insertAdjacentHTML|document\.write|DOMParser|\beval\(|new Function")
    found = [path.name for path in (WEB / "src").rglob("*.ts") if forbidden.search(path.read_text(encoding="utf-8"))]
    assert found == []
