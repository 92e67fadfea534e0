"""How different two pictures are, in the figures that a benchmark gives of its images."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Pixels = NDArray[np.float32]

SSIM_RADIUS, SSIM_SIGMA = 5, 1.5
SSIM_C1, SSIM_C2 = 0.01**2, 0.03**2
LUMA = (0.2126, 0.7152, 0.0722)  # Rec. 709


@dataclass(frozen=True)
class ImageMetrics:
    """Of sRGB values in 0..1; `psnr_db` is None for identical pictures."""

    pixels: int
    changed_pixels: int  # with another 8-bit value in some channel
    rmse: float
    psnr_db: float | None
    ssim: float
    flip_mean: float
    flip_p99: float
    flip_max: float

    @property
    def changed_pixels_ppm(self) -> float:
        return 1e6 * self.changed_pixels / self.pixels


def srgb_encoded(linear: NDArray) -> Pixels:
    """Linear values as they are shown: clipped to 0..1, NaN as 0."""
    values = np.clip(np.nan_to_num(linear.astype(np.float64), nan=0.0), 0, 1)
    return np.where(values <= 0.0031308, 12.92 * values, 1.055 * values ** (1 / 2.4) - 0.055).astype(np.float32)


def compared(reference: Pixels, image: Pixels) -> tuple[ImageMetrics, Pixels]:
    """Metrics and the FLIP error (h, w) of two pictures (h, w, 3) of the same size, as sRGB values in 0..1."""
    height, width, _ = image.shape
    rmse = float(np.sqrt(np.mean((image.astype(np.float64) - reference) ** 2)))
    flip = flip_errors(reference, image)
    metrics = ImageMetrics(
        pixels=width * height,
        changed_pixels=int(np.any(eight_bit(reference) != eight_bit(image), axis=2).sum()),
        rmse=rmse,
        psnr_db=float(-20 * np.log10(rmse)) if rmse else None,
        ssim=mean_ssim(reference, image),
        flip_mean=float(np.mean(flip, dtype=np.float64)),
        flip_p99=float(np.percentile(flip, 99, method="inverted_cdf")),
        flip_max=float(flip.max()),
    )
    return metrics, flip


def eight_bit(values: Pixels) -> NDArray[np.uint8]:
    return np.floor(255 * values + 0.5).astype(np.uint8)


def flip_errors(reference: Pixels, image: Pixels) -> Pixels:
    """LDR-FLIP at 67 pixels a degree, by its authors' implementation."""
    from flip_evaluator import evaluate  # a compiled module: only who compares pictures needs it

    errors, _, _ = evaluate(reference, image, "LDR", applyMagma=False, computeMeanError=False)
    return errors[..., 0]


def mean_ssim(reference: Pixels, image: Pixels) -> float:
    """SSIM after Wang et al. (2004) of the luma; beyond the borders the outermost pixels go on."""
    x, y = (np.asarray(picture, np.float64) @ np.array(LUMA) for picture in (reference, image))
    mean_x, mean_y = smoothed(x), smoothed(y)
    variances = smoothed(x * x) - mean_x**2 + smoothed(y * y) - mean_y**2
    covariance = smoothed(x * y) - mean_x * mean_y
    similar = (2 * mean_x * mean_y + SSIM_C1) * (2 * covariance + SSIM_C2)
    return float(np.mean(similar / ((mean_x**2 + mean_y**2 + SSIM_C1) * (variances + SSIM_C2))))


def smoothed(plane: NDArray[np.float64]) -> NDArray[np.float64]:
    offsets = np.arange(-SSIM_RADIUS, SSIM_RADIUS + 1)
    weights = np.exp(-(offsets**2) / (2 * SSIM_SIGMA**2))
    weights /= weights.sum()
    for axis in (0, 1):
        length = plane.shape[axis]
        places = [np.clip(np.arange(length) + offset, 0, length - 1) for offset in offsets]
        plane = sum(weight * np.take(plane, place, axis) for weight, place in zip(weights, places, strict=True))
    return plane
