"""The line that begins every table: device, threads, commit, date and the commands that measure this again."""

from collections.abc import Sequence

from raywalk.models import BenchmarkResult, BenchmarkSpec, Machine
from raywalk.techniques import STANDARD


def techniques_of(spec: BenchmarkSpec) -> str:
    """Techniques as the command line takes them."""
    return ",".join(f"{technique.structure}/{technique.traversal}" for technique in spec.techniques or [])


def command_of(spec: BenchmarkSpec) -> str:
    """The command that runs this benchmark again; the standard techniques need no naming."""
    words = ["raywalk bench", spec.scene, f"--frames {spec.frames}", f"--size {spec.width}x{spec.height}"]
    words.append(f"--modes {','.join(spec.modes or [])}")
    if spec.techniques and set(techniques_of(spec).split(",")) != set(STANDARD):
        words.append(f"--techniques {techniques_of(spec)}")
    if spec.depth != 2:
        words.append(f"--depth {spec.depth}")
    words += [f"--repeats {spec.repeats}", f"--warmup {spec.warmup}"]
    if spec.error_frames not in (None, 4):
        words.append(f"--error-frames {spec.error_frames}")
    if spec.time_limit_s not in (None, 3600):
        words.append(f"--time-limit {spec.time_limit_s:g}")
    return " ".join(words)


def machine_line(results: Sequence[BenchmarkResult]) -> str:
    """One clause a machine (results of several are said to be), then dates and every command."""
    machines = {result.machine.fingerprint: result.machine for result in results}
    devices = "; ".join(describe(machine) for machine in machines.values())
    dates = sorted({result.created_at[:10] for result in results})
    date = dates[0] if len(dates) == 1 else f"{dates[0]} to {dates[-1]}"
    commands = dict.fromkeys(f"`{command_of(result.spec)}`" for result in results)
    mixed = "DIFFERENT MACHINES, times are not comparable: " if len(machines) > 1 else ""
    return f"{mixed}{devices}, {date}, {', '.join(commands)}"


def describe(machine: Machine) -> str:
    threads = f"{machine.threads} thread{'s' if machine.threads != 1 else ''}"
    return f"{machine.device}, {threads}, commit {machine.git_commit[:12]}"
