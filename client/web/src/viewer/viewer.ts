// A canvas that shows a scene from a camera. One request is under way at most, and the newest camera wins: low
// resolution while it moves, full when it is still.
import { isAbort } from "../api/errors.ts";
import { fetchImage, JPEG, PNG, type Timing } from "../api/frames.ts";
import type { FrameRequest } from "../api/types.ts";
import { h } from "../ui/dom.ts";
import { cameraOf, type Pose } from "./camera.ts";
import { Quality } from "./quality.ts";

/** What is shown, apart from camera and size. */
export type Settings = Omit<FrameRequest, "camera" | "width" | "height">;

export interface Size {
  width: number;
  height: number;
}

/** One image that was drawn. */
export interface Drawn {
  timing: Timing;
  size: Size;
  full: boolean; // the resolution of the canvas
  latencies: number[]; // ms from each change of the camera that it is the first to show
}

export interface Events {
  drawn(frame: Drawn): void;
  /** A request is under way for long: the device does something else. */
  waiting(): void;
  failed(error: unknown): void;
}

const STILL_MS = 150;
const LONG_MS = 1500;

export class Viewer {
  readonly canvas = h("canvas", { class: "view", width: 8, height: 8 });
  private readonly context = this.canvas.getContext("2d", { alpha: false });
  private readonly quality = new Quality();
  private readonly events: Events;
  private settings: Settings | null = null;
  private pose: Pose | null = null;
  private size: Size = { width: 0, height: 0 };
  private wanted: "nothing" | "fast" | "full" = "nothing";
  private busy = false;
  private gone = new AbortController();
  private still: ReturnType<typeof setTimeout> | undefined;
  private changes: number[] = [];

  constructor(events: Events) {
    this.events = events;
  }

  /** What to show; null stops asking, as while a structure is built. */
  show(settings: Settings | null): void {
    this.settings = settings;
    this.quality.forget();
    this.gone.abort();
    this.gone = new AbortController();
    this.want("full");
  }

  /** The camera moved: `now` for one that jumps, else it may still be moving. */
  look(pose: Pose, now = false): void {
    this.pose = pose;
    this.changes.push(performance.now());
    clearTimeout(this.still);
    if (!now) this.still = setTimeout(() => this.want("full"), STILL_MS);
    this.want(now ? "full" : "fast");
  }

  /** Pixels of the image at rest. */
  resize(size: Size): void {
    if (size.width === this.size.width && size.height === this.size.height) return;
    this.size = size;
    this.want("full");
  }

  /** Asks once more, as after a failure. */
  again(): void {
    this.want("full");
  }

  /** The request for what is shown at rest; null when there is nothing. */
  request(): FrameRequest | null {
    if (this.settings === null || this.pose === null || this.size.width < 1) return null;
    return { ...this.settings, camera: cameraOf(this.pose), ...this.size };
  }

  close(): void {
    clearTimeout(this.still);
    this.settings = null;
    this.gone.abort();
  }

  private want(what: "fast" | "full"): void {
    if (what === "full" || this.wanted === "nothing") this.wanted = what;
    if (what === "fast" && this.wanted === "full") this.wanted = "fast";
    if (!this.busy) void this.work();
  }

  private async work(): Promise<void> {
    this.busy = true;
    while (this.wanted !== "nothing") {
      const request = this.request();
      const full = this.wanted === "full";
      this.wanted = "nothing";
      if (request === null) break;
      const long = setTimeout(() => this.events.waiting(), LONG_MS);
      try {
        await this.frame(request, full, this.gone.signal);
      } catch (error) {
        if (!isAbort(error)) this.events.failed(error);
      }
      clearTimeout(long);
    }
    this.busy = false;
  }

  private async frame(request: FrameRequest, full: boolean, signal: AbortSignal): Promise<void> {
    const pixels = this.size.width * this.size.height;
    const scale = full ? 1 : this.quality.movingScale(pixels);
    const size = { width: Math.ceil(this.size.width * scale), height: Math.ceil(this.size.height * scale) };
    const included = this.changes.splice(0);
    const start = performance.now();
    const exact = request.output === "id" && full; // JPEG would mix neighbouring ids
    const { content, timing } = await fetchImage({ ...request, ...size }, exact ? PNG : JPEG, signal);
    const bitmap = await createImageBitmap(content);
    if (signal.aborted) return bitmap.close();
    this.draw(bitmap);
    const now = performance.now();
    this.quality.learn(size.width * size.height, now - start);
    this.events.drawn({ timing, size, full: scale === 1, latencies: included.map((time) => now - time) });
  }

  private draw(bitmap: ImageBitmap): void {
    const { canvas, context } = this;
    if (canvas.width !== this.size.width || canvas.height !== this.size.height) {
      canvas.width = this.size.width;
      canvas.height = this.size.height;
    }
    context?.drawImage(bitmap, 0, 0, canvas.width, canvas.height);
    bitmap.close();
  }
}
