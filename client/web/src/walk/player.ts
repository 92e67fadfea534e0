// Goes through the frames of a walkthrough with several techniques in turns, one request at a time.
import { isAbort } from "../api/errors.ts";
import { type Fetched, fetchImage, JPEG } from "../api/frames.ts";
import { readyStructure, residentScene } from "../api/prepare.ts";
import type { Mode } from "../api/types.ts";
import { nameOf, type Technique } from "../techniques.ts";

export interface Walk {
  scene: string;
  frames: number;
  side: number; // pixels
  mode: Mode;
  techniques: Technique[];
  shown: string; // name of the technique whose images are seen
}

export interface PlayerEvents {
  doing(what: string): void;
  /** A frame was traced; `image` is that of the shown technique. */
  traced(technique: string, frame: number, traceMs: number, image: ImageBitmap | null): void;
  at(frame: number): void;
  ended(): void;
  failed(error: unknown, wasPlaying: boolean): void;
}

export class Player {
  private readonly events: PlayerEvents;
  private stop = new AbortController();
  private isBusy = false;
  private next: number | null = null; // where to go after what is under way
  walk: Walk;
  isPlaying = false;
  frame = 0;

  constructor(walk: Walk, events: PlayerEvents) {
    this.walk = walk;
    this.events = events;
  }

  play(): void {
    if (this.frame >= this.walk.frames - 1) this.frame = 0;
    this.isPlaying = true;
    this.next = this.frame;
    if (!this.isBusy) void this.work();
  }

  pause(): void {
    this.isPlaying = false;
  }

  /** Shows one frame; playing goes on from there. The newest wins. */
  seek(frame: number): void {
    this.next = frame;
    this.events.at(frame);
    if (!this.isBusy) void this.work();
  }

  /** Another walk: what is under way is dropped. */
  change(walk: Walk): void {
    this.stop.abort();
    this.stop = new AbortController();
    this.walk = walk;
    this.isPlaying = false;
    this.frame = Math.min(this.frame, walk.frames - 1);
  }

  close(): void {
    this.isPlaying = false;
    this.stop.abort();
  }

  private async work(): Promise<void> {
    this.isBusy = true;
    const { walk, stop } = this;
    try {
      const structures = await this.prepare(walk, stop.signal);
      while (this.next !== null && walk === this.walk) {
        const frame = this.next;
        this.next = null;
        this.frame = frame;
        this.events.at(frame);
        await this.trace(walk, structures, frame, stop.signal);
        if (!this.isPlaying) continue;
        this.next ??= frame + 1;
        if (this.next >= walk.frames) {
          this.next = null;
          this.isPlaying = false;
          this.events.ended();
        }
      }
    } catch (error) {
      if (!isAbort(error) && walk === this.walk) {
        const wasPlaying = this.isPlaying;
        this.next = null;
        this.isPlaying = false;
        this.events.failed(error, wasPlaying);
      }
    }
    this.isBusy = false;
    if (this.next !== null) void this.work();
  }

  private async prepare(walk: Walk, signal: AbortSignal): Promise<Map<string, string>> {
    const structures = new Map<string, string>();
    this.events.doing(`Loading ${walk.scene} …`);
    await residentScene(walk.scene, signal);
    for (const { structure } of walk.techniques) {
      if (structures.has(structure)) continue;
      this.events.doing(`Building ${structure} …`);
      structures.set(structure, (await readyStructure(walk.scene, structure, {}, signal)).id);
    }
    this.events.doing("");
    return structures;
  }

  /** While it plays every technique, else only the one that is seen. */
  private async trace(walk: Walk, structures: Map<string, string>, frame: number, signal: AbortSignal): Promise<void> {
    for (const technique of walk.techniques) {
      const name = nameOf(technique);
      if (!this.isPlaying && name !== walk.shown) continue;
      const { content, timing }: Fetched<Blob> = await fetchImage(
        {
          scene: walk.scene,
          structure: structures.get(technique.structure) ?? technique.structure,
          traversal: technique.traversal,
          camera: { frame, of: walk.frames },
          width: walk.side,
          height: walk.side,
          mode: walk.mode,
        },
        JPEG,
        signal,
      );
      const image = name === walk.shown ? await createImageBitmap(content) : null;
      if (signal.aborted) return image?.close();
      this.events.traced(name, frame, timing.trace, image);
    }
  }
}
