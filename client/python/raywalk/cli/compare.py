"""raywalk compare-images: how different two pictures are."""

from dataclasses import asdict
from enum import StrEnum
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer
from numpy.typing import NDArray
from PIL import Image
from rich import box
from rich.table import Table

from raywalk.cli.session import print_json, results, writable_file
from raywalk.errors import RaywalkError
from raywalk.heat import heat
from raywalk.image_metrics import compared
from raywalk.picture_files import read_ids, read_picture
from raywalk.progress import messages

Figures = dict[str, Any]


class Output(StrEnum):
    COLOR = "color"
    ID = "id"


def compare_images(
    reference: Annotated[Path, typer.Argument(help="PNG, JPEG, or .npy of `raywalk render`.")],
    image: Annotated[Path, typer.Argument(help="The picture that is compared with it.")],
    output: Annotated[Output, typer.Option(help="What both show: colours, or ids of triangles (.npy).")] = Output.COLOR,
    heat_out: Annotated[
        Path | None, typer.Option("--heat", help="PNG of the FLIP error, blue for 0 to red for 1; of ids: red differ.")
    ] = None,
    json: Annotated[bool, typer.Option("--json", help="For programs.")] = False,
) -> None:
    """RMSE, PSNR, SSIM, FLIP and changed pixels of two images, or changed ids of two frames of ids."""
    if heat_out is not None and heat_out.suffix.lower() != ".png":
        raise typer.BadParameter("--heat takes a name that ends in .png")
    read = read_ids if output == Output.ID else read_picture
    one, other = read(reference), read(image)
    if one.shape != other.shape:
        raise RaywalkError(f"{reference} has {size_text(one)} pixels, {image} has {size_text(other)}")
    figures, errors = (compared_ids if output == Output.ID else compared_pictures)(one, other)
    if heat_out is not None:
        Image.fromarray(heat(errors, 1.0)).save(writable_file(heat_out))
    if json:
        print_json(figures)
    else:
        results().print(table_of(figures))
    if heat_out is not None:
        messages().print(f"wrote {heat_out}")


def size_text(picture: NDArray) -> str:
    return f"{picture.shape[1]}x{picture.shape[0]}"


def compared_pictures(reference: NDArray, image: NDArray) -> tuple[Figures, NDArray]:
    metrics, errors = compared(reference, image)
    return asdict(metrics) | {"changed_pixels_ppm": metrics.changed_pixels_ppm}, errors


def compared_ids(reference: NDArray, image: NDArray) -> tuple[Figures, NDArray]:
    changed = reference != image
    count = int(np.count_nonzero(changed))
    return {"pixels": changed.size, "changed_ids": count, "changed_ids_ppm": 1e6 * count / changed.size}, changed


def table_of(figures: Figures) -> Table:
    table = Table(box=box.SIMPLE, show_header=False)
    table.add_column()
    table.add_column(justify="right")
    for name, figure in figures.items():
        shown = "identical" if figure is None else f"{figure:.6g}" if isinstance(figure, float) else str(figure)
        table.add_row(name, shown)
    return table
