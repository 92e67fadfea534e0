// The `raywalk render` command for what a viewer shows.
import type { Pose } from "./camera.ts";
import type { Look } from "./choice.ts";
import { vectorText } from "./link.ts";

function quoted(text: string): string {
  return /^[\w./:=,+-]+$/.test(text) ? text : `'${text.replaceAll("'", `'\\''`)}'`;
}

/** One line for a shell. `server` is the daemon's address. */
export function renderCommand(look: Look, pose: Pose, width: number, height: number, server: string): string {
  const words = ["raywalk", "--server", server, "render", look.scene];
  words.push("--structure", look.structure);
  for (const [name, value] of Object.entries(look.build)) words.push("-o", `${name}=${value}`);
  words.push("--traversal", look.traversal);
  const kernel = Object.entries(look.kernel).map(([name, value]) => `${name}=${value}`);
  if (kernel.length > 0) words.push("--kernel", kernel.join(","));
  words.push(`--eye=${vectorText(pose.eye)}`, `--target=${vectorText(pose.target)}`, `--up=${vectorText(pose.up)}`);
  words.push("--fov", String(pose.fovDeg), "--size", `${width}x${height}`, "--mode", look.mode);
  if (look.mode === "whitted") words.push("--depth", String(look.depth));
  if (look.lights !== null) words.push("--lights", String(look.lights));
  if (look.output !== "color") words.push("--output", look.output);
  words.push("--tier", look.tier, "--out", `${look.scene}.png`);
  return words.map(quoted).join(" ");
}
