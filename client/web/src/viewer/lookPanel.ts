// Controls of a look: structure, traversal, their options, and what is shaded.
import type { Kind, Scene } from "../api/types.ts";
import { h } from "../ui/dom.ts";
import { type Choice, numberField, selectField } from "../ui/fields.ts";
import { optionFields } from "../ui/optionFields.ts";
import { type Look, MODES, OUTPUTS, traversalsOf } from "./choice.ts";

const MODE_NAMES = { primary: "primary rays", shadow: "with shadows", whitted: "Whitted, recursive" };
const OUTPUT_NAMES = {
  color: "shaded",
  depth: "depth",
  normal: "normals",
  id: "triangle ids",
  steps: "steps heat map",
};

export interface LookPanel {
  element: HTMLElement;
  /** Shows a look of known names; `change` is not called. */
  show(look: Look, scene: Scene | undefined): void;
}

const ALL = "all";

/** How many of a scene's lights may shine. */
function lightChoices(count: number): Choice[] {
  const fewer = Array.from({ length: count }, (_, at) => count - 1 - at);
  const named = fewer.map((lights) => ({ value: String(lights), label: lights === 0 ? "none" : `first ${lights}` }));
  const label = count === 0 ? "none" : count === 1 ? "1" : `all ${count}`;
  return [{ value: ALL, label }, ...named];
}

/** `parts` leaves controls out that a page has no use for. */
export function lookPanel(
  kinds: Kind[],
  change: (look: Look) => void,
  parts: { output: boolean } = { output: true },
): LookPanel {
  let look: Look;
  const update = (part: Partial<Look>) => {
    change({ ...look, ...part });
  };
  const named = (names: readonly string[], labels: Record<string, string> = {}) =>
    names.map((name) => ({ value: name, label: labels[name] ?? name }));

  const structures = kinds.map((kind) => ({ value: kind.name, label: kind.name, title: kind.help }));
  const structure = selectField("Structure", structures, (value) =>
    update({ structure: value, build: {}, kernel: {} }),
  );
  const traversal = selectField("Traversal", [], (value) => update({ traversal: value, kernel: {} }));
  const mode = selectField("Mode", named(MODES, MODE_NAMES), (value) => update({ mode: value as Look["mode"] }));
  const depth = numberField("Depth", 2, { min: 0, max: 16 }, (value) => update({ depth: value }));
  const tier = selectField("Accuracy", named(["strict", "fast"]), (value) => update({ tier: value as Look["tier"] }));
  const output = selectField("Show", named(OUTPUTS, OUTPUT_NAMES), (value) =>
    update({ output: value as Look["output"] }),
  );
  const lights = selectField("Lights", [], (value) => update({ lights: value === ALL ? null : Number(value) }));
  const build = optionFields("Build options", (value) => update({ build: value }));
  const kernel = optionFields("Kernel options", (value) => update({ kernel: value }));

  const element = h(
    "div",
    { class: "panel" },
    h(
      "div",
      { class: "fields" },
      structure.element,
      traversal.element,
      mode.element,
      depth.element,
      lights.element,
      tier.element,
    ),
    parts.output ? h("div", { class: "fields" }, output.element) : null,
    build.element,
    kernel.element,
  );
  return {
    element,
    show: (wanted, scene) => {
      look = wanted;
      const kind = kinds.find((one) => one.name === look.structure);
      const names = traversalsOf(kinds, look.structure);
      const chosen = kind?.traversals.find((one) => one.name === look.traversal);
      structure.set(look.structure);
      traversal.offer(
        names.map((name) => ({
          value: name,
          label: name,
          title: kind?.traversals.find((t) => t.name === name)?.help ?? "",
        })),
      );
      traversal.set(look.traversal);
      mode.set(look.mode);
      depth.set(look.depth);
      depth.element.hidden = look.mode !== "whitted";
      tier.set(look.tier);
      output.set(look.output);
      lights.offer(lightChoices(scene?.lights ?? 0));
      lights.set(look.lights === null || look.lights >= (scene?.lights ?? 0) ? ALL : String(look.lights));
      build.show(kind?.options ?? [], look.build);
      kernel.show(chosen?.options ?? [], look.kernel);
    },
  };
}
