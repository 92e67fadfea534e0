// The camera's motions.
import assert from "node:assert/strict";
import { test } from "node:test";
import { fly, isUsable, look, orbit, pan, type Pose, zoom } from "../src/viewer/camera.ts";
import { dot, length, sub, unit } from "../src/viewer/vec.ts";

const POSE: Pose = { eye: [0, 0, 2], target: [0, 0, 0], up: [0, 1, 0], fovDeg: 45 };
const BALL = { centre: [0, 0, 0], radius: 1 } as const;

const near = (a: readonly number[], b: readonly number[]) => {
  for (const [at, value] of a.entries()) assert.ok(Math.abs(value - (b[at] ?? Number.NaN)) < 1e-9, `${a} is not ${b}`);
};

test("a quarter turn about the target", () => {
  near(orbit(POSE, Math.PI / 2, 0).eye, [2, 0, 0]);
  near(orbit(POSE, 2 * Math.PI, 0).eye, POSE.eye);
});

test("pitch lifts the eye, keeps the distance and stops before the pole", () => {
  const lifted = orbit(POSE, 0, Math.PI / 4);
  near(lifted.eye, [0, Math.SQRT2, Math.SQRT2]);
  for (const pitch of [10, -10]) {
    const far = orbit(POSE, 0.3, pitch);
    assert.ok(Math.abs(length(far.eye) - 2) < 1e-9);
    assert.ok(Math.abs(dot(unit(far.eye), POSE.up)) < Math.cos(0.02));
    assert.ok(isUsable(far, BALL));
  }
});

test("looking about turns the view and leaves the eye", () => {
  const turned = look(POSE, Math.PI / 2, 0);
  near(turned.eye, POSE.eye);
  near(turned.target, [-2, 0, 2]);
  assert.ok(look(POSE, 0, 0.5).target[1] > 0);
});

test("panning by a whole height moves by what the image shows", () => {
  const moved = pan(POSE, 0, 1, BALL);
  near(moved.eye, [0, 4 * Math.tan(Math.PI / 8), 2]);
  near(sub(moved.target, moved.eye), sub(POSE.target, POSE.eye));
});

test("zoom stays between its ends", () => {
  near(zoom(POSE, 0.5, BALL).eye, [0, 0, 1]);
  assert.ok(length(zoom(POSE, 0, BALL).eye) > 0);
  assert.ok(length(zoom(POSE, 1e30, BALL).eye) <= 1000);
});

test("flying goes along the view, but not out of the scene's reach", () => {
  near(fly(POSE, 1, 2, 3, BALL).eye, [2, 3, 1]);
  assert.deepEqual(fly(POSE, 1e6, 0, 0, BALL), POSE);
});

test("poses that cannot be rendered", () => {
  assert.ok(isUsable(POSE, BALL));
  const bad: Partial<Pose>[] = [
    { eye: [Number.POSITIVE_INFINITY, 0, 0] },
    { eye: [1e30, 0, 0] },
    { eye: [0, 0, 0] },
    { up: [0, 0, 1] },
    { up: [0, 0, 0] },
    { fovDeg: 0 },
    { fovDeg: Number.NaN },
  ];
  for (const part of bad) assert.ok(!isUsable({ ...POSE, ...part }, BALL), JSON.stringify(part));
});
