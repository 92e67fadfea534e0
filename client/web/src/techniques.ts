// Structures with their traversals, by the names that tables have.
import type { Kind } from "./api/types.ts";

export interface Technique {
  structure: string;
  traversal: string;
}

export const nameOf = (technique: Technique): string => `${technique.structure}/${technique.traversal}`;

/** The study's names of these techniques. */
const PAPER: Record<string, string> = {
  "grid/dda": "grid",
  "kdtree/short-stack-3": "kdt-3",
  "kdtree/short-stack-2": "kdt-2",
  "bvh/packet": "bvh",
};

export function paperName(technique: Technique): string | undefined {
  return PAPER[nameOf(technique)];
}

/** Every technique that shades frames, bare loops apart. */
export function techniquesOf(kinds: Kind[]): Technique[] {
  return kinds.flatMap((kind) =>
    kind.traversals
      .filter((traversal) => traversal.baseline !== true)
      .map((traversal) => ({ structure: kind.name, traversal: traversal.name })),
  );
}
