// Controls for options as GET /v1/kinds describes them.
import type { Option, Options } from "../api/types.ts";
import { h } from "./dom.ts";
import { numberField, selectField } from "./fields.ts";

function fieldOf(option: Option, options: Options, change: (value: string | number) => void): HTMLElement {
  const value = options[option.name] ?? option.default;
  if (option.choices !== undefined && option.choices.length > 0) {
    const field = selectField(
      option.name,
      option.choices.map((name) => ({ value: name, label: name })),
      change,
    );
    field.set(String(value));
    return field.element;
  }
  const range = {
    min: option.minimum ?? Number.MIN_SAFE_INTEGER,
    max: option.maximum ?? Number.MAX_SAFE_INTEGER,
    step: option.step ?? (option.integer ? 1 : ("any" as const)),
  };
  return numberField(option.name, Number(value), range, change).element;
}

/** A folded group with one control an option; `change` gets those that differ from their defaults. */
export function optionFields(
  title: string,
  described: Option[],
  given: Options,
  change: (options: Options) => void,
): HTMLElement | null {
  if (described.length === 0) return null;
  const options: Options = { ...given };
  const fields = described.map((option) => {
    const field = fieldOf(option, options, (value) => {
      if (value === option.default) delete options[option.name];
      else options[option.name] = value;
      change({ ...options });
    });
    field.title = option.help;
    return field;
  });
  return h(
    "details",
    { class: "options", open: Object.keys(given).length > 0 },
    h("summary", {}, title),
    h("div", { class: "fields" }, ...fields),
  );
}
