// One job: what it does now, how long it still takes, and how to stop it.
import type { BenchmarkSpec, Job } from "../api/types.ts";
import { fill, h, say } from "../ui/dom.ts";
import { duration } from "../ui/format.ts";

const ENDED = new Set(["succeeded", "failed", "cancelled", "interrupted"]);

export const hasEnded = (job: Job): boolean => ENDED.has(job.state);

/** What a list calls it. */
export function titleOf(job: Job): string {
  const spec = job.spec as Partial<BenchmarkSpec>;
  return `${job.kind === "accuracy" ? "accuracy " : ""}${spec.scene ?? "hard cases"}`;
}

/** One sentence. */
export function stateText(job: Job): string {
  if (job.state === "queued") return job.position === 0 ? "queued, next" : `queued, ${job.position} before it`;
  if (job.state === "running" || job.state === "validating") {
    const left = job.eta_s === null || job.eta_s === undefined ? "" : `, about ${duration(job.eta_s)} left`;
    return `${job.stage || job.state}${left}`;
  }
  if (job.state === "failed") return `failed: ${job.error?.detail ?? "no cause is known"}`;
  return job.state;
}

export class JobView {
  private readonly title = h("h2");
  private readonly state = h("p", { class: "job-state", role: "status" });
  private readonly bar = h("progress", { max: 1, "aria-label": "Progress" });
  private readonly cancel: HTMLButtonElement;
  private readonly body = h("div");
  readonly element: HTMLElement;

  constructor(cancel: () => void) {
    this.cancel = h("button", { type: "button", class: "danger", onclick: cancel }, "Cancel");
    this.element = h(
      "section",
      { class: "card job", "aria-label": "Job", hidden: true },
      h("div", { class: "toolbar" }, this.title, h("span", { class: "grow" }), this.cancel),
      this.state,
      this.bar,
      this.body,
    );
  }

  show(job: Job): void {
    this.element.hidden = false;
    this.element.dataset.state = job.state;
    say(this.title, `${titleOf(job)} · ${job.id}`);
    say(this.state, stateText(job));
    this.bar.value = job.progress;
    this.bar.hidden = hasEnded(job);
    this.cancel.hidden = hasEnded(job);
  }

  hide(): void {
    this.element.hidden = true;
  }

  content(element: HTMLElement | null): void {
    fill(this.body, element);
  }
}
