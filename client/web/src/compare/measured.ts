// The figures behind an image: what each pixel hit, how far, and what that took.
import { fetchRaw } from "../api/frames.ts";
import type { FrameRequest } from "../api/types.ts";
import { channel } from "./difference.ts";

/** Arrays of one value a pixel, but colour, which has three. */
export interface Measured {
  width: number;
  height: number;
  colour: Float32Array;
  id: Float32Array;
  t: Float32Array;
  steps: Float32Array;
  tests: Float32Array;
  traceMs: number; // of the shaded frame
}

/** Four frames, one after the other. */
export async function measure(request: FrameRequest, signal: AbortSignal): Promise<Measured> {
  const colour = await fetchRaw({ ...request, output: "color" }, signal);
  const id = await fetchRaw({ ...request, output: "id" }, signal);
  const t = await fetchRaw({ ...request, output: "depth" }, signal);
  const work = await fetchRaw({ ...request, output: "steps" }, signal);
  return {
    width: request.width ?? 512,
    height: request.height ?? 512,
    colour: colour.content,
    id: id.content,
    t: t.content,
    steps: channel(work.content, 0, 2),
    tests: channel(work.content, 1, 2),
    traceMs: colour.timing.trace,
  };
}
