"""The include rule: who may include whom, and which library is known where.

Every C++ file belongs to a unit. An arrow that is not in the tables below is a violation. `main` stands for the files
directly in server/, `sweep` for those in server/accuracy/sweep/.
"""

import re
from pathlib import Path

from tests.project.sources import cpp_files

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')

# Files directly in kernels/ are `math` unless they are named here; each row includes from itself and those above.
KERNEL_ROWS = ["platform", "math", "triangle", "query"]
KERNEL_UNITS = {
    "platform.h": "platform",
    "scene_view.h": "triangle",
    "query.h": "query",
    "lanes.h": "query",
    "tracer.h": "query",
    "frame_request.h": "shade",
}
KERNEL_TOP = re.compile(r"(frame|frame_.*|rays|rays_.*|entry|entry_.*)\.(h|cpp|cu)")
# The two lists of all structures.
ACCEL_TABLES = {"kernels/accel/kinds.cpp", "kernels/accel/traversals.h"}

# Each row of the server includes from the rows below it; inside a row only what PEERS says.
SERVER_ROWS = [
    {"main"},
    {"http", "api"},
    {"jobs"},
    {"sweep"},
    {"accuracy", "bench", "catalog", "store"},
    {"device", "scene", "image"},
    {"system"},
]
# An image is made of the pixels of a frame, or becomes a scene's texture; a benchmark runs on catalogued scenes and
# structures, and the oracle judges its hits.
PEERS = {("api", "http"), ("image", "device"), ("image", "scene"), ("bench", "catalog"), ("bench", "accuracy")}

# First letters of an angle include -> the units (or files) that may know the library.
LIBRARIES = {
    "nlohmann/": ("server/api", "server/http", "server/scene/json_node.h", "server/scene/formats/gltf"),
    "tiny_gltf": ("server/scene/formats/gltf/tinygltf.h",),
    "valijson/": ("server/api", "server/http"),
    "httplib": ("server/http",),
    "CLI/": ("server/main", "scenes/generate_main.cpp"),
    "prometheus/": ("server/http", "server/api"),
    "OpenImageIO/": ("server/image",),
    "OpenEXR/": ("server/image",),
    "glm/": ("server/scene",),
    "embree": ("server/device",),
    "cuda": ("server/device/cuda",),
    "nvrtc": ("server/device/cuda",),
    "sqlite3": ("server/store",),
    "gmp": ("server/accuracy/oracle",),
}


def unit_of(path: str) -> str | None:
    """The unit of a file, from its path relative to the root; None for one that the architecture has no place for."""
    parts = path.split("/")
    if parts[0] == "tests":
        return "tests"
    if parts[0] == "scenes":
        return "scenes"
    if parts[0] == "server":
        if len(parts) == 2:
            return "server/main"
        if parts[1:3] == ["accuracy", "sweep"]:
            return "server/sweep"
        known = set().union(*SERVER_ROWS) - {"main"}
        return f"server/{parts[1]}" if parts[1] in known else None
    if parts[0] != "kernels":
        return None
    if len(parts) == 2:
        name = parts[1]
        return "top" if name not in KERNEL_UNITS and KERNEL_TOP.fullmatch(name) else KERNEL_UNITS.get(name, "math")
    if path in ACCEL_TABLES:
        return "accel-tables"
    if parts[1] == "gpu":
        return "top"  # entry points
    if parts[1] == "accel":
        return f"accel/{parts[2]}" if len(parts) > 3 else "accel"
    return parts[1] if parts[1] in ("triangle", "shade") else None


def kernel_may(unit: str, target: str) -> bool:
    if unit == target or unit == "top":
        return True
    if unit in KERNEL_ROWS:
        return target in KERNEL_ROWS[: KERNEL_ROWS.index(unit)]
    if unit == "accel-tables":
        return target != "shade"
    if target in KERNEL_ROWS:
        return True
    return unit.startswith("accel/") and target == "accel"


def server_may(unit: str, target: str) -> bool:
    source, sink = unit.removeprefix("server/"), target.removeprefix("server/")
    row = next(i for i, names in enumerate(SERVER_ROWS) if source in names)
    below = set().union(*SERVER_ROWS[row + 1 :])
    return source == sink or sink in below or (source, sink) in PEERS


def may_include(unit: str, target: str) -> bool:
    """Whether a file of `unit` may include one of `target`, both as unit_of names them."""
    target_is_kernel = not target.startswith("server/") and target not in ("tests", "scenes")
    if unit == "tests":
        return True
    if unit == "scenes":
        return target_is_kernel or target in ("scenes", "server/scene")
    if unit == "server/scene" and target == "scenes":
        return True  # the catalogue calls the generators
    if unit.startswith("server/"):
        return target_is_kernel or (target.startswith("server/") and server_may(unit, target))
    return target_is_kernel and kernel_may(unit, target)


def library_violation(path: str, unit: str, name: str) -> str | None:
    for prefix, homes in LIBRARIES.items():
        inside = any(unit == home or path == home or path.startswith(home + "/") for home in homes)
        if name.startswith(prefix) and unit != "tests" and not inside:
            return f"<{name}> is for {', '.join(homes)} only"
    return None


def shared_with_gpu(path: str, text: str) -> bool:
    """Headers of kernels/ are compiled by NVRTC too, unless their first lines say "Host only"."""
    head = "\n".join(text.split("\n", 5)[:5])
    return path.startswith("kernels/") and not path.endswith(".cpp") and "Host only" not in head


def without_host_parts(text: str) -> list[str]:
    """The lines, blank where `#if` keeps them from NVRTC: between `#if(n)def` or `#if` and its `#endif`."""
    lines, depth = [], 0
    for line in text.splitlines():
        opens = re.match(r"\s*#\s*if", line)
        closes = re.match(r"\s*#\s*endif", line)
        depth += bool(opens) - bool(closes)
        lines.append("" if depth > 0 else line)
    return lines


def file_violations(root: Path, path: str) -> list[str]:
    text = (root / path).read_text(encoding="utf-8")
    unit = unit_of(path)
    if unit is None:
        return [f"{path}: no place in the architecture"]
    found = []
    device_lines = without_host_parts(text) if shared_with_gpu(path, text) else []
    for number, line in enumerate(text.splitlines(), start=1):
        match = INCLUDE.match(line)
        if not match:
            continue
        bracket, name = match.groups()
        problem = None
        if bracket == "<":
            problem = library_violation(path, unit, name)
            if problem is None and device_lines and device_lines[number - 1]:
                problem = f"<{name}> in a header that the GPU shares; say 'Host only' or move it"
        elif not name.endswith(".inc"):  # lists that the build writes
            target = unit_of(name)
            if target is None or "/" not in name:
                problem = f'"{name}" is not written from the root, or has no place in the architecture'
            elif not (root / name).is_file():
                problem = f'"{name}" does not exist'
            elif not may_include(unit, target):
                problem = f'{unit} may not include {target} ("{name}")'
        if problem:
            found.append(f"{path}:{number}: {problem}")
    return found


def violations(root: Path) -> list[str]:
    """Every broken arrow below `root`, as "file:line: what"."""
    return [problem for path in cpp_files(root) for problem in file_violations(root, path.as_posix())]
