"""The benchmarks behind Table 3: every traversal of a GPU with every register cap."""

import math
from collections.abc import Sequence

from raywalk.client import Client
from raywalk.errors import RaywalkError
from raywalk.kernel_options import REGISTERS, Options, offered, spread_over, with_options
from raywalk.models import BenchmarkSpec, Kind, System, Technique
from raywalk.techniques import measured

# 0 is the compiler's choice, 32 and 40 are the paper's; the others are where a further block of 128 threads fits into
# a multiprocessor of 65,536 registers, up to a quarter of its threads.
CAPS = (0, 32, 40, 48, 64, 80, 96, 128)
SCENE = "bunny"
MODES = "primary"
BATCH = 0  # it is about kernels: no throughput
ERROR_FRAMES = 1
MOST_TECHNIQUES = 64  # of one job, as the contract says


def caps_of(text: str | None) -> list[int]:
    """Register caps separated by commas, each once; throws RaywalkError for what is no cap."""
    if text is None:
        return list(CAPS)
    words = [word.strip() for word in text.split(",") if word.strip()]
    if not words or not all(word.isascii() and word.isdigit() for word in words):
        raise RaywalkError(f"{text!r} are no register caps like 0,32,64 (0: the compiler's choice)")
    caps = list(dict.fromkeys(int(word) for word in words))
    if len(caps) > MOST_TECHNIQUES:
        raise RaywalkError(f"{len(caps)} register caps are more than the {MOST_TECHNIQUES} of one job")
    return caps


def require_gpu(system: System) -> None:
    """Throws RaywalkError with the reason why there is no GPU."""
    device = system.device
    if device.kind == "cuda":
        return
    why = device.no_cuda or f"the daemon was started with --device {device.requested}"
    raise RaywalkError(f"Table 3 is about GPU kernels, and the device is a CPU ({device.name}): {why}")


def sweep_specs(client: Client, spec: BenchmarkSpec, caps: Sequence[int], kernel: Options) -> list[BenchmarkSpec]:
    """One job, or as many as techniques and caps need; a technique is never split, so that its caps are measured in
    turns. `spec` names the techniques, or means all; `kernel` holds further kernel options. Throws RaywalkError without
    a GPU or for a cap out of range."""
    require_gpu(client.get_system())
    kinds = client.get_kinds()
    named = spec.techniques or [one for one in measured(kinds) if REGISTERS in offered(kinds, one)]
    jobs: list[list[Technique]] = []
    for group in (with_caps(kinds, technique, caps) for technique in spread_over(kinds, named, kernel)):
        if not jobs or len(jobs[-1]) + len(group) > MOST_TECHNIQUES:
            jobs.append([])
        jobs[-1] += group
    if not jobs:
        raise RaywalkError("this daemon has no traversal with a register cap: it is older than Table 3")
    return [spec.model_copy(update={"techniques": techniques}) for techniques in jobs]


def with_caps(kinds: Sequence[Kind], technique: Technique, caps: Sequence[int]) -> list[Technique]:
    name = f"{technique.structure}/{technique.traversal}"
    option = offered(kinds, technique).get(REGISTERS)
    if option is None:
        raise RaywalkError(f"{name} is no technique of this daemon that has a register cap")
    least, most = option.minimum or 0, option.maximum or math.inf
    if bad := [cap for cap in caps if not least <= cap <= most]:
        raise RaywalkError(f"a register cap of {bad[0]} is out of range: {name} takes {least:g} to {most:g}")
    return [with_options(technique, {REGISTERS: float(cap)}) for cap in caps]
