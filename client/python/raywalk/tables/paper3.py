"""Table 3 of the study: registers and occupancy of its kernels on a GTX 280, and what a register cap did to their
times. They are of the kernels, not of a scene, so they stand here and not in a manifest. It gives neither shared nor
local memory."""

from dataclasses import dataclass, field

from raywalk.tables.paper import TECHNIQUES

SOURCE = (
    "Zlatuska and Havran, Ray Tracing on a GPU with CUDA - Comparative Study of Three Algorithms, WSCG 2010, Table 3 "
    "(GeForce GTX 280, 1024x1024, primary, shadow and secondary rays)"
)
MODE = "whitted"  # the rays behind its times


@dataclass(frozen=True)
class PaperKernel:
    """One row; `cap` is 0 where the compiler chose. Times of a frame in ms by the names of our scenes."""

    cap: int
    registers: int
    occupancy: float
    frame_ms: dict[str, float] = field(default_factory=dict)


def rows(free: tuple[float, ...], capped: tuple[float, ...]) -> list[PaperKernel]:
    """Registers, occupancy in %, and times for robots, kitchen and museum; the cap is the second row's registers."""
    made = []
    for cap, figures in ((0, free), (int(capped[0]), capped)):
        registers, percent, *times = figures
        by_scene = dict(zip(("robots", "kitchen", "museum"), times, strict=True))
        made.append(PaperKernel(cap, int(registers), percent / 100, by_scene))
    return made


# As printed. The first row of kdt-2 has the times of kdt-3's, against which its gain is told.
KERNELS = {
    "grid": rows((59, 25, 430.7, 907.7, 266.2), (32, 50, 350.2, 704.8, 220.5)),
    "kdt-3": rows((56, 25, 110.7, 429.5, 240.5), (32, 25, 129.0, 496.2, 278.2)),
    "kdt-2": rows((56, 25, 110.7, 429.5, 240.5), (40, 37.5, 96.0, 372.2, 211.4)),
    "bvh": rows((53, 25, 151.0, 1064.8, 274.7), (32, 50, 129.9, 762.4, 214.4)),
}


def paper_kernel(technique: str, cap: int) -> PaperKernel | None:
    """The paper's row for the wire name of a technique: the one without a cap, or the one with this cap."""
    kernels = KERNELS.get(TECHNIQUES.get(technique, ""), [])
    return next((kernel for kernel in kernels if kernel.cap == cap), None)
