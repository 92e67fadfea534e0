"""Typed client of the daemon: one method an operation of proto/openapi.yaml, under the operation's name."""

import time
import uuid
from collections.abc import Callable, Iterator
from typing import Any, Self, TypeVar
from urllib.parse import quote

import httpx2
from pydantic import BaseModel, ValidationError

from raywalk import models
from raywalk.errors import ProblemError, RaywalkError
from raywalk.payload import Frame, RayHits, ray_bytes, server_timing, unpack_hits
from raywalk.transfer import Transfer, read_problem

DEFAULT_SERVER = "http://127.0.0.1:7979"
Model = TypeVar("Model", bound=BaseModel)


class Client:
    """Synchronous client. Problems are raised as ProblemError, a missing daemon as UnreachableError."""

    def __init__(
        self,
        base_url: str = DEFAULT_SERVER,
        transport: httpx2.BaseTransport | None = None,
        timeout: float = 600.0,
        retries: int = 3,
        sleep: Callable[[float], None] = time.sleep,
        on_lost: Callable[[], None] | None = None,
    ):
        """`on_lost` is called when a connection is lost or refused; what it raises ends the retries."""
        self._transfer = Transfer(base_url, transport, timeout, retries, sleep, on_lost)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        self._transfer.close()

    @property
    def base_url(self) -> str:
        return self._transfer.base_url

    # System
    def get_livez(self) -> str:
        return self._transfer.send("GET", "/livez").text

    def get_readyz(self) -> str:
        return self._transfer.send("GET", "/readyz").text

    def get_metrics(self) -> str:
        return self._transfer.send("GET", "/metrics").text

    def get_openapi(self) -> dict[str, Any]:
        return self._transfer.send("GET", "/v1/openapi.json").json()

    def get_system(self) -> models.System:
        return self._read(models.System, "GET", "/v1/system")

    def get_kinds(self) -> list[models.Kind]:
        return self._read(models.KindList, "GET", "/v1/kinds").kinds

    # Scenes
    def list_scenes(self) -> list[models.Scene]:
        return self._read(models.SceneList, "GET", "/v1/scenes").scenes

    def load_scene(self, name: str, triangles: int | None = None) -> models.Scene:
        request = models.SceneRequest(name=name, triangles=triangles)
        return self._read(models.Scene, "POST", "/v1/scenes", body=request)

    def get_scene(self, scene: str) -> models.Scene:
        return self._read(models.Scene, "GET", f"/v1/scenes/{part(scene)}")

    def upload_scene(self, scene: str, content: bytes, extension: str | None = None) -> models.Scene:
        """`extension` of the file's name, without a dot, tells formats that the content does not."""
        headers = {"Content-Type": "application/octet-stream"}
        params = {"extension": extension} if extension else {}
        path = f"/v1/scenes/{part(scene)}"
        return self._read(models.Scene, "PUT", path, again=False, content=content, headers=headers, params=params)

    def delete_scene(self, scene: str) -> None:
        self._transfer.send("DELETE", f"/v1/scenes/{part(scene)}", again=False)

    def pin_scene(self, scene: str) -> None:
        self._transfer.send("PUT", f"/v1/scenes/{part(scene)}/pin")

    def unpin_scene(self, scene: str) -> None:
        self._transfer.send("DELETE", f"/v1/scenes/{part(scene)}/pin")

    def list_cameras(self, scene: str, frames: int = 400) -> list[models.CameraPose]:
        path = f"/v1/scenes/{part(scene)}/cameras"
        return self._read(models.CameraList, "GET", path, params={"frames": frames}).cameras

    # Structures
    def list_structures(self) -> list[models.Structure]:
        return self._read(models.StructureList, "GET", "/v1/structures").structures

    def build_structure(self, scene: str, kind: str, options: dict[str, float | str] | None = None) -> models.Structure:
        request = models.StructureRequest(scene=scene, kind=kind, options=options)
        return self._read(models.Structure, "POST", "/v1/structures", body=request)

    def get_structure(self, structure: str) -> models.Structure:
        return self._read(models.Structure, "GET", f"/v1/structures/{part(structure)}")

    def delete_structure(self, structure: str) -> None:
        self._transfer.send("DELETE", f"/v1/structures/{part(structure)}", again=False)

    def pin_structure(self, structure: str) -> None:
        self._transfer.send("PUT", f"/v1/structures/{part(structure)}/pin")

    def unpin_structure(self, structure: str) -> None:
        self._transfer.send("DELETE", f"/v1/structures/{part(structure)}/pin")

    # Frames and rays
    def render_frame(self, request: models.FrameRequest, accept: str = "image/jpeg") -> Frame:
        response = self._transfer.send("POST", "/v1/frames", json=wire(request), headers={"Accept": accept})
        return Frame(
            content=response.content,
            media_type=response.headers.get("Content-Type", "").split(";")[0],
            width=request.width or 512,
            height=request.height or 512,
            output=request.output or "color",
            timing_ms=server_timing(response.headers.get("Server-Timing", "")),
            etag=response.headers.get("ETag", ""),
        )

    def trace_rays(self, scene: str, structure: str, traversal: str, rays: Any, query: str = "closest") -> RayHits:
        """`rays` is packed bytes (see pack_rays) or an (n, 8) array."""
        params = {"scene": scene, "structure": structure, "traversal": traversal, "query": query}
        headers = {"Content-Type": "application/octet-stream"}
        response = self._transfer.send("POST", "/v1/rays", params=params, content=ray_bytes(rays), headers=headers)
        return RayHits(unpack_hits(response.content, query), int(response.headers.get("X-Invalid-Rays", 0)))

    # Jobs
    def list_jobs(self) -> list[models.Job]:
        return self._read(models.JobList, "GET", "/v1/jobs").jobs

    def submit_job(
        self, spec: models.BenchmarkSpec | models.AccuracySpec, idempotency_key: str | None = None
    ) -> models.Job:
        if isinstance(spec, models.AccuracySpec):
            request: BaseModel = models.AccuracyRequest(kind="accuracy", spec=spec)
        else:
            request = models.BenchmarkRequest(kind="benchmark", spec=spec)
        headers = {"Idempotency-Key": idempotency_key or str(uuid.uuid4())}
        return self._read(models.Job, "POST", "/v1/jobs", body=request, headers=headers)

    def get_job(self, job: str) -> models.Job:
        return self._read(models.Job, "GET", f"/v1/jobs/{part(job)}")

    def cancel_job(self, job: str) -> models.Job:
        return self._read(models.Job, "POST", f"/v1/jobs/{part(job)}/cancel")

    def stream_job_events(self, job: str) -> Iterator[models.Job]:
        """The job after every change, until it has ended or the connection is lost."""
        with self._transfer.stream(f"/v1/jobs/{part(job)}/events") as response:
            if not response.is_success:
                response.read()
                raise ProblemError(read_problem(response))
            for event in httpx2.EventSource(response):
                if event.event == "job":
                    yield parse(models.Job, event.data)

    def get_result(self, job: str) -> models.BenchmarkResult:
        return self._read(models.BenchmarkResult, "GET", f"/v1/results/{part(job)}")

    def get_accuracy_result(self, job: str) -> models.AccuracyResult:
        return self._read(models.AccuracyResult, "GET", f"/v1/results/{part(job)}")

    def get_result_csv(self, job: str) -> str:
        return self._transfer.send("GET", f"/v1/results/{part(job)}", headers={"Accept": "text/csv"}).text

    def _read(self, model: type[Model], method: str, path: str, body: BaseModel | None = None, **request: Any) -> Model:
        if body is not None:
            request["json"] = wire(body)
        return parse(model, self._transfer.send(method, path, **request).content)


def part(name: str) -> str:
    """A name as one segment of a path."""
    return quote(name, safe="")


def wire(request: BaseModel) -> dict[str, Any]:
    """What goes over the wire: absent fields are left to the daemon's defaults."""
    return request.model_dump(mode="json", exclude_unset=True, exclude_none=True)


def parse(model: type[Model], content: bytes | str) -> Model:
    """An answer as its model; throws RaywalkError when it breaks the contract."""
    try:
        return model.model_validate_json(content)
    except ValidationError as error:
        first = error.errors()[0]
        where = "/".join(str(step) for step in first["loc"])
        raise RaywalkError(f"the daemon's answer is no {model.__name__}: /{where}: {first['msg']}") from error
