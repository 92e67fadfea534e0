// Where the time of the last frame went, and how many frames a second arrive.
import type { Timing } from "../api/frames.ts";
import { h, say } from "../ui/dom.ts";
import { figure } from "../ui/format.ts";

const PARTS = ["queue", "trace", "readback", "encode", "network"] as const;
const WINDOW_MS = 2000;

export class TimingPanel {
  readonly element: HTMLElement;
  private readonly bars = PARTS.map((name) => h("span", { class: `bar ${name}` }));
  private readonly values = PARTS.map(() => h("dd", {}, "–"));
  private readonly rate = h("output", {}, "–");
  private readonly total = h("output", {}, "–");
  private readonly size = h("output", {}, "–");
  private times: number[] = [];

  constructor() {
    const entries = PARTS.map((name, at) =>
      h("div", {}, h("dt", {}, h("i", { class: `key ${name}` }), name), this.values[at]),
    );
    this.element = h(
      "section",
      { class: "timing", "aria-label": "Timing" },
      h("p", { class: "rates" }, this.rate, this.total, this.size),
      h("div", { class: "bars", "aria-hidden": "true" }, ...this.bars),
      h("dl", {}, ...entries),
    );
  }

  show(timing: Timing, width: number, height: number): void {
    const now = performance.now();
    this.times = [...this.times.filter((time) => now - time < WINDOW_MS), now];
    const first = this.times[0] ?? now;
    const rate = this.times.length > 1 ? ((this.times.length - 1) * 1000) / (now - first) : 0;
    say(this.rate, rate > 0 ? `${figure(rate)} frames/s` : "at rest");
    say(this.total, `${figure(timing.total)} ms`);
    say(this.size, `${width} × ${height}`);
    for (const [at, name] of PARTS.entries()) {
      const bar = this.bars[at];
      const value = this.values[at];
      bar?.style.setProperty("flex-grow", String(timing[name] / Math.max(timing.total, 1e-3)));
      if (value !== undefined) say(value, `${timing[name].toFixed(timing[name] < 10 ? 2 : 1)} ms`);
    }
  }
}
