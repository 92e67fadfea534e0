// What the comparison shows: the images, or a figure of each pixel as a heat map.
import type { ColourFigures } from "./difference.ts";
import { quantile } from "./difference.ts";
import type { Measured } from "./measured.ts";

export type Sight = "side" | "wiper" | "difference" | "steps" | "tests";

export const SIGHTS: { value: Sight; label: string; title: string }[] = [
  { value: "side", label: "Side by side", title: "Both images" },
  { value: "wiper", label: "Wiper", title: "A left of the wiper, B right of it" },
  { value: "difference", label: "Difference", title: "Largest difference of a channel, in 8-bit levels" },
  { value: "steps", label: "Steps", title: "Traversal steps of each primary ray" },
  { value: "tests", label: "Tests", title: "Triangle tests of each primary ray" },
];

export interface Heated {
  values: [Float32Array, Float32Array]; // of A and B
  full: number; // the value that is red
  unit: string;
}

/** None for the images themselves. Both sides have one scale. */
export function channelsOf(sight: Sight, a: Measured, b: Measured, colours: ColourFigures): Heated | null {
  if (sight === "difference") {
    return { values: [colours.levels, colours.levels], full: Math.max(1, colours.max), unit: "levels of 255" };
  }
  if (sight !== "steps" && sight !== "tests") return null;
  const full = Math.max(1, quantile(a[sight], 0.998), quantile(b[sight], 0.998));
  return { values: [a[sight], b[sight]], full, unit: sight };
}
