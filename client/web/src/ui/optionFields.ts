// Controls for options as GET /v1/kinds describes them.
import type { Option, Options } from "../api/types.ts";
import { fill, h } from "./dom.ts";
import { numberField, selectField } from "./fields.ts";

interface OptionField {
  element: HTMLElement;
  set(value: string | number): void;
}

function fieldOf(option: Option, change: (value: string | number) => void): OptionField {
  if (option.choices !== undefined && option.choices.length > 0) {
    const choices = option.choices.map((name) => ({ value: name, label: name }));
    const { element, set } = selectField(option.name, choices, change);
    return { element, set: (value) => set(String(value)) };
  }
  const range = {
    min: option.minimum ?? Number.MIN_SAFE_INTEGER,
    max: option.maximum ?? Number.MAX_SAFE_INTEGER,
    step: option.step ?? (option.integer ? 1 : ("any" as const)),
  };
  const { element, set } = numberField(option.name, Number(option.default), range, change);
  return { element, set: (value) => set(Number(value)) };
}

export interface OptionFields {
  element: HTMLElement;
  /** Shows values; `change` is not called. Controls stay as long as `described` is the same array. */
  show(described: Option[], given: Options): void;
}

/** A folded group with one control an option; `change` gets those that differ from their defaults. */
export function optionFields(title: string, change: (options: Options) => void): OptionFields {
  const box = h("div", { class: "fields" });
  const element = h("details", { class: "options" }, h("summary", {}, title), box);
  let shown: Option[] | null = null;
  let fields: OptionField[] = [];
  let options: Options = {};
  return {
    element,
    show: (described, given) => {
      options = { ...given };
      if (described !== shown) {
        shown = described;
        fields = described.map((option) => {
          const field = fieldOf(option, (value) => {
            if (value === option.default) delete options[option.name];
            else options[option.name] = value;
            change({ ...options });
          });
          field.element.title = option.help;
          return field;
        });
        fill(box, ...fields.map((field) => field.element));
        element.hidden = described.length === 0;
        element.open = Object.keys(given).length > 0;
      }
      for (const [at, option] of described.entries()) fields[at]?.set(given[option.name] ?? option.default);
    },
  };
}
