// Messages at the top of the page: one for each subject, until it is mended or put away.
import { Problem, sentence } from "../api/errors.ts";
import { h } from "./dom.ts";

interface Action {
  label: string;
  run(): void;
}

const shown = new Map<string, HTMLElement>();

/** Shows a message in place of the last one of `subject`. */
export function notice(subject: string, kind: "error" | "info", text: string, action?: Action): void {
  dismiss(subject);
  const button =
    action && h("button", { type: "button", onclick: () => (dismiss(subject), action.run()) }, action.label);
  const close = h(
    "button",
    { type: "button", class: "quiet", "aria-label": "Dismiss", onclick: () => dismiss(subject) },
    "×",
  );
  const box = h("div", { class: `notice ${kind}`, "data-subject": subject }, h("p", {}, text), button, close);
  shown.set(subject, box);
  document.getElementById("notices")?.append(box);
}

export function dismiss(subject: string): void {
  shown.get(subject)?.remove();
  shown.delete(subject);
}

/** An error as a message; what the connection's own message says is not said twice. */
export function noticeOf(subject: string, error: unknown, action?: Action): void {
  if (error instanceof Error && error.name === "Unreachable") return;
  if (error instanceof Problem && error.status === 401) return;
  notice(subject, "error", sentence(error), action);
}

/** What was shown is not resident any more; `run` gets it again. */
export function noticeOfEvicted(subject: string, scene: string, run: () => void): void {
  notice(subject, "error", `What was shown of ${scene} is not loaded any more.`, { label: "Load it again", run });
}
