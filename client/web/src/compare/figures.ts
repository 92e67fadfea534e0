// Tables beside two images: how they differ, and the figures of one pixel.
import { fill, h } from "../ui/dom.ts";
import { count, figure } from "../ui/format.ts";
import type { ColourFigures, IdFigures } from "./difference.ts";
import type { Measured } from "./measured.ts";

export interface Pixel {
  x: number;
  y: number;
}

function row(name: string, ...values: string[]): HTMLElement {
  return h("tr", {}, h("th", { scope: "row" }, name), ...values.map((value) => h("td", { class: "number" }, value)));
}

export class Figures {
  private readonly whole = h("tbody");
  private readonly pixel = h("tbody");
  private readonly where = h("caption", {}, "Point at a pixel");
  readonly element: HTMLElement;

  constructor() {
    const heads = h("tr", {}, h("td"), ...["A", "B"].map((side) => h("th", { scope: "col", class: "number" }, side)));
    this.element = h(
      "section",
      { class: "card figures", "aria-label": "Figures" },
      h("table", {}, h("caption", {}, "Difference"), this.whole),
      h("table", { class: "pixel" }, this.where, h("thead", {}, heads), this.pixel),
    );
    this.waiting();
    this.showPixel(null, null, null);
  }

  waiting(): void {
    delete this.element.dataset.mismatches;
    const names = ["Other triangles", "Ties", "Changed pixels", "Largest difference", "RMSE", "Trace A", "Trace B"];
    fill(this.whole, ...names.map((name) => row(name, "…")));
  }

  show(ids: IdFigures, colours: ColourFigures, a: Measured, b: Measured): void {
    const share = (number: number) => `${count(number)} (${figure((1e6 * number) / ids.pixels)} ppm)`;
    fill(
      this.whole,
      row("Other triangles", share(ids.mismatches)),
      row("Ties", share(ids.ties)),
      row("Changed pixels", share(colours.changed)),
      row("Largest difference", `${figure(colours.max)} levels`),
      row("RMSE", colours.rmse === 0 ? "0" : colours.rmse.toExponential(2)),
      row("Trace A", `${figure(a.traceMs)} ms`),
      row("Trace B", `${figure(b.traceMs)} ms, ${figure(b.traceMs / Math.max(a.traceMs, 1e-6))} × A`),
    );
    this.element.dataset.mismatches = String(ids.mismatches);
    this.element.dataset.changed = String(colours.changed);
  }

  showPixel(pixel: Pixel | null, a: Measured | null, b: Measured | null): void {
    const sides = [a, b];
    const cell = (value: (side: Measured, at: number) => string) =>
      sides.map((side) => (side === null || pixel === null ? "–" : value(side, pixel.y * side.width + pixel.x)));
    this.where.textContent = pixel === null ? "Point at a pixel" : `Pixel ${pixel.x}, ${pixel.y}`;
    const colour = (side: Measured, at: number) =>
      [0, 1, 2].map((channel) => (side.colour[3 * at + channel] ?? 0).toFixed(3)).join(" ");
    fill(
      this.pixel,
      row("triangle", ...cell((side, at) => ((side.id[at] ?? -1) < 0 ? "miss" : count(side.id[at] ?? 0)))),
      row("distance", ...cell((side, at) => (Number.isFinite(side.t[at]) ? String(side.t[at]?.toPrecision(7)) : "–"))),
      row("steps", ...cell((side, at) => count(side.steps[at] ?? 0))),
      row("tests", ...cell((side, at) => count(side.tests[at] ?? 0))),
      row("linear RGB", ...cell(colour)),
    );
  }
}
