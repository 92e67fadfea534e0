// Whether the daemon is there: from every request, and while nothing is asked from a look every few seconds.
import { onContact } from "../api/http.ts";
import { keepToken } from "../api/token.ts";
import { h, say } from "../ui/dom.ts";
import { dismiss, notice } from "../ui/notice.ts";

const LOOK_MS = 4000;
const RETRY_MS = 700;

type State = "here" | "lost" | "refused";

export class Connection {
  readonly element = h("span", { class: "connection", role: "status" });
  private state: State = "here";
  private readonly back: () => void;

  constructor(back: () => void) {
    this.back = back;
    onContact((contact) => this.become(contact === "answered" ? "here" : contact === "refused" ? "refused" : "lost"));
    this.write();
    void this.watch();
  }

  private become(state: State): void {
    if (state === this.state || (this.state === "refused" && state === "here")) return;
    const before = this.state;
    this.state = state;
    this.write();
    if (state === "lost") notice("connection", "error", "The daemon does not answer. This page tries again by itself.");
    if (state === "refused") this.askForToken();
    if (state === "here" && before === "lost") {
      dismiss("connection");
      this.back();
    }
  }

  private write(): void {
    this.element.dataset.state = this.state;
    say(this.element, this.state === "here" ? "connected" : this.state === "lost" ? "no daemon" : "no access");
  }

  private async watch(): Promise<void> {
    for (;;) {
      await new Promise((done) => setTimeout(done, this.state === "lost" ? RETRY_MS : LOOK_MS));
      if (document.visibilityState === "hidden" && this.state !== "lost") continue;
      try {
        const answer = await fetch("/readyz", { cache: "no-store" });
        if (answer.ok && this.state === "lost") this.become("here");
      } catch {
        this.become("lost");
      }
    }
  }

  private askForToken(): void {
    const field = h("input", { type: "password", id: "token", autocomplete: "off", required: true });
    const form = h(
      "form",
      { class: "notice error", id: "token-form" },
      h("label", { for: "token" }, "The daemon refused the request. Access token:"),
      field,
      h("button", { type: "submit" }, "Use it"),
    );
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      keepToken(field.value.trim());
      form.remove();
      this.state = "here";
      this.write();
      this.back();
    });
    document.getElementById("token-form")?.remove();
    document.getElementById("notices")?.append(form);
  }
}
