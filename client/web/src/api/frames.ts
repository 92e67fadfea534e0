// One frame over the wire, with where its time went.
import { body, call } from "./http.ts";
import type { FrameRequest } from "./types.ts";

/** Milliseconds. `network` is what the daemon does not account for: both ways, and the browser. */
export interface Timing {
  queue: number;
  trace: number;
  readback: number;
  encode: number;
  network: number;
  total: number;
}

export interface Fetched<T> {
  content: T;
  timing: Timing;
}

export const JPEG = "image/jpeg";
export const PNG = "image/png";
export const EXR = "image/x-exr";
const RAW = "application/octet-stream";

/** `name;dur=1.25, ...` as numbers by name. */
export function parseServerTiming(header: string): Map<string, number> {
  const parts = new Map<string, number>();
  for (const entry of header.split(",")) {
    const [name = "", ...fields] = entry.trim().split(";");
    const duration = fields.map((field) => field.trim()).find((field) => field.startsWith("dur="));
    if (duration !== undefined) parts.set(name, Number.parseFloat(duration.slice(4)));
  }
  return parts;
}

function timingOf(header: string, total: number): Timing {
  const parts = parseServerTiming(header);
  const at = (name: string) => parts.get(name) ?? 0;
  const [queue, trace, readback, encode] = [at("queue"), at("trace"), at("readback"), at("encode")];
  return { queue, trace, readback, encode, total, network: Math.max(0, total - queue - trace - readback - encode) };
}

async function fetched<T>(
  request: FrameRequest,
  accept: string,
  read: (response: Response) => Promise<T>,
  signal?: AbortSignal,
): Promise<Fetched<T>> {
  const start = performance.now();
  const response = await call("POST", "/v1/frames", { json: request, accept, signal });
  const content = await body(read(response));
  return { content, timing: timingOf(response.headers.get("Server-Timing") ?? "", performance.now() - start) };
}

/** An encoded image: JPEG, PNG or EXR. */
export const fetchImage = (request: FrameRequest, accept: string, signal?: AbortSignal) =>
  fetched(request, accept, (response) => response.blob(), signal);

/** Pixels as numbers, rows top down, channels interleaved. */
export const fetchRaw = (request: FrameRequest, signal?: AbortSignal) =>
  fetched(request, RAW, async (response) => new Float32Array(await response.arrayBuffer()), signal);
