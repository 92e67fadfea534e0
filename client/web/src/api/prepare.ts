// Makes a scene and a structure resident before frames are asked for.
import { buildStructure, getScene, getStructure, loadScene } from "./resources.ts";
import { Problem } from "./errors.ts";
import type { Options, Scene, Structure } from "./types.ts";

const POLL_MS = 100;

function pause(ms: number, signal: AbortSignal): Promise<void> {
  return new Promise((done, stop) => {
    const timer = setTimeout(done, ms);
    signal.addEventListener("abort", () => {
      clearTimeout(timer);
      stop(signal.reason);
    });
  });
}

/** The scene, as it is resident or loaded now. */
export async function residentScene(name: string, signal: AbortSignal): Promise<Scene> {
  const scene = await getScene(name, signal);
  return scene.loaded ? scene : loadScene(name, signal);
}

/** The structure once it is ready. Throws Problem build_failed. */
export async function readyStructure(
  scene: string,
  kind: string,
  options: Options,
  signal: AbortSignal,
): Promise<Structure> {
  let structure = await buildStructure(scene, kind, options, signal);
  while (structure.state === "building") {
    await pause(POLL_MS, signal);
    structure = await getStructure(structure.id, signal);
  }
  if (structure.state === "failed") {
    const detail = structure.error ?? `Structure ${kind} could not be built.`;
    throw new Problem({ status: 422, code: "build_failed", detail, retryable: false });
  }
  return structure;
}
