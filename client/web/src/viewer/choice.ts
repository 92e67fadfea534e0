// What a viewer is asked to show: a scene, a technique and its settings.
import type { Kind, Mode, Option, Options, Output } from "../api/types.ts";
import { plural } from "../ui/format.ts";

export interface Look {
  scene: string;
  structure: string; // kind
  build: Options; // of the structure
  traversal: string;
  kernel: Options; // of the traversal
  tier: "strict" | "fast";
  mode: Mode;
  depth: number;
  lights: number | null; // so many shine, the first ones; null: all
  output: Output;
}

export const MODES: Mode[] = ["primary", "shadow", "whitted"];
export const OUTPUTS: Output[] = ["color", "depth", "normal", "id", "steps"];

export const DEFAULT_LOOK: Look = {
  scene: "bunny",
  structure: "bvh",
  build: {},
  traversal: "while-while",
  kernel: {},
  tier: "strict",
  mode: "shadow",
  depth: 2,
  lights: null,
  output: "color",
};

/** Traversals that shade frames; bare loops only bound what is possible. */
export function traversalsOf(kinds: Kind[], structure: string): string[] {
  const kind = kinds.find((known) => known.name === structure);
  return (kind?.traversals ?? []).filter((traversal) => !traversal.baseline).map((traversal) => traversal.name);
}

function fitting(wanted: string, usual: string, names: string[]): string {
  return [wanted, usual].find((name) => names.includes(name)) ?? names[0] ?? "";
}

function described(options: Options, by: Option[] = []): Options {
  return Object.fromEntries(Object.entries(options).filter(([name]) => by.some((option) => option.name === name)));
}

/** The look with names that the daemon knows: others fall back to the usual one, or the first that fits. */
export function known(look: Look, kinds: Kind[]): Look {
  const names = kinds.map((kind) => kind.name);
  const structure = fitting(look.structure, DEFAULT_LOOK.structure, names);
  const traversal = fitting(look.traversal, DEFAULT_LOOK.traversal, traversalsOf(kinds, structure));
  const kind = kinds.find((one) => one.name === structure);
  const chosen = kind?.traversals.find((one) => one.name === traversal);
  const build = described(look.build, kind?.options);
  const kernel = described(look.kernel, chosen?.options);
  return { ...look, structure, build, traversal, kernel };
}

/** What a look shows with, in a few words: its technique, and what is not as usual. */
export function briefly(look: Look): string {
  const words = [`${look.structure}/${look.traversal}`, look.mode];
  if (look.mode === "whitted" && look.depth !== DEFAULT_LOOK.depth) words.push(`depth ${look.depth}`);
  if (look.lights !== null) words.push(look.lights === 0 ? "no lights" : plural(look.lights, "light"));
  if (look.tier !== DEFAULT_LOOK.tier) words.push(look.tier);
  for (const [name, value] of Object.entries({ ...look.build, ...look.kernel })) words.push(`${name}=${value}`);
  return words.join(", ");
}

/** Parameters of an address; what is as by default is left out. */
export function lookToParameters(look: Look, prefix = ""): Record<string, string> {
  const parameters: Record<string, string> = {};
  for (const name of ["scene", "structure", "traversal", "tier", "mode", "depth", "lights", "output"] as const) {
    const isNeeded = name === "scene" || look[name] !== DEFAULT_LOOK[name];
    if (isNeeded) parameters[prefix + name] = String(look[name]);
  }
  for (const name of ["build", "kernel"] as const) {
    if (Object.keys(look[name]).length > 0) parameters[prefix + name] = JSON.stringify(look[name]);
  }
  return parameters;
}

function optionsFrom(text: string | null): Options {
  try {
    const value: unknown = JSON.parse(text ?? "{}");
    if (typeof value !== "object" || value === null || Array.isArray(value)) return {};
    const entries = Object.entries(value).filter(([, v]) => typeof v === "number" || typeof v === "string");
    return Object.fromEntries(entries) as Options;
  } catch {
    return {};
  }
}

function countFrom(text: string | null): number | null {
  return text !== null && /^\d{1,6}$/.test(text) ? Number(text) : null;
}

export function lookFromParameters(parameters: URLSearchParams, prefix = ""): Look {
  const text = (name: keyof Look) => parameters.get(prefix + name);
  const depth = countFrom(text("depth"));
  return {
    scene: text("scene") ?? DEFAULT_LOOK.scene,
    structure: text("structure") ?? DEFAULT_LOOK.structure,
    traversal: text("traversal") ?? DEFAULT_LOOK.traversal,
    build: optionsFrom(text("build")),
    kernel: optionsFrom(text("kernel")),
    tier: text("tier") === "fast" ? "fast" : "strict",
    mode: MODES.find((mode) => mode === text("mode")) ?? DEFAULT_LOOK.mode,
    depth: depth !== null && depth <= 16 ? depth : DEFAULT_LOOK.depth,
    lights: countFrom(text("lights")),
    output: OUTPUTS.find((output) => output === text("output")) ?? DEFAULT_LOOK.output,
  };
}
