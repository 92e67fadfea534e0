// The form that starts a benchmark.
import { isOffered } from "../api/resources.ts";
import type { BenchmarkSpec, Kind, Scene } from "../api/types.ts";
import { techniquesOf } from "../techniques.ts";
import { h } from "../ui/dom.ts";
import { checkField, numberField, selectField } from "../ui/fields.ts";
import { techniqueList } from "../ui/techniqueList.ts";

const MODES = ["trace", "primary", "shadow", "whitted"] as const;
const SIZES = ["128", "256", "512", "1024"];
const TIERS = ["strict", "fast", "auto"] as const;

export interface BenchForm {
  element: HTMLFormElement;
  /** While a submission is under way. */
  lock(locked: boolean): void;
}

export function benchForm(scenes: Scene[], kinds: Kind[], submit: (spec: BenchmarkSpec) => void): BenchForm {
  const offered = scenes.filter(isOffered);
  const scene = selectField(
    "Scene",
    offered.map(({ name }) => ({ value: name, label: name })),
    () => {},
  );
  scene.set(offered.some(({ name }) => name === "bunny") ? "bunny" : (offered[0]?.name ?? ""));
  const size = selectField(
    "Size",
    SIZES.map((value) => ({ value, label: `${value} × ${value}` })),
    () => {},
  );
  size.set("256");
  const tier = selectField(
    "Accuracy",
    TIERS.map((value) => ({ value, label: value })),
    () => {},
  );
  const frames = numberField("Frames", 20, { min: 1, max: 100000 }, () => {});
  const repeats = numberField("Repeats", 1, { min: 1, max: 1000 }, () => {});
  const depth = numberField("Depth", 2, { min: 0, max: 16 }, () => {});
  const limit = numberField("Time limit, s", 300, { min: 1, max: 3600 }, () => {});
  const modes = MODES.map((mode) => checkField(mode, mode === "primary" || mode === "shadow", () => check()));
  const all = techniquesOf(kinds);
  const techniques = techniqueList(
    all,
    all.map((one) => `${one.structure}/${one.traversal}`),
    () => check(),
  );
  const button = h("button", { type: "submit", class: "primary" }, "Start benchmark");
  const chosenModes = () => MODES.filter((_, at) => modes[at]?.value() === true);
  let isLocked = false;
  const check = () => {
    button.disabled = isLocked || chosenModes().length === 0 || techniques.chosen().length === 0;
  };
  const numbers = [scene, size, frames, repeats, tier, depth, limit].map((field) => field.element);
  const element = h(
    "form",
    { class: "card bench-form", "aria-label": "New benchmark" },
    h("h2", {}, "New benchmark"),
    h("div", { class: "fields" }, ...numbers),
    h("fieldset", { class: "row" }, h("legend", {}, "Modes"), ...modes.map((mode) => mode.element)),
    techniques.element,
    h("p", {}, button),
  );
  element.addEventListener("submit", (event) => {
    event.preventDefault();
    const side = Number(size.value());
    submit({
      scene: scene.value(),
      techniques: techniques.chosen().map((one) => ({ ...one, tier: tier.value() as (typeof TIERS)[number] })),
      modes: chosenModes(),
      depth: depth.value(),
      width: side,
      height: side,
      frames: frames.value(),
      repeats: repeats.value(),
      error_frames: Math.min(4, frames.value()),
      time_limit_s: limit.value(),
    });
  });
  return {
    element,
    lock: (locked) => {
      isLocked = locked;
      check();
    },
  };
}
