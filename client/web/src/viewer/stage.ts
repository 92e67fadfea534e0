// A viewer on the page: it makes resident what is to be shown, follows its size, and says what is wrong.
import { isAbort, isEvicted, Problem } from "../api/errors.ts";
import { readyStructure, residentScene } from "../api/prepare.ts";
import type { Scene } from "../api/types.ts";
import { h, say } from "../ui/dom.ts";
import { dismiss, notice, noticeOf, noticeOfEvicted } from "../ui/notice.ts";
import type { Extent } from "./camera.ts";
import type { Look } from "./choice.ts";
import { type Drawn, Viewer } from "./viewer.ts";

/** Side in pixels of a square image, or 0 for what fits the page. */
export type Side = number;

export interface StageEvents {
  /** The scene is resident: its camera and extent are known. */
  loaded(scene: Scene): Promise<void>;
  drawn(frame: Drawn): void;
  /** The camera cannot be rendered: go back to the first view. */
  home(): void;
  /** What was shown is not resident any more and is wanted again. */
  evicted(): void;
}

const RETRY_MS = 500;
const EVICTED = "evicted"; // one message, however many stages a page has
const LARGEST_SIDE = 2048;

export class Stage {
  readonly viewer: Viewer;
  readonly element: HTMLElement;
  readonly canvas: HTMLCanvasElement;
  private readonly subject: string;
  private readonly events: StageEvents;
  private readonly status = h("p", { class: "stage-status", role: "status" });
  private readonly watch: ResizeObserver;
  private preparing = new AbortController();
  private look: Look | null = null;
  private side: Side = 0;

  constructor(subject: string, label: string, events: StageEvents) {
    this.subject = subject;
    this.events = events;
    this.viewer = new Viewer({
      drawn: (frame) => this.drawn(frame),
      waiting: () => this.say("Waiting for the device …"),
      failed: (error) => this.failed(error),
    });
    this.canvas = this.viewer.canvas;
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "application");
    this.canvas.setAttribute("aria-label", label);
    this.element = h("div", { class: "stage" }, this.canvas, this.status);
    this.watch = new ResizeObserver(() => this.measure());
    this.watch.observe(this.element);
  }

  /** Loads, builds and shows; a later call wins. */
  async present(look: Look): Promise<void> {
    this.preparing.abort();
    this.preparing = new AbortController();
    const { signal } = this.preparing;
    this.look = look;
    this.viewer.show(null);
    try {
      this.say(`Loading ${look.scene} …`);
      const scene = await residentScene(look.scene, signal);
      await this.events.loaded(scene);
      this.say(`Building ${look.structure} …`);
      const structure = await readyStructure(look.scene, look.structure, look.build, signal);
      if (signal.aborted) return;
      this.say("");
      for (const subject of [this.subject, EVICTED]) dismiss(subject);
      const { scene: name, traversal, kernel, tier, mode, depth, output } = look;
      const lights = look.lights === null ? {} : { lights: look.lights };
      this.viewer.show({
        scene: name,
        structure: structure.id,
        traversal,
        kernel,
        tier,
        mode,
        depth,
        output,
        ...lights,
      });
    } catch (error) {
      if (isAbort(error) || signal.aborted) return;
      this.say("Nothing to show.");
      noticeOf(this.subject, error, { label: "Try again", run: () => this.again() });
    }
  }

  /** Prepares what was shown once more. */
  again(): void {
    if (this.look !== null) void this.present(this.look);
  }

  resize(side: Side): void {
    this.side = side;
    this.measure();
  }

  close(): void {
    this.preparing.abort();
    this.watch.disconnect();
    this.viewer.close();
    for (const subject of [this.subject, `${this.subject}-frame`, EVICTED]) dismiss(subject);
  }

  private measure(): void {
    const { clientWidth, clientHeight } = this.element;
    if (clientWidth === 0 || clientHeight === 0) return;
    const dense = Math.min(window.devicePixelRatio, 2);
    const fit = Math.min(1, LARGEST_SIDE / (dense * Math.max(clientWidth, clientHeight)));
    const width = this.side || Math.round(clientWidth * dense * fit);
    const height = this.side || Math.round(clientHeight * dense * fit);
    this.viewer.resize({ width, height });
  }

  private drawn(frame: Drawn): void {
    dismiss(`${this.subject}-frame`);
    this.say("");
    this.canvas.dataset.frames = String(Number(this.canvas.dataset.frames ?? 0) + 1);
    this.canvas.dataset.quality = frame.full ? "full" : "fast";
    this.canvas.dispatchEvent(new CustomEvent("drawn", { detail: frame, bubbles: true }));
    this.events.drawn(frame);
  }

  private failed(error: unknown): void {
    const subject = `${this.subject}-frame`;
    if (isEvicted(error)) {
      this.viewer.show(null);
      this.say("Not resident any more.");
      noticeOfEvicted(EVICTED, this.look?.scene ?? "this scene", () => this.events.evicted());
    } else if (error instanceof Problem && error.code === "invalid_camera") {
      notice(subject, "error", error.message, { label: "First view", run: () => this.events.home() });
    } else {
      noticeOf(subject, error);
      if (error instanceof Problem && error.retryable) setTimeout(() => this.viewer.again(), RETRY_MS);
    }
  }

  private say(text: string): void {
    say(this.status, text);
    this.element.dataset.state = text === "" ? "shown" : "waiting";
  }
}

/** The ball around a scene; a unit ball where it is empty. */
export function extentOf(scene: Scene): Extent {
  const [lo, hi] = [scene.bounds?.lo ?? [-1, -1, -1], scene.bounds?.hi ?? [1, 1, 1]];
  const at = (axis: number) => [lo[axis] ?? 0, hi[axis] ?? 0] as const;
  const middle = (axis: number) => (at(axis)[0] + at(axis)[1]) / 2;
  const half = (axis: number) => (at(axis)[1] - at(axis)[0]) / 2;
  const radius = Math.hypot(half(0), half(1), half(2));
  return { centre: [middle(0), middle(1), middle(2)], radius: radius > 0 ? radius : 1 };
}
