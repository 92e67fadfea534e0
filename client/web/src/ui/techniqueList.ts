// Checkboxes for techniques, each with the colour that charts give it.
import { nameOf, type Technique } from "../techniques.ts";
import { h } from "./dom.ts";

export interface TechniqueList {
  element: HTMLElement;
  chosen(): Technique[];
}

/** `chosen` names those that are ticked at first. */
export function techniqueList(techniques: Technique[], chosen: string[], change: () => void): TechniqueList {
  const boxes = techniques.map((technique) =>
    h("input", { type: "checkbox", checked: chosen.includes(nameOf(technique)), onchange: change }),
  );
  const rows = techniques.map((technique, at) =>
    h("label", { class: "check" }, boxes[at], h("i", { class: `key c${at % 8}` }), h("span", {}, nameOf(technique))),
  );
  return {
    element: h("fieldset", { class: "techniques" }, h("legend", {}, "Techniques"), h("div", {}, ...rows)),
    chosen: () => techniques.filter((_, at) => boxes[at]?.checked === true),
  };
}
