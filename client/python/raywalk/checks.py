"""The checks of `raywalk doctor`."""

import os
import platform
import tempfile
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Literal

from raywalk import nvrtc
from raywalk.client import Client
from raywalk.errors import RaywalkError
from raywalk.models import System
from raywalk.places import daemon_program, data_dir
from raywalk.techniques import STANDARD

PACKAGES = ("httpx2", "numpy", "pillow", "pydantic", "rich", "typer")


@dataclass(frozen=True)
class Finding:
    """One line of the report; `advice` says what to do."""

    state: Literal["ok", "warn", "fail"]
    what: str
    detail: str
    advice: str = ""


def local_findings(needs_daemon: bool) -> list[Finding]:
    """What can be seen without a daemon."""
    findings = [python(), packages(), scene_data(), state()]
    return [program(), *findings] if needs_daemon else findings


def program() -> Finding:
    try:
        return Finding("ok", "daemon program", str(daemon_program()))
    except RaywalkError as error:
        return Finding("fail", "daemon program", str(error), "./run build")


def python() -> Finding:
    return Finding("ok", "Python", platform.python_version())


def packages() -> Finding:
    found, missing = [], []
    for name in PACKAGES:
        try:
            found.append(f"{name} {version(name)}")
        except PackageNotFoundError:
            missing.append(name)
    if missing:
        return Finding("fail", "Python packages", f"missing: {', '.join(missing)}", "./run setup")
    return Finding("ok", "Python packages", ", ".join(found))


def scene_data() -> Finding:
    try:
        folder = data_dir()
    except RaywalkError as error:
        return Finding("warn", "scene data", str(error), "set RAYWALK_SCENE_DATA")
    names = sorted(path.name for path in folder.iterdir() if path.is_dir()) if folder.is_dir() else []
    if names:
        return Finding("ok", "scene data", f"{folder}: {', '.join(names)}")
    return Finding(
        "warn", "scene data", f"{folder} holds none: generated stand-ins take their place", "raywalk scenes fetch"
    )


def state() -> Finding:
    """A daemon of our own keeps its state in the folder for temporary files."""
    folder = Path(tempfile.gettempdir())
    try:
        with tempfile.TemporaryDirectory(prefix="raywalk-", dir=folder):
            space = os.statvfs(folder).f_bavail * os.statvfs(folder).f_frsize
    except OSError as error:
        return Finding("fail", "state", f"{folder} cannot be written: {error.strerror}", "set TMPDIR")
    detail = f"{folder} can be written, {space / 1e9:.1f} GB are free"
    return Finding("ok", "state", detail) if space > 1e9 else Finding("warn", "state", detail, "make room")


def device_findings(system: System) -> list[Finding]:
    """The device with its details and memory; without a GPU why, and what to do about it."""
    device = system.device
    findings = [Finding("ok", "device", f"{device.name} ({device.kind}), {system.machine.threads} threads")]
    if device.details:
        facts = ", ".join(f"{name} {value}" for name, value in sorted(device.details.items()))
        findings.append(Finding("ok", "device details", facts))
    if device.memory.total_bytes:
        total, free, used = (
            f"{size / 1e9:.1f} GB"
            for size in (device.memory.total_bytes, device.memory.free_bytes, device.memory.resident_bytes)
        )
        findings.append(Finding("ok", "device memory", f"{total}, {free} free, {used} scenes and structures"))
    if device.no_cuda:
        findings.append(Finding("warn", "GPU", f"not used: {device.no_cuda}", gpu_advice(device.no_cuda)))
    return findings


def gpu_advice(reason: str) -> str:
    """What the daemon's reason calls for; nothing for one that no installation mends."""
    text = reason.lower()
    if "nvrtc" in text:
        return nvrtc.CUDA12_ADVICE if "supports cuda 12." in text else nvrtc.ADVICE
    if "libcuda" in text or "driver" in text:
        return "for a GPU, install NVIDIA's driver; without one the CPU renders"
    return ""


def server_findings(client: Client) -> list[Finding]:
    """What a running daemon tells."""
    system = client.get_system()
    machine = system.machine
    findings = [
        Finding("ok", "daemon", f"{client.base_url}, version {machine.version}, commit {machine.git_commit[:12]}")
    ]
    findings += device_findings(system)
    told = system.device.no_cuda  # with the device
    findings += [Finding("warn", "daemon", text) for text in system.warnings if not (told and told in text)]
    if machine.build_type.lower() not in ("release", "relwithdebinfo"):
        findings.append(Finding("warn", "build", f"{machine.build_type}: times mean little", "./run build"))
    offered = {f"{kind.name}/{traversal.name}" for kind in client.get_kinds() for traversal in kind.traversals}
    embree = machine.libraries.get("embree", "")
    role = "" if "embree/intersect" in offered else ", on the host: the reference of every error"
    findings.append(Finding("ok", "Embree", (embree or "present") + role))
    if missing := [name for name in STANDARD if name not in offered and name != "embree/intersect"]:
        findings.append(Finding("fail", "techniques", f"missing: {', '.join(missing)}", "./run build"))
    else:
        findings.append(Finding("ok", "techniques", ", ".join(sorted(offered))))
    scenes = client.list_scenes()
    original = [scene.name for scene in scenes if scene.fidelity == "original"]
    detail = f"{len(scenes)} scenes, original data for {', '.join(original) or 'none'}"
    findings.append(Finding("ok" if scenes else "fail", "catalogue", detail))
    return findings
