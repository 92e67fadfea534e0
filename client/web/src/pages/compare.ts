// Compare: two techniques or settings under one camera, and what they differ in.
import { isAbort } from "../api/errors.ts";
import { firstCamera, getKinds, isOffered, listScenes } from "../api/resources.ts";
import type { Kind, Scene } from "../api/types.ts";
import type { OpenPage, Page } from "../app/page.ts";
import { replaceAddress } from "../app/router.ts";
import { channelsOf, type Sight, SIGHTS } from "../compare/sights.ts";
import { compareColours, compareIds } from "../compare/difference.ts";
import { Figures } from "../compare/figures.ts";
import { heatPixels } from "../compare/heat.ts";
import { type Measured, measure } from "../compare/measured.ts";
import { Overlay } from "../compare/overlay.ts";
import { PixelPicker } from "../compare/pixelPicker.ts";
import { h, put } from "../ui/dom.ts";
import { checkField, segments, selectField } from "../ui/fields.ts";
import { figure } from "../ui/format.ts";
import { dismiss, noticeOf } from "../ui/notice.ts";
import { type Extent, isUsable, type Pose, poseOf } from "../viewer/camera.ts";
import { briefly, known, type Look, lookFromParameters, lookToParameters } from "../viewer/choice.ts";
import { Input } from "../viewer/input.ts";
import { poseFromParameters, poseToParameters } from "../viewer/link.ts";
import { linkedView } from "../viewer/linkedView.ts";
import { type LookPanel, lookPanel } from "../viewer/lookPanel.ts";
import { extentOf, Stage } from "../viewer/stage.ts";

const SIZES = ["256", "384", "512", "768"];

/** One of the two: its stage, its settings, and the figures of what it shows. */
interface Side {
  name: "a" | "b";
  look: Look;
  stage: Stage;
  overlay: Overlay;
  input: Input;
  panel: LookPanel | null;
  box: HTMLElement;
  isStill: boolean;
  measured: Measured | null;
}

class Compare implements Page {
  private readonly sides: [Side, Side];
  private readonly figures = new Figures();
  private readonly images = h("div", { class: "images", "data-sight": "side" });
  private readonly legend = h("p", { class: "legend", hidden: true });
  private readonly wiper = h("input", { type: "range", min: 0, max: 100, value: 50, "aria-label": "Wiper" });
  private readonly scenePick = selectField("Scene", [], (name) => this.choose(name));
  private readonly marks = checkField("Mark other triangles", true, () => this.paint());
  private readonly settings = h("section", { class: "two", "aria-label": "Settings" });
  private sight: Sight = "side";
  private asked: Pose | "bad" | null;
  private pose: Pose | null = null;
  private first: Pose | null = null;
  private extent: Extent = { centre: [0, 0, 0], radius: 1 };
  private collecting = new AbortController();
  private kinds: Kind[] = [];
  private scenes: Scene[] = [];
  private address: ReturnType<typeof setTimeout> | undefined;

  constructor(root: HTMLElement, parameters: URLSearchParams) {
    const a = lookFromParameters(parameters, "a.");
    const b = lookFromParameters(parameters, "b.");
    if (!parameters.has("b.structure")) Object.assign(b, { structure: "kdtree", traversal: "short-stack-3" });
    this.asked = poseFromParameters(parameters);
    this.sides = [this.side("a", a), this.side("b", { ...b, scene: a.scene })];
    new PixelPicker(
      this.sides.map((side) => side.stage.canvas),
      (pixel) => this.figures.showPixel(pixel, this.sides[0].measured, this.sides[1].measured),
    );
    this.wiper.addEventListener("input", () => this.wipe());
    put(this.images, [...this.sides.map((side) => side.box)]);
    put(root, [
      h("h1", { class: "hidden" }, "Compare"),
      this.toolbar(),
      h("div", {}, this.images, this.legend),
      this.figures.element,
      this.settings,
    ]);
    this.wipe();
    void this.start();
  }

  recover(): void {
    if (this.kinds.length === 0) void this.start();
    for (const side of this.sides) side.stage.again();
  }

  close(): void {
    clearTimeout(this.address);
    this.collecting.abort();
    for (const side of this.sides) {
      side.input.close();
      side.stage.close();
    }
    for (const subject of ["compare", "compare-camera"]) dismiss(subject);
  }

  private side(name: "a" | "b", look: Look): Side {
    const label = `View ${name.toUpperCase()}`;
    const stage = new Stage(`compare-${name}`, label, {
      loaded: (scene) => this.loaded(scene),
      drawn: (frame) => {
        const side = this.sides[name === "a" ? 0 : 1];
        side.isStill = frame.full;
        void this.collect();
      },
      home: () => this.home(),
      evicted: () => {
        for (const side of this.sides) side.stage.again();
      },
    });
    const input = new Input(stage.canvas, {
      pose: () => this.pose,
      extent: () => this.extent,
      motion: () => "orbit",
      move: (pose) => this.move(pose),
      home: () => this.home(),
    });
    const overlay = new Overlay();
    stage.element.append(overlay.canvas);
    stage.resize(512);
    const box = h("figure", { class: `half ${name}` }, stage.element, h("figcaption", {}, label));
    return { name, look, stage, overlay, input, panel: null, box, isStill: false, measured: null };
  }

  private toolbar(): HTMLElement {
    const size = selectField(
      "Size",
      SIZES.map((value) => ({ value, label: `${value} × ${value}` })),
      (value) => {
        for (const side of this.sides) side.stage.resize(Number(value));
      },
    );
    size.set("512");
    const sights = segments("Show", SIGHTS, (value) => {
      this.sight = value as Sight;
      this.images.dataset.sight = value;
      this.wipe();
      this.paint();
    });
    return h(
      "div",
      { class: "toolbar" },
      this.scenePick.element,
      size.element,
      sights.element,
      this.marks.element,
      h("button", { type: "button", onclick: () => this.home() }, "First view"),
      this.wiper,
    );
  }

  private async start(): Promise<void> {
    try {
      [this.kinds, this.scenes] = await Promise.all([getKinds(), listScenes()]);
    } catch (error) {
      noticeOf("compare", error, { label: "Try again", run: () => void this.start() });
      return;
    }
    const offered = this.scenes.filter(isOffered);
    this.scenePick.offer(offered.map((scene) => ({ value: scene.name, label: scene.name })));
    for (const side of this.sides) {
      side.panel = lookPanel(
        this.kinds,
        (look) => {
          side.look = look;
          this.present(side);
        },
        { output: false },
      );
      put(this.settings, [h("div", { class: "card" }, h("h2", {}, side.name.toUpperCase()), side.panel.element)]);
    }
    for (const side of this.sides) this.present(side);
  }

  private present(side: Side): void {
    side.look = known(side.look, this.kinds);
    this.scenePick.set(side.look.scene);
    side.panel?.show(
      side.look,
      this.scenes.find((scene) => scene.name === side.look.scene),
    );
    const caption = side.box.querySelector("figcaption");
    if (caption) caption.textContent = `${side.name.toUpperCase()}: ${briefly(side.look)}`;
    this.forget();
    this.writeAddress();
    void side.stage.present(side.look);
  }

  private choose(name: string): void {
    this.pose = null;
    this.first = null;
    for (const side of this.sides) {
      side.look = { ...side.look, scene: name };
      this.present(side);
    }
  }

  private async loaded(scene: Scene): Promise<void> {
    const start = this.first === null ? await firstCamera(scene) : undefined;
    if (scene.name !== this.sides[0].look.scene) return; // another one was chosen meanwhile
    this.extent = extentOf(scene);
    this.first ??= start === undefined ? null : poseOf(start);
    this.pose = linkedView(this.asked, this.extent, "compare-camera") ?? this.pose;
    this.asked = null;
    if (this.pose === null || !isUsable(this.pose, this.extent)) this.pose = this.first;
    if (this.pose !== null) for (const side of this.sides) side.stage.viewer.look(this.pose, true);
  }

  private move(pose: Pose): void {
    if (!isUsable(pose, this.extent)) return;
    this.pose = pose;
    this.forget();
    for (const side of this.sides) side.stage.viewer.look(pose);
    this.writeAddress();
  }

  private home(): void {
    if (this.first !== null) this.move(this.first);
  }

  /** What was measured is of another image now. */
  private forget(): void {
    this.collecting.abort();
    for (const side of this.sides) {
      side.isStill = false;
      side.measured = null;
      side.overlay.hide();
    }
    this.legend.hidden = true;
    this.figures.waiting();
  }

  /** Once both images are still: the figures of both. */
  private async collect(): Promise<void> {
    if (!this.sides.every((side) => side.isStill)) return;
    this.collecting.abort();
    this.collecting = new AbortController();
    const { signal } = this.collecting;
    try {
      for (const side of this.sides) {
        const request = side.stage.viewer.request();
        if (request === null) return;
        side.measured = await measure(request, signal);
      }
      if (!signal.aborted) this.paint();
    } catch (error) {
      if (!isAbort(error)) noticeOf("compare", error);
    }
  }

  /** Figures and overlays of what was measured. */
  private paint(): void {
    const [a, b] = [this.sides[0].measured, this.sides[1].measured];
    if (a === null || b === null || a.width !== b.width || a.height !== b.height) return;
    const ids = compareIds(a.id, b.id, a.t, b.t);
    const colours = compareColours(a.colour, b.colour);
    this.figures.show(ids, colours, a, b);
    const heated = channelsOf(this.sight, a, b, colours);
    for (const [at, side] of this.sides.entries()) {
      side.overlay.hide();
      if (heated !== null) side.overlay.show(heatPixels(heated.values[at as 0 | 1], heated.full), a.width, a.height);
      else if (this.marks.value()) side.overlay.mark(ids.marks, a.width, a.height);
    }
    this.legend.hidden = heated === null;
    if (heated !== null) {
      const ramp = h("span", { class: "ramp", "aria-hidden": "true" });
      this.legend.replaceChildren("0", ramp, `${figure(heated.full)} ${heated.unit} and more`);
    }
  }

  private wipe(): void {
    const wiping = this.sight === "wiper";
    this.wiper.hidden = !wiping;
    this.sides[1].box.style.clipPath = wiping ? `inset(0 0 0 ${this.wiper.value}%)` : "";
  }

  private writeAddress(): void {
    clearTimeout(this.address);
    this.address = setTimeout(() => {
      const camera = this.pose === null ? {} : poseToParameters(this.pose);
      const looks = this.sides.map((side) => lookToParameters(side.look, `${side.name}.`));
      const b = { "b.structure": this.sides[1].look.structure };
      replaceAddress("compare", { ...looks[0], ...looks[1], ...b, ...camera });
    }, 250);
  }
}

export const openCompare: OpenPage = (root, parameters) => new Compare(root, parameters);
