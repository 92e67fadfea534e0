"""Downloads an archive from its public home."""

from pathlib import Path
from urllib.parse import unquote, urlsplit

import httpx2

from raywalk.errors import RaywalkError
from raywalk.fetch.source import Watcher

LONGEST_BYTES = 8 << 30


def download(name: str, url: str, folder: Path, watcher: Watcher) -> Path:
    """Fetches `url` into `folder`. Throws RaywalkError for a bad status, a lost connection or a short answer."""
    target = folder / (Path(unquote(urlsplit(url).path)).name or name)
    timeout = httpx2.Timeout(60.0, connect=10.0)
    try:
        with httpx2.stream("GET", url, follow_redirects=True, timeout=timeout) as answer, target.open("wb") as file:
            if not answer.is_success:
                raise RaywalkError(f"{url} answers with status {answer.status_code}")
            length = answer.headers.get("Content-Length", "")
            total = int(length) if length.isdecimal() else None
            watcher.step(name, "downloading", total)
            got = 0
            for chunk in answer.iter_raw():
                got += len(chunk)
                if got > LONGEST_BYTES:
                    raise RaywalkError(f"{url} is longer than {LONGEST_BYTES >> 30} GiB")
                file.write(chunk)
                watcher.advance(len(chunk))
    except (httpx2.HTTPError, httpx2.InvalidURL) as error:
        raise RaywalkError(f"{url} could not be downloaded: {error or type(error).__name__}") from error
    if total is not None and got != total:
        raise RaywalkError(f"{url} ended after {got} of {total} bytes")
    return target
