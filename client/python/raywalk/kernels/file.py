"""The committed table of kernels: CSV, one line an entry point, under a line that names the compiler."""

import csv
from pathlib import Path

from pydantic import ValidationError

from raywalk.errors import RaywalkError
from raywalk.kernels.listing import Kernel, Listing
from raywalk.places import checkout

FIRST = "# Compiled by NVRTC "
NAMES = {"registers_cap": "cap", "spill_store_bytes": "spill_stores", "spill_load_bytes": "spill_loads"}
NAMES |= {"stack_bytes": "stack", "shared_bytes": "shared"}
COLUMNS = [NAMES.get(field, field) for field in Kernel.model_fields]
FIELDS = dict(zip(COLUMNS, Kernel.model_fields, strict=True))


def committed_file() -> Path:
    root = checkout()
    if root is None:
        raise RaywalkError("the table of kernels was not found; run this inside the checkout of Raywalk")
    return root / "tests" / "gpu" / "kernels.csv"


def write_file(path: Path, listing: Listing) -> None:
    with path.open("w", newline="") as file:
        file.write(f"{FIRST}{listing.nvrtc}; renewed by `raywalk kernels --write`.\n")
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        writer.writerows(kernel.model_dump().values() for kernel in listing.kernels)


def read_file(path: Path) -> Listing:
    """Throws RaywalkError for what is no such table, with its line."""
    try:
        first, *lines = path.read_text().splitlines()
    except (OSError, ValueError) as error:
        why = getattr(error, "strerror", None) or "it is no text with lines"
        raise RaywalkError(f"{path} cannot be read: {why}; raywalk kernels --write makes it") from error
    rows = list(csv.reader(lines))
    if not first.startswith(FIRST) or not rows or rows[0] != COLUMNS:
        raise RaywalkError(f"{path} is no table of kernels; raywalk kernels --write makes it")
    kernels = [kernel_of(path, number, row) for number, row in enumerate(rows[1:], start=3)]
    return Listing(nvrtc=first.removeprefix(FIRST).partition(";")[0], kernels=kernels)


def kernel_of(path: Path, number: int, row: list[str]) -> Kernel:
    if len(row) != len(COLUMNS):
        raise RaywalkError(f"{path}:{number}: {len(row)} values, not {len(COLUMNS)}")
    cells = {FIELDS[column]: value for column, value in zip(COLUMNS, row, strict=True)}
    try:
        return Kernel.model_validate(cells | {"mode": cells["mode"] or None})
    except ValidationError as error:
        first = error.errors()[0]
        raise RaywalkError(f"{path}:{number}: {'/'.join(map(str, first['loc']))}: {first['msg']}") from error
