"""The licences of what a bundle contains: Debian's copyright files, and those of the other sources."""

import re
import shutil
import subprocess
from collections.abc import Iterable
from pathlib import Path

DOCUMENTS = Path("/usr/share/doc")
# Compiled into the daemon from headers; cpp-httplib and OpenImageIO have files of their own.
HEADER_PACKAGES = ("libcli11-dev", "libglm-dev", "libtinygltf-dev", "libvalijson-dev", "nlohmann-json3-dev")
COMMON = re.compile(r"/usr/share/common-licenses/([A-Za-z0-9.-]*[A-Za-z0-9])")


def package_of(library: Path) -> str:
    """The package that owns a file; dpkg may know it by its path from before /lib became a link."""
    real = str(library.resolve())
    for name in (real, real.removeprefix("/usr")):
        answer = subprocess.run(["dpkg-query", "--search", name], capture_output=True, text=True, check=False)
        if answer.returncode == 0:
            return answer.stdout.split(":", 1)[0]
    raise SystemExit(f"bundle: no package owns {library}, so that its licence is not known")


def collect(libraries: Iterable[Path], target: Path) -> None:
    """One file a package, and the full texts that they refer to."""
    target.mkdir(parents=True)
    for package in sorted({package_of(library) for library in libraries} | set(HEADER_PACKAGES)):
        shutil.copyfile(DOCUMENTS / package / "copyright", target / f"{package}.txt")
    texts = "".join(path.read_text(encoding="utf-8") for path in target.iterdir())
    for name in sorted(set(COMMON.findall(texts))):
        shutil.copyfile(Path("/usr/share/common-licenses") / name, target / f"{name}.txt")
