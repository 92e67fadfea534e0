"""The line that begins every table: device, threads, commit, date and the commands that measure this again."""

from collections.abc import Sequence

from raywalk import sweep
from raywalk.kernel_options import common_options, options_text, swept_caps
from raywalk.models import BenchmarkResult, BenchmarkSpec, Machine
from raywalk.techniques import STANDARD


def techniques_of(spec: BenchmarkSpec) -> list[str]:
    """Techniques as the command line names them, each once."""
    return list(dict.fromkeys(f"{one.structure}/{one.traversal}" for one in spec.techniques or []))


def tiers_of(spec: BenchmarkSpec) -> list[str]:
    """Each once; results of older daemons are strict."""
    return list(dict.fromkeys(one.tier or "strict" for one in spec.techniques or [])) or ["strict"]


def command_of(result: BenchmarkResult) -> str:
    """The command that runs this benchmark again; the standard techniques need no naming."""
    spec = result.spec
    caps, kernel = swept_caps(spec), common_options(result)
    words = ["raywalk bench", spec.scene, *(["--table 3"] if caps else [])]
    words += [f"--frames {spec.frames}", f"--size {spec.width}x{spec.height}", f"--modes {','.join(spec.modes or [])}"]
    if spec.techniques and (caps or set(techniques_of(spec)) != set(STANDARD)):
        words.append(f"--techniques {','.join(techniques_of(spec))}")
    if caps:
        words.append(f"--registers {','.join(str(cap) for cap in caps)}")
    if tiers_of(spec) != ["strict"]:
        words.append(f"--tier {','.join(tiers_of(spec))}")
    if kernel:
        words.append(f"--kernel {options_text(kernel)}")
    if spec.depth != 2:
        words.append(f"--depth {spec.depth}")
    words += [f"--repeats {spec.repeats}", f"--warmup {spec.warmup}"]
    compared, batch = (sweep.ERROR_FRAMES, sweep.BATCH) if caps else (4, 16)
    if spec.error_frames not in (None, compared):
        words.append(f"--error-frames {spec.error_frames}")
    if spec.batch not in (None, batch):
        words.append(f"--batch {spec.batch}")
    if spec.time_limit_s not in (None, 3600):
        words.append(f"--time-limit {spec.time_limit_s:g}")
    own = "" if kernel is not None else " (and kernel options for each technique, which only a specification can give)"
    return " ".join(words) + own


def machine_line(results: Sequence[BenchmarkResult]) -> str:
    """One clause a machine (results of several are said to be), then dates and every command."""
    machines = {result.machine.fingerprint: result.machine for result in results}
    devices = "; ".join(describe(machine) for machine in machines.values())
    dates = sorted({result.created_at[:10] for result in results})
    date = dates[0] if len(dates) == 1 else f"{dates[0]} to {dates[-1]}"
    commands = dict.fromkeys(f"`{command_of(result)}`" for result in results)
    mixed = "DIFFERENT MACHINES, times are not comparable: " if len(machines) > 1 else ""
    return f"{mixed}{devices}, {date}, {', '.join(commands)}"


def describe(machine: Machine) -> str:
    """With its threads, or the details of a GPU."""
    details = [f"{name} {value}" for name, value in sorted((machine.device_details or {}).items())]
    facts = details or [f"{machine.threads} thread{'s' if machine.threads != 1 else ''}"]
    return ", ".join([machine.device, *facts, f"commit {machine.git_commit[:12]}"])
