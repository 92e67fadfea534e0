// One function for each operation that the pages use.
import { call, json } from "./http.ts";
import type { AccuracyResult, BenchmarkResult, CameraPose, Job, JobRequest, Kind } from "./types.ts";
import type { Options, Scene, Structure, System } from "./types.ts";

const part = encodeURIComponent;

export const getSystem = () => json<System>("GET", "/v1/system");
/** All but the brute-force oracle, which would hold the device for minutes a frame. */
export const getKinds = async () =>
  (await json<{ kinds: Kind[] }>("GET", "/v1/kinds")).kinds.filter((kind) => kind.name !== "brute");

export const listScenes = async () => (await json<{ scenes: Scene[] }>("GET", "/v1/scenes")).scenes;
export const getScene = (name: string, signal?: AbortSignal) =>
  json<Scene>("GET", `/v1/scenes/${part(name)}`, { signal });
export const loadScene = (name: string, signal?: AbortSignal) =>
  json<Scene>("POST", "/v1/scenes", { json: { name }, signal });
export const evictScene = (name: string) => call("DELETE", `/v1/scenes/${part(name)}`);
const listCameras = async (scene: string, frames: number) =>
  (await json<{ cameras: CameraPose[] }>("GET", `/v1/scenes/${part(scene)}/cameras?frames=${frames}`)).cameras;
/** Whether it can be shown: its data are there, or it is resident already. */
export const isOffered = (scene: Scene) => scene.available !== false || scene.loaded;
/** Where its walkthrough begins. */
export const firstCamera = async (scene: Scene) => scene.cameras?.[0]?.pose ?? (await listCameras(scene.name, 1))[0];

export const listStructures = async () => (await json<{ structures: Structure[] }>("GET", "/v1/structures")).structures;
export const getStructure = (id: string, signal?: AbortSignal) =>
  json<Structure>("GET", `/v1/structures/${part(id)}`, { signal });
export const buildStructure = (scene: string, kind: string, options: Options, signal?: AbortSignal) =>
  json<Structure>("POST", "/v1/structures", { json: { scene, kind, options }, signal });
export const evictStructure = (id: string) => call("DELETE", `/v1/structures/${part(id)}`);

export const listJobs = async () => (await json<{ jobs: Job[] }>("GET", "/v1/jobs")).jobs;
export const submitJob = (request: JobRequest, key: string) =>
  json<Job>("POST", "/v1/jobs", { json: request, headers: { "Idempotency-Key": key } });
export const cancelJob = (id: string) => json<Job>("POST", `/v1/jobs/${part(id)}/cancel`);
export const getResult = (id: string) => json<BenchmarkResult | AccuracyResult>("GET", `/v1/results/${part(id)}`);
export const downloadResult = async (id: string, accept: string) =>
  (await call("GET", `/v1/results/${part(id)}`, { accept })).blob();
/** `path` is that of a scene or structure below /v1. */
export const pin = (path: string, isPinned: boolean) => call(isPinned ? "PUT" : "DELETE", `/v1/${path}/pin`);
