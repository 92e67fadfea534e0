// Light, dark, or as the system has it.
import { h } from "../ui/dom.ts";

const KEY = "raywalk-theme";
const NAMES = ["auto", "light", "dark"] as const;
type Theme = (typeof NAMES)[number];

function kept(): Theme {
  const name = localStorage.getItem(KEY);
  return NAMES.find((known) => known === name) ?? "auto";
}

function apply(theme: Theme): void {
  if (theme === "auto") delete document.documentElement.dataset.theme;
  else document.documentElement.dataset.theme = theme;
  document.dispatchEvent(new Event("themechange"));
}

/** The switch; it applies what was chosen before. */
export function themeSwitch(): HTMLElement {
  apply(kept());
  const options = NAMES.map((name) => h("option", { value: name, selected: name === kept() }, name));
  return h(
    "select",
    {
      "aria-label": "Colours",
      class: "quiet",
      onchange: (event) => {
        const theme = (event.target as HTMLSelectElement).value as Theme;
        localStorage.setItem(KEY, theme);
        apply(theme);
      },
    },
    ...options,
  );
}
