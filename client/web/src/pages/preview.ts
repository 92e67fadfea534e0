// Preview: one scene, one technique, a camera that moves.
import { EXR, fetchImage, PNG } from "../api/frames.ts";
import { firstCamera, getKinds, listScenes } from "../api/resources.ts";
import type { Kind, Scene } from "../api/types.ts";
import type { OpenPage, Page } from "../app/page.ts";
import { addressText, replaceAddress } from "../app/router.ts";
import { h, put } from "../ui/dom.ts";
import { segments, selectField } from "../ui/fields.ts";
import { dismiss, noticeOf } from "../ui/notice.ts";
import { copyText, saveFile } from "../ui/save.ts";
import { keepPicture, type ScenePicker, scenePicker } from "../ui/scenePicker.ts";
import { type Extent, isUsable, type Pose, poseOf } from "../viewer/camera.ts";
import { known, type Look, lookFromParameters, lookToParameters } from "../viewer/choice.ts";
import { renderCommand } from "../viewer/command.ts";
import { Input, type Motion } from "../viewer/input.ts";
import { poseFromParameters, poseToParameters } from "../viewer/link.ts";
import { linkedView } from "../viewer/linkedView.ts";
import { type LookPanel, lookPanel } from "../viewer/lookPanel.ts";
import { extentOf, Stage } from "../viewer/stage.ts";
import { TimingPanel } from "../viewer/timingPanel.ts";
import type { Drawn } from "../viewer/viewer.ts";

const SIZES = ["fit", "256", "512", "768", "1024"];
const KEYS =
  "Drag or arrow keys turn, Shift-drag moves, wheel or + and - zoom, W A S D Q E fly, Home is the first view.";
const ADDRESS_MS = 250;

class Preview implements Page {
  private readonly stage: Stage;
  private readonly input: Input;
  private readonly timing = new TimingPanel();
  private readonly picker: ScenePicker;
  private readonly aside = h("aside", { class: "side", "aria-label": "Settings" });
  private readonly views = h("div", { class: "fields" });
  private panel: LookPanel | null = null;
  private kinds: Kind[] = [];
  private scenes: Scene[] = [];
  private look: Look;
  private asked: Pose | "bad" | null;
  private pose: Pose | null = null;
  private first: Pose | null = null;
  private extent: Extent = { centre: [0, 0, 0], radius: 1 };
  private motion: Motion = "orbit";
  private address: ReturnType<typeof setTimeout> | undefined;

  constructor(root: HTMLElement, parameters: URLSearchParams) {
    this.look = lookFromParameters(parameters);
    this.asked = poseFromParameters(parameters);
    this.picker = scenePicker((name) => this.choose(name));
    this.stage = new Stage("preview", "View of the scene", {
      loaded: (scene) => this.loaded(scene),
      drawn: (frame) => this.drawn(frame),
      home: () => this.home(),
      evicted: () => this.present(),
    });
    this.input = new Input(this.stage.canvas, {
      pose: () => this.pose,
      extent: () => this.extent,
      motion: () => this.motion,
      move: (pose) => this.move(pose),
      home: () => this.home(),
    });
    put(root, [h("h1", { class: "hidden" }, "Preview"), this.picker.element, this.stageBox(), this.aside]);
    void this.start();
  }

  readdress(parameters: URLSearchParams): void {
    this.look = lookFromParameters(parameters);
    this.asked = poseFromParameters(parameters);
    this.pose = null;
    this.present();
  }

  recover(): void {
    dismiss("preview-list");
    if (this.panel === null) void this.start();
    else this.present();
  }

  close(): void {
    clearTimeout(this.address);
    this.input.close();
    this.stage.close();
    for (const subject of ["preview-list", "preview-camera", "preview-file", "copied"]) dismiss(subject);
  }

  private stageBox(): HTMLElement {
    const motion = segments(
      "Camera",
      [
        { value: "orbit", label: "Orbit", title: "Turn about the target" },
        { value: "fly", label: "Fly", title: "Look around from where the camera is" },
      ],
      (value) => {
        this.motion = value as Motion;
      },
    );
    const button = (label: string, title: string, run: () => void) =>
      h("button", { type: "button", title, onclick: run }, label);
    const size = selectField(
      "Size",
      SIZES.map((name) => ({ value: name, label: name === "fit" ? "fit the page" : `${name} × ${name}` })),
      (value) => {
        this.stage.element.dataset.size = value;
        this.stage.resize(value === "fit" ? 0 : Number(value));
      },
    );
    return h(
      "section",
      { class: "stage-box", "aria-label": "View" },
      h(
        "div",
        { class: "toolbar" },
        motion.element,
        size.element,
        button("First view", "Home", () => this.home()),
        h("span", { class: "grow" }),
        button("PNG", "Download this view as PNG", () => void this.download(PNG, "png")),
        button("EXR", "Download this view as EXR, linear", () => void this.download(EXR, "exr")),
        button("Copy command", "Copy the raywalk render command of this view", () => this.copyCommand()),
        button("Copy link", "Copy the address of this view", () => void copyText(location.href, "Link")),
      ),
      this.stage.element,
      h("p", { class: "hint keys" }, KEYS),
      this.timing.element,
    );
  }

  private async start(): Promise<void> {
    try {
      [this.kinds, this.scenes] = await Promise.all([getKinds(), listScenes()]);
    } catch (error) {
      noticeOf("preview-list", error, { label: "Try again", run: () => void this.start() });
      return;
    }
    this.panel = lookPanel(this.kinds, (look) => {
      this.look = look;
      this.present();
    });
    put(this.aside, [h("h2", {}, "Technique"), this.panel.element, this.views]);
    this.present();
  }

  private present(): void {
    if (this.kinds.length > 0) this.look = known(this.look, this.kinds);
    const scene = this.scenes.find((one) => one.name === this.look.scene);
    this.panel?.show(this.look, scene);
    this.picker.show(this.scenes, this.look.scene);
    dismiss("preview-file");
    this.writeAddress();
    void this.stage.present(this.look);
  }

  private choose(name: string): void {
    this.look = { ...this.look, scene: name };
    this.asked = null;
    this.pose = null;
    this.present();
  }

  private async loaded(scene: Scene): Promise<void> {
    this.scenes = this.scenes.some((one) => one.name === scene.name)
      ? this.scenes.map((one) => (one.name === scene.name ? scene : one))
      : [...this.scenes, scene];
    const start = await firstCamera(scene);
    if (scene.name !== this.look.scene) return; // another one was chosen meanwhile
    this.picker.show(this.scenes, scene.name);
    this.extent = extentOf(scene);
    this.first = start === undefined ? null : poseOf(start);
    this.pose = linkedView(this.asked, this.extent, "preview-camera") ?? this.pose ?? this.first;
    this.asked = null;
    if (this.pose !== null) this.stage.viewer.look(this.pose, true);
  }

  private move(pose: Pose): void {
    if (!isUsable(pose, this.extent)) return;
    this.pose = pose;
    this.stage.viewer.look(pose);
    this.writeAddress();
  }

  private home(): void {
    if (this.first === null) return;
    this.pose = this.first;
    this.stage.viewer.look(this.first, true);
    this.writeAddress();
  }

  private drawn(frame: Drawn): void {
    this.timing.show(frame.timing, frame.size.width, frame.size.height);
    const scene = this.scenes.find((one) => one.name === this.look.scene);
    if (frame.full && scene !== undefined) keepPicture(scene, this.stage.canvas);
  }

  private writeAddress(): void {
    clearTimeout(this.address);
    this.address = setTimeout(() => {
      const camera = this.pose === null ? {} : poseToParameters(this.pose);
      const parameters = { ...lookToParameters(this.look), ...camera };
      if (location.hash !== addressText("preview", parameters)) replaceAddress("preview", parameters);
    }, ADDRESS_MS);
  }

  private async download(accept: string, suffix: string): Promise<void> {
    const request = this.stage.viewer.request();
    if (request === null) return;
    try {
      const { content } = await fetchImage(request, accept);
      saveFile(content, `${this.look.scene}-${this.look.structure}-${this.look.traversal}.${suffix}`);
    } catch (error) {
      noticeOf("preview-file", error);
    }
  }

  private copyCommand(): void {
    const request = this.stage.viewer.request();
    if (request === null || this.pose === null) return;
    const { width = 512, height = 512 } = request;
    void copyText(renderCommand(this.look, this.pose, width, height, location.origin), "Command");
  }
}

export const openPreview: OpenPage = (root, parameters) => new Preview(root, parameters);
