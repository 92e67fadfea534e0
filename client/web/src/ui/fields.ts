// Labelled controls.
import { h } from "./dom.ts";

export interface Choice {
  value: string;
  label: string;
  title?: string;
}

export interface Field<T> {
  element: HTMLElement;
  value(): T;
  set(value: T): void;
}

let made = 0;

function labelled(label: string, control: HTMLElement): HTMLElement {
  made += 1;
  control.id ||= `field-${made}`;
  return h("div", { class: "field" }, h("label", { for: control.id }, label), control);
}

export interface SelectField extends Field<string> {
  offer(choices: Choice[]): void;
}

export function selectField(label: string, choices: Choice[], change: (value: string) => void): SelectField {
  const select = h("select", { onchange: () => change(select.value) });
  const offer = (offered: Choice[]) => {
    const before = select.value;
    select.replaceChildren(
      ...offered.map((choice) => h("option", { value: choice.value, title: choice.title ?? null }, choice.label)),
    );
    if (offered.some((choice) => choice.value === before)) select.value = before;
  };
  offer(choices);
  return {
    element: labelled(label, select),
    value: () => select.value,
    set: (value) => {
      select.value = value;
    },
    offer,
  };
}

interface Range {
  min: number;
  max: number;
  step?: number | "any";
}

/** A number; what is out of range or no number is put back to the last good one. */
export function numberField(
  label: string,
  value: number,
  range: Range,
  change: (value: number) => void,
): Field<number> {
  let good = value;
  const input = h("input", { type: "number", value, min: range.min, max: range.max, step: range.step ?? 1 });
  input.addEventListener("change", () => {
    const given = input.valueAsNumber;
    if (input.validity.valid && Number.isFinite(given)) {
      good = given;
      change(given);
    } else input.valueAsNumber = good;
  });
  return {
    element: labelled(label, input),
    value: () => good,
    set: (wanted) => {
      good = wanted;
      input.valueAsNumber = wanted;
    },
  };
}

export function checkField(label: string, value: boolean, change: (value: boolean) => void): Field<boolean> {
  const input = h("input", { type: "checkbox", checked: value, onchange: () => change(input.checked) });
  return {
    element: h("label", { class: "check" }, input, h("span", {}, label)),
    value: () => input.checked,
    set: (wanted) => {
      input.checked = wanted;
    },
  };
}

/** A few choices side by side, of which one holds. */
export function segments(label: string, choices: Choice[], change: (value: string) => void): Field<string> {
  made += 1;
  const name = `segments-${made}`;
  const inputs = choices.map((choice, at) =>
    h("input", { type: "radio", name, value: choice.value, checked: at === 0, onchange: () => change(choice.value) }),
  );
  const options = choices.map((choice, at) =>
    h("label", { title: choice.title ?? null }, inputs[at], h("span", {}, choice.label)),
  );
  return {
    element: h("fieldset", { class: "segments" }, h("legend", {}, label), h("div", {}, ...options)),
    value: () => inputs.find((input) => input.checked)?.value ?? "",
    set: (value) => {
      for (const input of inputs) input.checked = input.value === value;
    },
  };
}
