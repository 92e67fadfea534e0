// A camera as text in an address, and back.
import type { Pose } from "./camera.ts";
import type { Vec3 } from "./vec.ts";

/** Nine digits name a 32-bit float, which is what the daemon renders with. */
export function vectorText(vector: Vec3): string {
  return vector.map((value) => Number(Math.fround(value).toPrecision(9))).join(",");
}

function vector(given: string | null): Vec3 | null {
  const parts = (given ?? "").split(",").map((part) => (part.trim() === "" ? Number.NaN : Number(part)));
  if (parts.length !== 3 || !parts.every((part) => Number.isFinite(part))) return null;
  return [parts[0] ?? 0, parts[1] ?? 0, parts[2] ?? 0];
}

/** Parameters of an address. */
export function poseToParameters(pose: Pose): Record<string, string> {
  return {
    eye: vectorText(pose.eye),
    target: vectorText(pose.target),
    up: vectorText(pose.up),
    fov: String(pose.fovDeg),
  };
}

/** None when the address names no camera; "bad" when what it names is not one. */
export function poseFromParameters(parameters: URLSearchParams): Pose | "bad" | null {
  if (!parameters.has("eye") && !parameters.has("target")) return null;
  const eye = vector(parameters.get("eye"));
  const target = vector(parameters.get("target"));
  const up = vector(parameters.get("up") ?? "0,1,0");
  const fovDeg = Number(parameters.get("fov") ?? "45");
  return eye && target && up && Number.isFinite(fovDeg) ? { eye, target, up, fovDeg } : "bad";
}
