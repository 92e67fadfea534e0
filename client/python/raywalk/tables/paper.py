"""The study's figures for a scene, as the manifest's `paper` block has them."""

from typing import Any

from raywalk.models import PaperFigures

PAPER_DEVICE = "GTX 280"
PAPER_SIZE = "1024x1024"
PAPER_FRAMES = 400
TECHNIQUES = {
    "grid/dda": "grid",
    "kdtree/short-stack-3": "kdt-3",
    "kdtree/short-stack-2": "kdt-2",
    "bvh/packet": "bvh",
}
FIGURES = {
    "references_per_triangle": "references_per_triangle",
    "megabytes": "size_mb",
    "steps": "steps_per_ray",
    "tests": "tests_per_ray",
}


class Paper:
    """Reads the block; a figure that it lacks is None."""

    def __init__(self, block: PaperFigures | None):
        self._block: dict[str, Any] = block.model_dump() if block else {}

    @property
    def has_structures(self) -> bool:
        return bool(self._at("table1"))

    @property
    def has_times(self) -> bool:
        return bool(self._at("table2"))

    @property
    def triangles(self) -> int | None:
        return self._at("table1", "triangles")

    @property
    def lights(self) -> int | None:
        return self._at("table1", "lights")

    def structure(self, kind: str, figure: str) -> Any:
        """A figure of Table 1: size (cells along x y z), references_per_triangle, leaves, megabytes, steps or tests."""
        if figure == "size":
            return self._at("table1", "grid_cells")
        if figure == "leaves":
            thousands = self._at("table1", kind, "leaves_thousands")
            return None if thousands is None else 1000 * thousands
        return self._at("table1", kind, FIGURES[figure])

    def frame_ms(self, mode: str, technique: str) -> float | None:
        """A time of Table 2 by the wire name of the technique."""
        return self._at("table2", f"{mode}_ms", TECHNIQUES.get(technique, technique))

    def _at(self, *path: str) -> Any:
        value: Any = self._block
        for step in path:
            value = value.get(step) if isinstance(value, dict) else None
        return value
