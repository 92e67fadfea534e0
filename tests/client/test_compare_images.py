"""raywalk compare-images: metrics of picture files, ids, and what is refused."""

import json
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from raywalk.image_metrics import compared, mean_ssim, srgb_encoded

PICTURES = Path(__file__).resolve().parents[1] / "support/pictures"
ROOM, NEXT = PICTURES / "room.png", PICTURES / "room_next.png"


def saved(path: Path, array: np.ndarray) -> Path:
    np.save(path, array.astype(np.float32))
    return path


def ids(*values: int) -> np.ndarray:
    return np.array(values, np.float32).reshape(1, -1, 1)


def test_figures_are_those_that_the_daemon_is_tested_with(raywalk) -> None:
    """tests/server/metrics_test.cpp compares the daemon's metrics of the same files with metrics.json."""
    got = raywalk("compare-images", ROOM, NEXT, "--json")
    assert got.exit_code == 0, got.stderr
    figures = json.loads(got.stdout)
    expected = json.loads((PICTURES / "metrics.json").read_text())
    assert figures == pytest.approx(expected | {"changed_pixels_ppm": 1e6 * 2779 / 19200}, abs=1e-6)


def test_a_table_for_people_and_a_heat_map(raywalk, tmp_path) -> None:
    got = raywalk("compare-images", ROOM, NEXT, "--heat", tmp_path / "new/heat.png")
    assert got.exit_code == 0, got.stderr
    lines = dict(line.split() for line in got.stdout.splitlines() if line.strip())
    assert (lines["changed_pixels"], lines["flip_max"]) == ("2779", "0.522824")
    with Image.open(tmp_path / "new/heat.png") as heat:
        assert heat.size == (160, 120)
        colours = {colour for _, colour in heat.getcolors(160 * 120)}
    assert (13, 8, 51) in colours  # no error
    assert len(colours) > 50


def test_identical_files(raywalk) -> None:
    figures = json.loads(raywalk("compare-images", ROOM, ROOM, "--json").stdout)
    assert figures == {"pixels": 19200, "changed_pixels": 0, "rmse": 0, "psnr_db": None, "ssim": 1} | {
        "flip_mean": 0,
        "flip_p99": 0,
        "flip_max": 0,
        "changed_pixels_ppm": 0,
    }
    assert "identical" in raywalk("compare-images", ROOM, ROOM).stdout


def test_frames_of_floats_are_compared_as_they_are_shown(raywalk, tmp_path) -> None:
    shown = np.asarray(Image.open(ROOM).convert("RGB"), np.float64) / 255
    linear = np.where(shown <= 0.04045, shown / 12.92, ((shown + 0.055) / 1.055) ** 2.4)
    linear[linear == 1] = 50
    figures = json.loads(raywalk("compare-images", ROOM, saved(tmp_path / "a.npy", linear), "--json").stdout)
    assert figures["changed_pixels"] == 0
    assert figures["rmse"] < 1e-6


def test_ids(raywalk, tmp_path) -> None:
    a, b = saved(tmp_path / "a.npy", ids(3, 4, -1, 9)), saved(tmp_path / "b.npy", ids(3, 5, -1, -1))
    got = raywalk("compare-images", a, b, "--output", "id", "--json", "--heat", tmp_path / "heat.png")
    assert json.loads(got.stdout) == {"pixels": 4, "changed_ids": 2, "changed_ids_ppm": 5e5}
    with Image.open(tmp_path / "heat.png") as heat:
        assert heat.getpixel((0, 0)) != heat.getpixel((1, 0)) == heat.getpixel((3, 0))


def test_different_sizes(raywalk, tmp_path) -> None:
    Image.new("RGB", (160, 100)).save(tmp_path / "low.png")
    got = raywalk("compare-images", ROOM, tmp_path / "low.png")
    assert got.exit_code == 1
    assert got.stderr == f"raywalk: {ROOM} has 160x120 pixels, {tmp_path / 'low.png'} has 160x100\n"
    a, b = saved(tmp_path / "a.npy", ids(1, 2)), saved(tmp_path / "b.npy", ids(1, 2, 3))
    assert raywalk("compare-images", a, b, "--output", "id").exit_code == 1


@pytest.mark.parametrize(
    ("name", "content", "said"),
    [
        ("none.png", None, "none.png: No such file"),
        ("none.npy", None, "none.npy: No such file"),
        ("text.png", b"no image", "text.png: no image of a known format"),
        ("cut.png", ROOM.read_bytes()[:5000], "cut.png: "),
        ("text.npy", b"no array", "text.npy: no array of numpy"),
        ("empty.npy", b"", "empty.npy: no array of numpy"),
        ("a.exr", b"", "a.exr: EXR is not read"),
        ("a.raw", b"", "a.raw: a raw frame does not say its size"),
    ],
)
def test_unreadable_files(raywalk, tmp_path, name, content, said) -> None:
    if content is not None:
        (tmp_path / name).write_bytes(content)
    got = raywalk("compare-images", ROOM, tmp_path / name)
    assert got.exit_code == 1
    assert got.stdout == ""
    assert said in got.stderr
    assert got.stderr.startswith("raywalk: ")
    assert got.stderr.count("\n") == 1


def test_files_of_another_kind(raywalk, tmp_path) -> None:
    depth = saved(tmp_path / "depth.npy", np.full((4, 5, 1), 2.5))
    flat = saved(tmp_path / "flat.npy", np.zeros((4, 5)))
    nothing = saved(tmp_path / "nothing.npy", np.zeros((0, 5, 3)))
    Image.new("I;16", (5, 4)).save(tmp_path / "deep.png")
    for path, said in (
        (depth, "no frame of colours"),
        (flat, "no frame of colours"),
        (nothing, "no array of numbers"),
        (tmp_path / "deep.png", "8 bits a channel"),
    ):
        assert said in raywalk("compare-images", path, path).stderr
    for path, said in ((depth, "no ids"), (flat, "no frame of ids"), (ROOM, "ids are read from .npy")):
        assert said in raywalk("compare-images", path, path, "--output", "id").stderr
    assert raywalk("compare-images", ROOM, NEXT, "--heat", tmp_path / "heat.jpg").exit_code == 2


def test_black_against_white() -> None:
    black, white = np.zeros((9, 4, 3), np.float32), np.ones((9, 4, 3), np.float32)
    metrics, errors = compared(black, white)
    assert (metrics.rmse, metrics.psnr_db, metrics.changed_pixels_ppm) == (1, 0, 1e6)
    assert metrics.ssim == pytest.approx(1e-4 / (1 + 1e-4))
    assert errors.shape == (9, 4)
    assert metrics.flip_mean == pytest.approx(0.96739, abs=1e-4)  # as tests/server/metrics_test.cpp


def test_a_single_pixel_is_a_picture() -> None:
    grey = np.full((1, 1, 3), 0.5, np.float32)
    assert mean_ssim(grey, grey) == 1
    assert 0 < compared(grey, grey + 0.1)[0].flip_max < 1


def test_what_is_no_number_is_shown_black() -> None:
    assert srgb_encoded(np.array([np.nan, np.inf, -np.inf, -1, 0.0031308])).tolist() == pytest.approx(
        [0, 1, 0, 0, 0.04045], abs=1e-5
    )
