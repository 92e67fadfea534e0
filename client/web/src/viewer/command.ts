// The `raywalk render` command for what a viewer shows.
import type { Pose } from "./camera.ts";
import type { Look } from "./choice.ts";
import type { Vec3 } from "./vec.ts";

function quoted(text: string): string {
  return /^[\w./:=,+-]+$/.test(text) ? text : `'${text.replaceAll("'", `'\\''`)}'`;
}

const vector = (value: Vec3): string => value.map((part) => Number(part.toPrecision(7))).join(",");

/** One line for a shell. `server` is the daemon's address. */
export function renderCommand(look: Look, pose: Pose, width: number, height: number, server: string): string {
  const words = ["raywalk", "--server", server, "render", look.scene];
  words.push("--structure", look.structure, "--traversal", look.traversal);
  words.push(`--eye=${vector(pose.eye)}`, `--target=${vector(pose.target)}`, `--up=${vector(pose.up)}`);
  words.push("--fov", String(pose.fovDeg), "--size", `${width}x${height}`, "--mode", look.mode);
  if (look.mode === "whitted") words.push("--depth", String(look.depth));
  if (look.output !== "color") words.push("--output", look.output);
  words.push("--tier", look.tier, "--out", `${look.scene}.png`);
  return words.map(quoted).join(" ");
}
