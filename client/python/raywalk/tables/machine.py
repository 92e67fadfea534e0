"""The line that begins every table: device, threads, commit, date and the command that measures this again."""

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
    return " ".join(words)


def machine_line(results: Sequence[BenchmarkResult]) -> str:
    """One clause a machine (results of several are said to be), then dates and the command of the first."""
    first = results[0]
    machines = {result.machine.fingerprint: result.machine for result in results}
    devices = "; ".join(describe(machine) for machine in machines.values())
    dates = sorted({result.created_at[:10] for result in results})
    date = dates[0] if len(dates) == 1 else f"{dates[0]} to {dates[-1]}"
    more = f" (and {len(results) - 1} more)" if len(results) > 1 else ""
    mixed = "DIFFERENT MACHINES, times are not comparable: " if len(machines) > 1 else ""
    return f"{mixed}{devices}, {date}, `{command_of(first.spec)}`{more}"


def describe(machine: Machine) -> str:
    threads = f"{machine.threads} thread{'s' if machine.threads != 1 else ''}"
    return f"{machine.device}, {threads}, commit {machine.git_commit[:12]}"
