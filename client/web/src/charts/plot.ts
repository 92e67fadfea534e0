// A line chart in the page's colours, as wide as its place.
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { h } from "../ui/dom.ts";
import { figure } from "../ui/format.ts";

export interface Line {
  name: string;
  colour: number; // of the palette
}

const HEIGHT = 240;

/** What a CSS colour variable is on this page. */
function colourOf(element: Element, variable: string): string {
  const probe = document.createElement("i");
  probe.hidden = true;
  probe.style.color = `var(${variable})`;
  element.append(probe);
  const colour = getComputedStyle(probe).color;
  probe.remove();
  return colour;
}

export class Plot {
  readonly element: HTMLElement;
  private readonly xLabel: string;
  private readonly yLabel: string;
  private readonly watch: ResizeObserver;
  private readonly redraw = () => this.draw();
  private readonly dark = matchMedia("(prefers-color-scheme: dark)");
  private chart: uPlot | null = null;
  private lines: Line[] = [];
  private data: uPlot.AlignedData = [[]];

  /** `label` says what is plotted, to those who do not see it. */
  constructor(label: string, xLabel: string, yLabel: string) {
    this.element = h("div", { class: "plot", role: "img", "aria-label": label });
    this.xLabel = xLabel;
    this.yLabel = yLabel;
    this.watch = new ResizeObserver(() => this.fit());
    this.watch.observe(this.element);
    document.addEventListener("themechange", this.redraw);
    this.dark.addEventListener("change", this.redraw);
  }

  close(): void {
    this.watch.disconnect();
    document.removeEventListener("themechange", this.redraw);
    this.dark.removeEventListener("change", this.redraw);
    this.chart?.destroy();
  }

  /** Other lines; their values follow with `set`. */
  show(lines: Line[]): void {
    this.lines = lines;
    this.data = [[], ...lines.map(() => [])];
    this.draw();
  }

  /** `values` has one array a line; null is a gap. */
  set(x: number[], values: (number | null)[][]): void {
    this.data = [x, ...values];
    this.chart?.setData(this.data);
  }

  private fit(): void {
    if (this.chart === null) this.draw();
    else this.chart.setSize({ width: this.element.clientWidth, height: HEIGHT });
  }

  private draw(): void {
    this.chart?.destroy();
    this.chart = null;
    const width = this.element.clientWidth;
    if (width === 0 || this.lines.length === 0) return;
    const [text, line] = [colourOf(this.element, "--muted"), colourOf(this.element, "--line")];
    const axis = (label: string): uPlot.Axis => ({
      label,
      labelSize: 22,
      labelFont: "12px system-ui, sans-serif",
      font: "12px system-ui, sans-serif",
      stroke: text,
      grid: { stroke: line, width: 1 },
      ticks: { stroke: line, width: 1 },
    });
    const series = this.lines.map((one): uPlot.Series => ({
      label: one.name,
      stroke: colourOf(this.element, `--c${one.colour % 8}`),
      width: 1.5,
      points: { show: false },
      value: (_, value) => (value === null ? "–" : figure(value)),
    }));
    const options: uPlot.Options = {
      width,
      height: HEIGHT,
      scales: { x: { time: false }, y: { range: (_, __, max) => [0, (max ?? 1) * 1.08 || 1] } },
      axes: [axis(this.xLabel), { ...axis(this.yLabel), size: 56 }],
      series: [{ label: this.xLabel }, ...series],
      legend: { live: true },
      cursor: { y: false },
    };
    this.chart = new uPlot(options, this.data, this.element);
  }
}
