// The camera: a pose, and what moves it. Every function gives a new pose.
import type { CameraPose } from "../api/types.ts";
import { add, cross, dot, length, scale, sub, turn, unit, type Vec3 } from "./vec.ts";

export interface Pose {
  eye: Vec3;
  target: Vec3;
  up: Vec3;
  fovDeg: number;
}

/** A ball around the scene: what "near" and "far" mean there. */
export interface Extent {
  centre: Vec3;
  radius: number;
}

const POLE = (1.5 * Math.PI) / 180; // the view keeps this far from straight up and down
const FARTHEST = 1000; // radii from the centre

export function poseOf(camera: CameraPose): Pose {
  const up = (camera.up ?? [0, 1, 0]) as unknown as Vec3;
  return {
    eye: camera.eye as unknown as Vec3,
    target: camera.target as unknown as Vec3,
    up,
    fovDeg: camera.vertical_fov_deg ?? 45,
  };
}

export function cameraOf(pose: Pose): CameraPose {
  const float = (vector: Vec3) => vector.map(Math.fround); // as the daemon renders, and an address keeps it
  return { eye: float(pose.eye), target: float(pose.target), up: float(pose.up), vertical_fov_deg: pose.fovDeg };
}

/** Whether the daemon can render it, and it is not lost far outside the scene. */
export function isUsable(pose: Pose, extent: Extent): boolean {
  const numbers = [...pose.eye, ...pose.target, ...pose.up, pose.fovDeg];
  if (!numbers.every(Number.isFinite)) return false;
  const view = sub(pose.target, pose.eye);
  const side = cross(unit(view), unit(pose.up));
  const near = length(sub(pose.eye, extent.centre)) <= 10 * FARTHEST * extent.radius;
  return near && length(view) > 0 && length(side) > 1e-4 && pose.fovDeg >= 0.01 && pose.fovDeg <= 179;
}

/** `offset` turned by yaw about `up` and by pitch towards it, kept off the poles. */
function swing(offset: Vec3, up: Vec3, yaw: number, pitch: number): Vec3 {
  const pole = unit(up);
  const turned = turn(offset, pole, yaw);
  const angle = Math.acos(Math.max(-1, Math.min(1, dot(unit(turned), pole))));
  const wanted = Math.max(POLE, Math.min(Math.PI - POLE, angle - pitch));
  const axis = unit(cross(pole, turned));
  return turn(turned, axis, wanted - angle);
}

/** Turns the eye about the target; radians, positive pitch lifts the eye. */
export function orbit(pose: Pose, yaw: number, pitch: number): Pose {
  return { ...pose, eye: add(pose.target, swing(sub(pose.eye, pose.target), pose.up, yaw, pitch)) };
}

/** Turns the view about the eye; positive pitch looks up. */
export function look(pose: Pose, yaw: number, pitch: number): Pose {
  return { ...pose, target: add(pose.eye, swing(sub(pose.target, pose.eye), pose.up, yaw, pitch)) };
}

function frame(pose: Pose): { forward: Vec3; right: Vec3; above: Vec3 } {
  const forward = unit(sub(pose.target, pose.eye));
  const right = unit(cross(forward, pose.up));
  return { forward, right, above: cross(right, forward) };
}

function moved(pose: Pose, by: Vec3, extent: Extent): Pose {
  const eye = add(pose.eye, by);
  if (length(sub(eye, extent.centre)) > FARTHEST * extent.radius) return pose;
  return { ...pose, eye, target: add(pose.target, by) };
}

/** Moves eye and target in the image plane, by fractions of the image's height at the target. */
export function pan(pose: Pose, right: number, above: number, extent: Extent): Pose {
  const axes = frame(pose);
  const height = 2 * length(sub(pose.target, pose.eye)) * Math.tan((pose.fovDeg * Math.PI) / 360);
  return moved(pose, add(scale(axes.right, right * height), scale(axes.above, above * height)), extent);
}

/** Multiplies the distance to the target. */
export function zoom(pose: Pose, factor: number, extent: Extent): Pose {
  const offset = sub(pose.eye, pose.target);
  const [nearest, farthest] = [1e-4 * extent.radius, FARTHEST * extent.radius];
  const distance = Math.max(nearest, Math.min(farthest, length(offset) * factor));
  return { ...pose, eye: add(pose.target, scale(unit(offset), distance)) };
}

/** Flies along the view's own axes, in scene units. */
export function fly(pose: Pose, forward: number, right: number, above: number, extent: Extent): Pose {
  const axes = frame(pose);
  const by = add(add(scale(axes.forward, forward), scale(axes.right, right)), scale(axes.above, above));
  return moved(pose, by, extent);
}
