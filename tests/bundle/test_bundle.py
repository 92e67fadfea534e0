"""The bundle as its user meets it: unpacked under another name, with nothing of this machine in the environment.

Making it is a second build of the daemon; with a warm compiler cache that is half a minute, without one minutes.
"""

import io
import os
import re
import signal
import subprocess
import sysconfig
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import httpx2
import pytest
from PIL import Image

ROOT = Path(__file__).resolve().parents[2]
LIMIT_BYTES = 60_000_000
NEWEST_GLIBC = (2, 36)
MAKE_LIMIT_S = 1500.0
START_LIMIT_S = 20.0

pytestmark = pytest.mark.slow


def call(*command: str | Path, environment: dict[str, str] | None = None) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [str(part) for part in command],
        env=environment or {},
        cwd="/",
        capture_output=True,
        text=True,
        timeout=60.0,
        check=False,
    )


@pytest.fixture(scope="module")
def archive() -> Path:
    """What ./run bundle makes of the sources as they are."""
    name, _, number = (os.confstr("CS_GNU_LIBC_VERSION") or "").partition(" ")
    if name != "glibc" or tuple(int(part) for part in number.split(".")[:2]) > NEWEST_GLIBC:
        pytest.skip(f"bundles are made with glibc 2.36 or older, here is {name or 'another C library'} {number}")
    fetched = subprocess.run([ROOT / "docker/bundle/openimageio"], capture_output=True, text=True, check=False)
    if fetched.returncode != 0:
        pytest.skip(f"the OpenImageIO for bundles cannot be fetched: {fetched.stderr.strip().splitlines()[-1:]}")
    made = subprocess.run([ROOT / "run", "bundle"], capture_output=True, text=True, timeout=MAKE_LIMIT_S, check=False)
    assert made.returncode == 0, made.stdout[-2000:] + made.stderr[-4000:]
    named = re.search(r"(out/bundle/raywalk-[0-9.]+-linux-x86_64\.tar\.xz): ", made.stderr)
    assert named, made.stderr
    return ROOT / named[1]


@pytest.fixture(scope="module")
def bundle(archive: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Unpacked, under another name with a space in it."""
    place = tmp_path_factory.mktemp("unpacked")
    subprocess.run(["tar", "-xJf", archive, "-C", place], check=True)
    (unpacked,) = place.iterdir()
    return unpacked.rename(place / "another name")


@contextmanager
def daemon(program: Path, state: Path, environment: dict[str, str]) -> Iterator[str]:
    """The address of a daemon that must stop cleanly."""
    process = subprocess.Popen(
        [program, "--port", "0", "--state", state, "--log-level", "warn", "--die-with-parent"],
        env=environment,
        cwd="/",
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    try:
        assert process.stdout is not None
        line = process.stdout.readline()
        assert line.startswith("listening on "), line + process.communicate()[1]
        yield line.split()[-1]
        process.send_signal(signal.SIGTERM)
        _, errors = process.communicate(timeout=START_LIMIT_S)
        assert process.returncode == 0, errors
    finally:
        if process.poll() is None:
            process.kill()
            process.communicate()


def packages() -> dict[str, str]:
    """An environment whose python3 has the client's packages, but not the client of the checkout."""
    return {"PATH": "/usr/bin:/bin", "RAYWALK_PYTHON": str(ROOT / ".venv/bin/python"), "COLUMNS": "200"}


def test_it_is_small(archive):
    assert archive.stat().st_size <= LIMIT_BYTES


def test_nothing_comes_from_the_system_but_glibc(bundle):
    said = call("/usr/bin/ldd", bundle / "bin/raywalkd")
    assert said.returncode == 0 and "not found" not in said.stdout
    outside = [line.split()[0] for line in said.stdout.splitlines() if str(bundle) not in line]
    glibc = re.compile(r"linux-vdso\.so\.1|lib(c|m|pthread|dl|rt)\.so\.\d|/lib64/ld-linux-x86-64\.so\.2")
    assert [name for name in outside if not glibc.fullmatch(name)] == []


def test_libraries_of_the_environment_do_not_get_in(bundle, tmp_path):
    for library in (bundle / "lib").iterdir():
        (tmp_path / library.name).write_bytes(b"not a library")
    said = call(bundle / "bin/raywalkd", "--version", environment={"LD_LIBRARY_PATH": str(tmp_path)})
    assert (said.returncode, said.stdout.split()[0]) == (0, "raywalkd"), said.stderr


def test_the_daemon_renders_with_an_empty_environment(bundle, tmp_path):
    (tmp_path / "daemon").symlink_to(bundle / "bin/raywalkd")
    with (
        daemon(tmp_path / "daemon", tmp_path / "state", {}) as address,
        httpx2.Client(base_url=address, timeout=60.0) as client,
    ):
        libraries = client.get("/v1/system").json()["machine"]["libraries"]
        assert libraries["OpenImageIO"].startswith("3.")
        assert client.post("/v1/scenes", json={"name": "soup", "triangles": 2000}).status_code in (200, 201)
        built = client.post("/v1/structures", json={"scene": "soup", "kind": "bvh", "options": {}})
        assert built.status_code in (200, 202), built.text
        end = time.monotonic() + START_LIMIT_S
        while (state := client.get("/v1/structures/" + built.json()["id"]).json()["state"]) == "building":
            assert time.monotonic() < end, "the structure is not built"
            time.sleep(0.02)
        assert state == "ready"
        wanted = {"scene": "soup", "structure": "bvh", "traversal": "while-while", "width": 96, "height": 64}
        pictures = []
        for kind in ("image/png", "image/jpeg"):
            answer = client.post("/v1/frames", json=wanted, headers={"Accept": kind})
            assert answer.status_code == 200, answer.text
            assert answer.headers["content-type"] == kind
            pictures.append(Image.open(io.BytesIO(answer.content)).convert("L"))
        for picture in pictures:
            assert picture.size == (96, 64)
            low, high = picture.getextrema()
            assert high - low > 50, "something is to be seen"
        exr = client.post("/v1/frames", json=wanted, headers={"Accept": "image/x-exr"})
        assert exr.status_code == 200 and exr.content[:4] == b"\x76\x2f\x31\x01"


def test_the_client_finds_its_daemon_and_scenes(bundle, tmp_path):
    (tmp_path / "raywalk").symlink_to(bundle / "bin/raywalk")
    said = call(tmp_path / "raywalk", "doctor", environment=packages())
    assert said.returncode == 0, said.stdout + said.stderr
    assert f"daemon program: {bundle}/bin/raywalkd" in said.stdout
    manifests = len(list((bundle / "share/raywalk/scenes").glob("*/scene.json")))
    assert f"catalogue: {manifests} scenes" in said.stdout
    frame = tmp_path / "frame.png"
    rendered = call(tmp_path / "raywalk", "render", "soup", "--size", "64x48", "--out", frame, environment=packages())
    assert rendered.returncode == 0, rendered.stderr
    assert Image.open(frame).size == (64, 48)


def test_the_launcher_names_missing_packages(bundle, tmp_path):
    subprocess.run([ROOT / ".venv/bin/python", "-m", "venv", "--without-pip", tmp_path / "bare"], check=True)
    bare = {"PATH": "/usr/bin:/bin", "RAYWALK_PYTHON": str(tmp_path / "bare/bin/python")}
    said = call(bundle / "bin/raywalk", "doctor", environment=bare)
    assert said.returncode == 1
    assert "has no flip-evaluator, httpx2, numpy, pillow, pydantic, rich, typer" in said.stderr
    assert "python/requirements.txt" in said.stderr
    half = bare | {"PYTHONPATH": sysconfig.get_path("purelib")}
    assert call(bundle / "bin/raywalk", "--version", environment=half).stdout.startswith("raywalk ")
