"""Puts the bundle together from build/bundle and packs it: `./run bundle` calls this when the daemon is built.

out/bundle/raywalk-<version>-linux-x86_64/ and a .tar.xz beside it, for machines without root: any x86-64-v3 Linux with
glibc 2.36 or newer, with or without a GPU. Fails when a rule of rules.py is broken.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import licences
from elf import read_elf
from rules import LIMIT_BYTES, NEWEST_GLIBC, SYSTEM, offences

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
BUILD = ROOT / "build/bundle"
OPENIMAGEIO = ROOT / "build/openimageio"
TEST_PROGRAMS = ("test_device", "test_gpu", "test_accuracy", "raywalk_at_scale")
LDD_LINE = re.compile(r"^\s*(\S+) => (/\S+)")


def version() -> str:
    cache = (BUILD / "CMakeCache.txt").read_text(encoding="utf-8")
    found = re.search(r"^CMAKE_PROJECT_VERSION:STATIC=(.+)$", cache, re.MULTILINE)
    assert found, "CMake keeps the project's version in its cache"
    return found[1]


def build_tests() -> None:
    command = ["cmake", "--build", BUILD, "--parallel", str(os.cpu_count()), "--target", *TEST_PROGRAMS]
    subprocess.run(command, check=True, stdout=sys.stderr)


def install(program: str, bundle: Path) -> None:
    command = ["cmake", "--install", BUILD, "--strip", "--component", program, "--prefix", bundle]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


def places_of_libraries(program: Path) -> dict[str, Path]:
    """What the loader of this machine takes for `program`: the small OpenImageIO first, then the system's."""
    answer = subprocess.run(
        ["ldd", program], check=True, capture_output=True, text=True, env={"LD_LIBRARY_PATH": str(OPENIMAGEIO / "lib")}
    )
    return {found[1]: Path(found[2]) for found in map(LDD_LINE.match, answer.stdout.splitlines()) if found}


def place_libraries(bundle: Path, programs: list[Path]) -> list[Path]:
    """Copies what the programs need, under the names that they ask for; gives the files that were copied."""
    (bundle / "lib").mkdir()
    wanted = {name: place for program in programs for name, place in places_of_libraries(program).items()}
    copied = []
    for name, place in sorted(wanted.items()):
        if name in SYSTEM:
            continue
        target = bundle / "lib" / name
        subprocess.run(["strip", "--strip-unneeded", "-o", target, place.resolve()], check=True)
        target.chmod(0o644)
        assert read_elf(target).soname == name
        copied.append(place)
    return copied


def place_client(bundle: Path) -> None:
    package = ROOT / "client/python/raywalk"
    shutil.copytree(package, bundle / "python/raywalk", ignore=shutil.ignore_patterns("__pycache__"))
    project = tomllib.loads((ROOT / "client/python/pyproject.toml").read_text(encoding="utf-8"))["project"]
    (bundle / "python/requirements.txt").write_text("\n".join(project["dependencies"]) + "\n", encoding="utf-8")
    shutil.copyfile(HERE / "launch.py", bundle / "python/launch.py")
    shutil.copy(HERE / "raywalk", bundle / "bin/raywalk")


def place_scenes(bundle: Path) -> None:
    for manifest in sorted(ROOT.glob("scenes/*/scene.json")):
        target = bundle / "share/raywalk/scenes" / manifest.parent.name
        target.mkdir(parents=True)
        shutil.copyfile(manifest, target / manifest.name)


def place_documents(bundle: Path, libraries: list[Path]) -> None:
    shutil.copyfile(HERE / "README.md", bundle / "README.md")
    shutil.copyfile(ROOT / "LICENSE", bundle / "LICENSE")
    folder = bundle / "share/doc/licences"
    licences.collect((path for path in libraries if not path.is_relative_to(OPENIMAGEIO)), folder)
    shutil.copyfile(HERE / "cpp-httplib.txt", folder / "cpp-httplib.txt")
    shutil.copyfile(ROOT / "client/web/node_modules/uplot/LICENSE", folder / "uplot.txt")
    for text in sorted((OPENIMAGEIO / "licences").iterdir()):
        shutil.copyfile(text, folder / f"OpenImageIO-{text.name}")


def pack(bundle: Path) -> Path:
    """The archive has one folder in it, root's files, and one time for all, that of the commit. The fastest level of xz
    takes a quarter of the usual time, for 20 % more bytes."""
    archive = bundle.with_name(bundle.name + ".tar.xz")
    seconds = subprocess.run(
        ["git", "-C", ROOT, "log", "-1", "--format=%ct"], capture_output=True, text=True, check=False
    ).stdout.strip()
    owner = ["--owner=0", "--group=0", "--numeric-owner", "--sort=name", f"--mtime=@{seconds or 0}"]
    partial = archive.with_name(archive.name + ".new")
    places = [f"--file={partial}", f"--directory={bundle.parent}", bundle.name]
    subprocess.run(["tar", "--create", "--use-compress-program=xz -1 --threads=0", *owner, *places], check=True)
    partial.replace(archive)
    return archive


def megabytes(size_bytes: int) -> str:
    return f"{size_bytes / 1e6:.1f} MB"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--with-tests", action="store_true", help="test programs too, into tests/")
    with_tests = parser.parse_args().with_tests
    bundle = ROOT / "out/bundle" / f"raywalk-{version()}-linux-x86_64"
    shutil.rmtree(bundle, ignore_errors=True)
    bundle.mkdir(parents=True)

    if with_tests:
        build_tests()
    for program in ["raywalkd", *(TEST_PROGRAMS if with_tests else ())]:
        install(program, bundle)
    libraries = place_libraries(bundle, [*bundle.glob("bin/*"), *bundle.glob("tests/*")])
    place_client(bundle)
    place_scenes(bundle)
    place_documents(bundle, libraries)

    found = offences(bundle)
    for offence in found:
        print(f"bundle: {offence}", file=sys.stderr)
    if any("GLIBC_" in offence for offence in found):
        print(
            f"bundle: build it where glibc is {'.'.join(map(str, NEWEST_GLIBC))} or older, as on Debian 12",
            file=sys.stderr,
        )
    if found:
        return 1
    for path in sorted(bundle.rglob("*")):
        if path.is_file() and path.stat().st_size > 500_000:
            print(f"  {megabytes(path.stat().st_size):>9}  {path.relative_to(bundle)}")
    archive = pack(bundle)
    unpacked = sum(path.stat().st_size for path in bundle.rglob("*") if path.is_file())
    print(f"bundle: {bundle.relative_to(ROOT)}: {megabytes(unpacked)}")
    print(f"bundle: {archive.relative_to(ROOT)}: {megabytes(archive.stat().st_size)} of {megabytes(LIMIT_BYTES)}")
    if archive.stat().st_size > LIMIT_BYTES:
        print("bundle: the archive is too large", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
