"""Kernel options of a benchmark: how a technique is named with them, and as the command line takes them."""

from collections.abc import Sequence

from raywalk.errors import RaywalkError
from raywalk.models import BenchmarkResult, BenchmarkSpec, Kind, Option, ResultRow, Technique

REGISTERS = "registers"
Options = dict[str, float | str]


def show(value: float | str) -> str:
    return f"{value:g}" if isinstance(value, (int, float)) else value


def options_text(options: Options) -> str:
    """name=value pairs, separated by commas."""
    return ",".join(f"{name}={show(value)}" for name, value in options.items())


def offered(kinds: Sequence[Kind], technique: Technique) -> dict[str, Option]:
    """The options of a technique's kernel by name."""
    for kind in kinds:
        for traversal in kind.traversals if kind.name == technique.structure else []:
            if traversal.name == technique.traversal:
                return {option.name: option for option in traversal.options or []}
    return {}


def spread_over(kinds: Sequence[Kind], techniques: Sequence[Technique], kernel: Options) -> list[Technique]:
    """Each technique with those of the options that its kernel has. Throws RaywalkError for one that none has."""
    for name in kernel:
        if not any(name in offered(kinds, technique) for technique in techniques):
            known = sorted({option for technique in techniques for option in offered(kinds, technique)})
            what = f"known: {', '.join(known)}" if known else "a CPU has none"
            raise RaywalkError(f"no technique has the kernel option {name}; {what}")
    return [
        with_options(technique, {name: kernel[name] for name in kernel if name in offered(kinds, technique)})
        for technique in techniques
    ]


def with_options(technique: Technique, kernel: Options) -> Technique:
    """The technique with these kernel options beside its own."""
    return technique.model_copy(update={"kernel": (technique.kernel or {}) | kernel}) if kernel else technique


def options_of(row: ResultRow) -> Options:
    """All of the row's kernel; none where it has no choice. Older daemons told those of a GPU alone."""
    return row.kernel_options or (row.kernel.options if row.kernel else {})


def asked(spec: BenchmarkSpec, row: ResultRow) -> Options:
    """The options of a row's kernel that its benchmark named, in order of their names; the rest have their defaults."""
    same = (row.structure, row.traversal)
    techniques = [one for one in spec.techniques or [] if (one.structure, one.traversal) == same]
    named = {name for technique in techniques for name in technique.kernel or {}}
    return {name: value for name, value in sorted(options_of(row).items()) if name in named}


def register_cap(row: ResultRow) -> int:
    """0: the compiler's choice."""
    return int(float(options_of(row).get(REGISTERS, 0)))


def label(spec: BenchmarkSpec, row: ResultRow, without: str = "") -> str:
    """STRUCTURE/TRAVERSAL, and in brackets the options that its benchmark named but `without`."""
    options = {name: value for name, value in asked(spec, row).items() if name != without}
    return f"{row.structure}/{row.traversal}" + (f"[{options_text(options)}]" if options else "")


def swept_caps(spec: BenchmarkSpec) -> list[int] | None:
    """The register caps when every technique comes with each of the same ones, as `--table 3` asks for it; else
    None."""
    caps: dict[str, list[int]] = {}
    for technique in spec.techniques or []:
        cap = (technique.kernel or {}).get(REGISTERS)
        if not isinstance(cap, (int, float)):
            return None
        caps.setdefault(f"{technique.structure}/{technique.traversal}", []).append(int(cap))
    lists = list(caps.values())
    return lists[0] if lists and len(lists[0]) > 1 and all(one == lists[0] for one in lists) else None


def common_options(result: BenchmarkResult) -> Options | None:
    """What --kernel says to ask for this again, a swept cap apart; None when the techniques were asked for different
    options though they have the same."""
    apart = {REGISTERS} if swept_caps(result.spec) else set()
    given = [
        (technique, {name: value for name, value in (technique.kernel or {}).items() if name not in apart})
        for technique in result.spec.techniques or []
    ]
    common = {name: value for _, kernel in given for name, value in kernel.items()}
    has = {(row.structure, row.traversal): set(known) for row in result.rows if (known := options_of(row))}
    for technique, kernel in given:
        names = has.get((technique.structure, technique.traversal), set(kernel))
        if kernel != {name: value for name, value in common.items() if name in names}:
            return None
    return common
