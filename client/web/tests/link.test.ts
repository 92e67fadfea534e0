// Views as text: addresses and commands.
import assert from "node:assert/strict";
import { test } from "node:test";
import { addressText, parseAddress } from "../src/app/router.ts";
import { briefly, DEFAULT_LOOK, known, lookFromParameters, lookToParameters } from "../src/viewer/choice.ts";
import { renderCommand } from "../src/viewer/command.ts";
import { poseFromParameters, poseToParameters } from "../src/viewer/link.ts";

const POSE = { eye: [0.1, -2, 3e-7], target: [0, 0, 0], up: [0, 1, 0], fovDeg: 40 } as const;

test("a pose comes back as the same 32-bit floats", () => {
  const back = poseFromParameters(new URLSearchParams(poseToParameters(POSE)));
  assert.ok(back !== null && back !== "bad");
  for (const name of ["eye", "target", "up"] as const) {
    assert.deepEqual(back[name].map(Math.fround), POSE[name].map(Math.fround));
  }
  assert.equal(back.fovDeg, 40);
});

test("cameras that are none", () => {
  assert.equal(poseFromParameters(new URLSearchParams("scene=bunny")), null);
  const bad = [
    "eye=1,2&target=0,0,0",
    "eye=1,2,x&target=0,0,0",
    "eye=1e999,0,0&target=0,0,0",
    "eye=1,2,3",
    "eye=,,&target=0,0,0",
  ];
  for (const text of bad) assert.equal(poseFromParameters(new URLSearchParams(text)), "bad", text);
});

test("a look comes back; what is not known falls back", () => {
  const look = {
    ...DEFAULT_LOOK,
    scene: "robots",
    structure: "grid",
    depth: 5,
    lights: 1,
    kernel: { spawn: "none" },
    build: { density: 3 },
  };
  assert.deepEqual(lookFromParameters(new URLSearchParams(lookToParameters(look, "a.")), "a."), look);
  const odd = new URLSearchParams("depth=99&lights=-1&mode=paths&output=smell&kernel={&build=[1]&tier=none");
  assert.deepEqual(lookFromParameters(odd), DEFAULT_LOOK);
});

test("names that the daemon does not know", () => {
  const kind = (name: string, traversals: string[]) => ({
    name,
    help: "",
    options: [],
    traversals: traversals.map((one) => ({ name: one, help: "", options: [] })),
  });
  const kinds = [kind("grid", ["dda"]), kind("bvh", ["packet", "while-while"])];
  const odd = { ...DEFAULT_LOOK, structure: "tree", traversal: "walk", build: { bins: 3 }, kernel: { smell: 1 } };
  assert.deepEqual(known(odd, kinds), DEFAULT_LOOK);
  assert.equal(known({ ...DEFAULT_LOOK, structure: "grid" }, kinds).traversal, "dda");
});

test("a look in a few words", () => {
  assert.equal(briefly(DEFAULT_LOOK), "bvh/while-while, shadow");
  const look = { ...DEFAULT_LOOK, mode: "whitted" as const, depth: 4, lights: 0, tier: "fast" as const };
  assert.equal(briefly({ ...look, build: { bins: 8 } }), "bvh/while-while, whitted, depth 4, no lights, fast, bins=8");
});

test("addresses", () => {
  const { page, parameters } = parseAddress("#/compare?a.scene=bunny&eye=1,2,3");
  assert.equal(page, "compare");
  assert.equal(parameters.get("eye"), "1,2,3");
  assert.equal(addressText("preview", { eye: "1,2,3" }), "#/preview?eye=1,2,3");
  assert.equal(parseAddress("").page, "");
});

test("a command quotes what a shell would take apart", () => {
  const look = {
    ...DEFAULT_LOOK,
    scene: "a b's",
    mode: "whitted" as const,
    kernel: { slab: "plain" },
    build: { bins: 8 },
  };
  const command = renderCommand({ ...look, lights: 0 }, POSE, 64, 48, "http://127.0.0.1:7979");
  assert.ok(
    command.includes(`render 'a b'\\''s' --structure bvh -o bins=8 --traversal while-while --kernel slab=plain`),
  );
  assert.ok(
    command.includes("--eye=0.100000001,-2,") && command.includes("--size 64x48 --mode whitted --depth 2 --lights 0"),
  );
});
