"""raywalk render and raywalk walk: images of a scene."""

import csv
import math
from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from raywalk.cli.session import connected, options, size, technique, vector, words, writable_file, writable_folder
from raywalk.client import Client
from raywalk.errors import RaywalkError
from raywalk.follow import built
from raywalk.images import SUFFIXES, Animation, save_frame
from raywalk.models import CameraPose, FrameRequest, PathFrame
from raywalk.models import Scene as SceneDocument
from raywalk.payload import Frame
from raywalk.progress import bar, messages


class Mode(StrEnum):
    PRIMARY = "primary"
    SHADOW = "shadow"
    WHITTED = "whitted"


class Output(StrEnum):
    COLOR = "color"
    DEPTH = "depth"
    NORMAL = "normal"
    ID = "id"
    STEPS = "steps"


class Tier(StrEnum):
    STRICT = "strict"
    FAST = "fast"


Scene = Annotated[str, typer.Argument(help="Name of a scene.")]
Structure = Annotated[str, typer.Option(help="Kind of structure, built first with its default options.")]
Traversal = Annotated[str, typer.Option(help="Traversal of that kind.")]
Size = Annotated[str, typer.Option(help="Pixels.", metavar="WxH")]
ModeOption = Annotated[Mode, typer.Option(help="Which rays.")]
Depth = Annotated[int, typer.Option(min=0, max=16, help="Bounces of secondary rays in mode whitted.")]
OutputOption = Annotated[Output, typer.Option(help="What the pixels show.")]
Point = typer.Option(metavar="X,Y,Z")


def camera_of(
    frame: int | None, of: int, eye: str | None, target: str | None, up: str | None, fov: float | None
) -> CameraPose | PathFrame:
    if (eye is None) != (target is None):
        raise typer.BadParameter("--eye and --target go together")
    if fov is not None and not math.isfinite(fov):
        raise typer.BadParameter("--fov is not finite")
    if eye is not None and target is not None:
        if frame is not None:
            raise typer.BadParameter("give either --frame or --eye and --target")
        pose = {"eye": vector(eye), "target": vector(target)} | ({} if up is None else {"up": vector(up)})
        return CameraPose.model_validate(pose | ({} if fov is None else {"vertical_fov_deg": fov}))
    if fov is not None or up is not None:
        raise typer.BadParameter("--fov and --up need --eye and --target")
    return PathFrame(frame=frame or 0, of=of)


def named_camera(scene: SceneDocument, name: str) -> CameraPose:
    cameras = {camera.name: camera.pose for camera in scene.cameras or []}
    if name not in cameras:
        raise RaywalkError(f"scene {scene.name} has no camera {name!r}; its cameras: {', '.join(cameras) or 'none'}")
    return cameras[name]


def prepared(client: Client, scene: str, kind: str, build: dict[str, float | str] | None = None) -> str:
    """Loads the scene and builds the structure; its id."""
    with bar(f"loading {scene}") as progress:
        client.load_scene(scene)
        progress.update(0, what=f"building {kind}")
        return built(client, scene, kind, build).id


def render(
    context: typer.Context,
    scene: Scene,
    out: Annotated[Path, typer.Option(help=f"File; its suffix says how: {' '.join(SUFFIXES)}.")] = Path("frame.png"),
    structure: Structure = "bvh",
    option: Annotated[list[str] | None, typer.Option("-o", "--option", help="Build option name=value.")] = None,
    traversal: Traversal = "while-while",
    kernel: Annotated[str | None, typer.Option(metavar="NAME=VALUE,...", help="Options of the kernel.")] = None,
    frame: Annotated[int | None, typer.Option(min=0, help="Frame of the walkthrough.")] = None,
    of: Annotated[int, typer.Option(min=1, help="Frames that the walkthrough is cut into.")] = 400,
    eye: Annotated[str | None, Point] = None,
    target: Annotated[str | None, Point] = None,
    up: Annotated[str | None, typer.Option(metavar="X,Y,Z", help="What is up; 0,1,0 when absent.")] = None,
    fov: Annotated[float | None, typer.Option(help="Full vertical field of view in degrees.")] = None,
    camera: Annotated[str | None, typer.Option(help="A view that the scene's file names.")] = None,
    size_: Annotated[str, typer.Option("--size", help="Pixels.", metavar="WxH")] = "512x512",
    mode: ModeOption = Mode.PRIMARY,
    depth: Depth = 2,
    lights: Annotated[int | None, typer.Option(min=0, help="So many lights, the first ones; all when absent.")] = None,
    output: OutputOption = Output.COLOR,
    tier: Annotated[Tier, typer.Option(help="Accuracy of the kernel: strict, or fast with up to 1 ppm of errors.")] = (
        Tier.STRICT
    ),
) -> None:
    """Render one frame into a file."""
    if out.suffix.lower() not in SUFFIXES:
        raise typer.BadParameter(f"the suffix of {out.name!r} should be one of {' '.join(SUFFIXES)}")
    width, height = size(size_)
    if camera is not None and (eye is not None or target is not None or frame is not None):
        raise typer.BadParameter("give one of --camera, --frame, and --eye with --target")
    view = camera_of(frame, of, eye, target, up, fov)
    build, knobs = options(option), options(words(kernel or ""), "intersector=watertight")
    writable_file(out)
    with connected(context) as client:
        built_id = prepared(client, scene, structure, build)
        request = FrameRequest(
            scene=scene,
            structure=built_id if build else structure,
            traversal=traversal,
            kernel=knobs,
            camera=view if camera is None else named_camera(client.get_scene(scene), camera),
            width=width,
            height=height,
            mode=mode.value,
            depth=depth,
            lights=lights,
            output=output.value,
            tier=tier.value,
        )
        got = client.render_frame(request, SUFFIXES[out.suffix.lower()])
    save_frame(got, out)
    timing = ", ".join(f"{name} {duration:.2f} ms" for name, duration in got.timing_ms.items())
    messages().print(f"wrote {out} ({timing})")


def walk(
    context: typer.Context,
    scene: Scene,
    frames: Annotated[int, typer.Option(min=1, max=100000, help="Frames of the walkthrough.")] = 60,
    out: Annotated[Path, typer.Option(help="Folder for frames, preview and times.")] = Path("out/walk"),
    structure: Structure = "bvh",
    traversal: Traversal = "while-while",
    size_: Annotated[str, typer.Option("--size", help="Pixels.", metavar="WxH")] = "512x512",
    mode: ModeOption = Mode.SHADOW,
    depth: Depth = 2,
    output: OutputOption = Output.COLOR,
    preview: Annotated[str, typer.Option(help="Name of the animated preview (.webp or .gif).")] = "preview.webp",
    fps: Annotated[float, typer.Option(min=1, max=60, help="Frames a second of the preview.")] = 20,
) -> None:
    """Render the walkthrough: frames/NNNN.png, an animated preview and times.csv."""
    width, height = size(size_)
    if Path(preview).suffix not in (".webp", ".gif") or Path(preview).name != preview:
        raise typer.BadParameter("--preview takes a file name that ends in .webp or .gif")
    technique(f"{structure}/{traversal}")
    folder = writable_folder(out)
    writable_folder(folder / "frames")
    animation = Animation(fps)
    common = {"scene": scene, "structure": structure, "traversal": traversal, "width": width, "height": height}
    common |= {"mode": mode.value, "depth": depth, "output": output.value}
    with connected(context) as client, (folder / "times.csv").open("w", newline="") as times:
        prepared(client, scene, structure)
        rows = csv.writer(times)
        rows.writerow(["frame", "queue_ms", "trace_ms", "readback_ms", "encode_ms"])
        with bar(f"walking through {scene}", frames) as progress:
            for number in range(frames):
                camera = PathFrame(frame=number, of=frames)
                got = client.render_frame(FrameRequest.model_validate(common | {"camera": camera}), "image/png")
                save_frame(got, folder / "frames" / f"{number:04}.png")
                animation.add(got.content)
                rows.writerow([number, *(got.timing_ms.get(part) for part in ("queue", "trace", "readback", "encode"))])
                progress.update(number + 1, frames, rates(got, progress.rate(number + 1)))
    animation.save(folder / preview)
    messages().print(f"wrote {frames} frames, times.csv and {preview} in {folder}")


def rates(frame: Frame, frames_per_s: float) -> str:
    """Frames a second as they arrive, primary rays a second as they are traced."""
    trace_ms = frame.timing_ms.get("trace", 0)
    traced = f"  {frame.width * frame.height / trace_ms / 1e3:.2f} Mrays/s" if trace_ms else ""
    return f"{frames_per_s:.1f} frames/s{traced}"
