// Walkthrough: the scene's path, frame by frame, and what each technique takes for it.
import { isEvicted } from "../api/errors.ts";
import { getKinds, isOffered, listScenes } from "../api/resources.ts";
import type { Mode, Scene } from "../api/types.ts";
import type { OpenPage, Page } from "../app/page.ts";
import { replaceAddress } from "../app/router.ts";
import { Plot } from "../charts/plot.ts";
import { quantileOf } from "../charts/statistics.ts";
import { nameOf, type Technique, techniquesOf } from "../techniques.ts";
import { fill, h, put, say } from "../ui/dom.ts";
import { numberField, selectField } from "../ui/fields.ts";
import { count, figure } from "../ui/format.ts";
import { dismiss, noticeOf, noticeOfEvicted } from "../ui/notice.ts";
import { type TechniqueList, techniqueList } from "../ui/techniqueList.ts";
import { MODES } from "../viewer/choice.ts";
import { Player, type Walk } from "../walk/player.ts";

const SIZES = ["128", "256", "512", "1024"];
const FIRST = ["bvh/while-while", "kdtree/short-stack-3", "grid/dda"];

class Walkthrough implements Page {
  private readonly canvas = h("canvas", { class: "view still", role: "img", "aria-label": "Frame of the walkthrough" });
  private readonly status = h("p", { class: "stage-status", role: "status" });
  private readonly position = h("output", { class: "position" });
  private readonly slider = h("input", { type: "range", min: 0, value: 0, "aria-label": "Frame" });
  private readonly playButton = h("button", { type: "button", class: "primary" }, "Play");
  private readonly plot = new Plot(
    "Trace time of each frame, one line a technique; the table has the figures",
    "frame",
    "trace ms",
  );
  private readonly rows = h("tbody");
  private readonly times = new Map<string, (number | null)[]>();
  private readonly scene = selectField("Scene", [], () => this.change());
  private readonly mode = selectField(
    "Mode",
    MODES.map((value) => ({ value, label: value })),
    () => this.change(),
  );
  private readonly size = selectField(
    "Size",
    SIZES.map((value) => ({ value, label: `${value} × ${value}` })),
    () => this.change(),
  );
  private readonly frames = numberField("Frames", 60, { min: 2, max: 2000 }, () => this.change());
  private readonly seen = selectField("Image of", [], (name) => this.see(name));
  private readonly list = h("div");
  private all: Technique[] = [];
  private techniques: TechniqueList | null = null;
  private scenes: Scene[] = [];
  private readonly player: Player;
  private readonly wanted: URLSearchParams;
  private isDrawing = false;
  private wasPlaying = false;

  constructor(root: HTMLElement, parameters: URLSearchParams) {
    this.wanted = parameters;
    const walk: Walk = { scene: "bunny", frames: 60, side: 256, mode: "shadow", techniques: [], shown: "" };
    this.player = new Player(walk, {
      doing: (what) => say(this.status, what),
      traced: (technique, frame, ms, image) => this.traced(technique, frame, ms, image),
      at: (frame) => this.at(frame),
      ended: () => this.showPlaying(),
      failed: (error, wasPlaying) => this.failed(error, wasPlaying),
    });
    this.size.set("256");
    this.playButton.addEventListener("click", () => (this.player.isPlaying ? this.pause() : this.play()));
    this.slider.addEventListener("input", () => this.player.seek(this.slider.valueAsNumber));
    put(root, [h("h1", { class: "hidden" }, "Walkthrough"), this.settings(), this.view(), this.figures()]);
    void this.start();
  }

  recover(): void {
    dismiss("walkthrough");
    if (this.techniques === null) void this.start();
    else if (this.wasPlaying) this.play();
    else this.player.seek(this.player.frame);
  }

  close(): void {
    this.player.close();
    this.plot.close();
    dismiss("walkthrough");
  }

  private settings(): HTMLElement {
    const fields = [this.scene, this.mode, this.size, this.frames, this.seen].map((field) => field.element);
    return h("aside", { class: "side", "aria-label": "Settings" }, h("div", { class: "fields" }, ...fields), this.list);
  }

  private view(): HTMLElement {
    return h(
      "section",
      { class: "stage-box", "aria-label": "View" },
      h("div", { class: "stage" }, this.canvas, this.status),
      h("div", { class: "toolbar player" }, this.playButton, this.slider, this.position),
    );
  }

  private figures(): HTMLElement {
    const heads = ["Technique", "Frames", "Median ms", "p95 ms", "Mpixels/s"];
    const head = heads.map((name, at) => h("th", { scope: "col", class: at > 0 ? "number" : null }, name));
    return h(
      "section",
      { class: "card wide", "aria-label": "Times" },
      this.plot.element,
      h(
        "div",
        { class: "scroll", tabindex: 0, role: "region", "aria-label": "Table of times" },
        h("table", {}, h("thead", {}, h("tr", {}, ...head)), this.rows),
      ),
    );
  }

  private async start(): Promise<void> {
    try {
      const [kinds, scenes] = await Promise.all([getKinds(), listScenes()]);
      this.scenes = scenes.filter(isOffered);
      this.all = techniquesOf(kinds);
    } catch (error) {
      noticeOf("walkthrough", error, { label: "Try again", run: () => void this.start() });
      return;
    }
    this.scene.offer(this.scenes.map((scene) => ({ value: scene.name, label: scene.name })));
    const asked = this.wanted.get("techniques")?.split(",") ?? FIRST;
    this.techniques = techniqueList(this.all, asked, () => this.change());
    fill(this.list, this.techniques.element);
    const name = this.wanted.get("scene") ?? "bunny";
    this.scene.set(this.scenes.some((scene) => scene.name === name) ? name : (this.scenes[0]?.name ?? ""));
    this.mode.set(MODES.find((mode) => mode === this.wanted.get("mode")) ?? "shadow");
    const size = this.wanted.get("size") ?? "256";
    this.size.set(SIZES.includes(size) ? size : "256");
    const frames = Number(this.wanted.get("frames") ?? "60");
    this.frames.set(Number.isInteger(frames) && frames >= 2 && frames <= 2000 ? frames : 60);
    this.change();
  }

  /** Other settings: other times. */
  private change(): void {
    const techniques = this.techniques?.chosen() ?? [];
    const names = techniques.map(nameOf);
    this.seen.offer(names.map((name) => ({ value: name, label: name })));
    const walk: Walk = {
      scene: this.scene.value(),
      frames: this.frames.value(),
      side: Number(this.size.value()),
      mode: this.mode.value() as Mode,
      techniques,
      shown: this.seen.value(),
    };
    this.player.change(walk);
    this.wasPlaying = false;
    this.times.clear();
    for (const name of names) this.times.set(name, Array(walk.frames).fill(null));
    this.plot.show(names.map((name) => ({ name, colour: this.colour(name) })));
    this.slider.max = String(walk.frames - 1);
    this.playButton.disabled = techniques.length === 0;
    this.showPlaying();
    this.draw();
    const { scene, mode, side, frames } = walk;
    replaceAddress("walkthrough", {
      scene,
      mode,
      size: String(side),
      frames: String(frames),
      techniques: names.join(","),
    });
    if (techniques.length > 0) this.player.seek(this.player.frame);
  }

  /** The image of another technique; the times stay. */
  private see(name: string): void {
    this.player.walk.shown = name;
    this.player.seek(this.player.frame);
  }

  private colour(name: string): number {
    return this.all.findIndex((technique) => nameOf(technique) === name);
  }

  private play(): void {
    this.wasPlaying = false;
    this.player.play();
    this.showPlaying();
  }

  private pause(): void {
    this.player.pause();
    this.showPlaying();
  }

  private showPlaying(): void {
    say(this.playButton, this.player.isPlaying ? "Pause" : "Play");
  }

  private at(frame: number): void {
    if (this.slider.valueAsNumber !== frame) this.slider.value = String(frame);
    say(this.position, `${frame + 1} of ${this.player.walk.frames}`);
  }

  private traced(technique: string, frame: number, ms: number, image: ImageBitmap | null): void {
    dismiss("walkthrough");
    const times = this.times.get(technique);
    if (times !== undefined) times[frame] = ms;
    if (image !== null) {
      if (this.canvas.width !== image.width) [this.canvas.width, this.canvas.height] = [image.width, image.height];
      this.canvas.getContext("2d", { alpha: false })?.drawImage(image, 0, 0);
      image.close();
      this.canvas.dataset.frame = String(frame);
    }
    if (this.isDrawing) return;
    this.isDrawing = true;
    requestAnimationFrame(() => this.draw());
  }

  private draw(): void {
    this.isDrawing = false;
    const lines = [...this.times.values()];
    this.plot.set(
      Array.from({ length: this.player.walk.frames }, (_, at) => at),
      lines,
    );
    const pixels = this.player.walk.side ** 2;
    const rows = [...this.times].map(([name, times]) => {
      const known = times.filter((time) => time !== null);
      const median = quantileOf(known, 0.5);
      const numbers = [median, quantileOf(known, 0.95), pixels / median / 1000];
      return h(
        "tr",
        {},
        h("th", { scope: "row" }, h("i", { class: `key c${this.colour(name) % 8}` }), name),
        h("td", { class: "number" }, count(known.length)),
        ...numbers.map((number) => h("td", { class: "number" }, figure(number))),
      );
    });
    fill(this.rows, ...rows);
  }

  private failed(error: unknown, wasPlaying: boolean): void {
    this.wasPlaying ||= wasPlaying;
    this.showPlaying();
    say(this.status, "");
    const run = () => this.recover();
    if (isEvicted(error)) noticeOfEvicted("walkthrough", this.player.walk.scene, run);
    else noticeOf("walkthrough", error, { label: "Try again", run });
  }
}

export const openWalkthrough: OpenPage = (root, parameters) => new Walkthrough(root, parameters);
