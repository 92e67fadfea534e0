// Mouse, touch and keyboard move a camera.
import { type Extent, fly, look, orbit, pan, type Pose, zoom } from "./camera.ts";

export type Motion = "orbit" | "fly";

/** What the input moves: it reads the pose and extent, and hands back a new pose. */
export interface Steered {
  pose(): Pose | null;
  extent(): Extent;
  motion(): Motion;
  move(pose: Pose): void;
  home(): void;
}

const TURN = Math.PI; // radians for a drag over the whole height
const KEY_TURN = 1.2; // radians a second
const KEY_FLIGHT = 0.5; // radii a second
const TAP_S = 1 / 60; // what a key moves at least, however short it is pressed
const KEYS = new Set("wasdqe+-=_".split("").concat("arrowleft", "arrowright", "arrowup", "arrowdown"));

interface Finger {
  x: number;
  y: number;
}

export class Input {
  private readonly element: HTMLElement;
  private readonly steered: Steered;
  private readonly fingers = new Map<number, Finger>();
  private readonly keys = new Map<string, string>(); // held, by place on the keyboard: what they mean may change
  private isFast = false;
  private last = 0;
  private readonly off = new AbortController();

  constructor(element: HTMLElement, steered: Steered) {
    this.element = element;
    this.steered = steered;
    const options = { signal: this.off.signal };
    element.addEventListener("pointerdown", (event) => this.down(event), options);
    element.addEventListener("pointermove", (event) => this.drag(event), options);
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"] as const) {
      element.addEventListener(end, (event) => this.fingers.delete(event.pointerId), options);
    }
    element.addEventListener("wheel", (event) => this.wheel(event), { ...options, passive: false });
    element.addEventListener("contextmenu", (event) => event.preventDefault(), options);
    element.addEventListener("keydown", (event) => this.press(event), options);
    element.addEventListener("keyup", (event) => this.release(event), options);
    element.addEventListener("blur", () => this.keys.clear(), options);
  }

  close(): void {
    this.off.abort();
    this.keys.clear();
  }

  private change(act: (pose: Pose, extent: Extent) => Pose): void {
    const pose = this.steered.pose();
    if (pose !== null) this.steered.move(act(pose, this.steered.extent()));
  }

  private down(event: PointerEvent): void {
    this.element.focus({ preventScroll: true });
    this.element.setPointerCapture(event.pointerId);
    this.fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    event.preventDefault();
  }

  private drag(event: PointerEvent): void {
    const before = this.fingers.get(event.pointerId);
    if (before === undefined) return;
    const now = { x: event.clientX, y: event.clientY };
    const height = Math.max(1, this.element.clientHeight);
    const [right, down] = [(now.x - before.x) / height, (now.y - before.y) / height];
    const other = [...this.fingers].find(([id]) => id !== event.pointerId)?.[1];
    if (other !== undefined) {
      const spread = (finger: Finger) => Math.hypot(finger.x - other.x, finger.y - other.y);
      const factor = Math.max(1, spread(before)) / Math.max(1, spread(now));
      this.change((pose, extent) => pan(zoom(pose, factor, extent), -right / 2, down / 2, extent));
    } else if (event.buttons === 2 || event.buttons === 4 || event.shiftKey) {
      this.change((pose, extent) => pan(pose, -right, down, extent));
    } else if (this.steered.motion() === "fly") {
      this.change((pose) => look(pose, -right, -down));
    } else {
      this.change((pose) => orbit(pose, -right * TURN, down * TURN));
    }
    this.fingers.set(event.pointerId, now);
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 30 : 1;
    const amount = Math.max(-200, Math.min(200, event.deltaY * lines)) / 500;
    this.change((pose, extent) =>
      this.steered.motion() === "fly"
        ? fly(pose, -amount * extent.radius, 0, 0, extent)
        : zoom(pose, Math.exp(amount), extent),
    );
  }

  private press(event: KeyboardEvent): void {
    const key = event.key.toLowerCase();
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (key === "home" || key === "r") {
      this.steered.home();
      event.preventDefault();
      return;
    }
    if (!KEYS.has(key)) return;
    event.preventDefault();
    this.isFast = event.shiftKey;
    if (this.keys.has(event.code)) return;
    const isFirst = this.keys.size === 0;
    this.keys.set(event.code, key);
    this.step(TAP_S);
    if (!isFirst) return;
    this.last = performance.now();
    requestAnimationFrame((now) => this.tick(now));
  }

  private release(event: KeyboardEvent): void {
    this.keys.delete(event.code);
    this.isFast = event.shiftKey;
  }

  /** Moves by the keys that are held, once a frame of the screen. */
  private tick(now: number): void {
    if (this.keys.size === 0) return;
    this.step(Math.max(0.001, Math.min(0.1, (now - this.last) / 1000)));
    this.last = now;
    requestAnimationFrame((next) => this.tick(next));
  }

  private step(seconds: number): void {
    const keys = [...this.keys.values()];
    const held = (...names: string[]) => (names.some((name) => keys.includes(name)) ? 1 : 0);
    const fast = this.isFast ? 4 : 1;
    const yaw = (held("arrowleft") - held("arrowright")) * KEY_TURN * seconds;
    const pitch = (held("arrowup") - held("arrowdown")) * KEY_TURN * seconds;
    const speed = KEY_FLIGHT * seconds * fast;
    const closer = (held("+", "=") - held("-", "_")) * seconds * fast;
    this.change((pose, extent) => {
      const flying = this.steered.motion() === "fly";
      const turned = flying ? look(pose, yaw, pitch) : orbit(pose, -yaw, pitch);
      const near = closer === 0 ? turned : zoom(turned, Math.exp(-closer), extent);
      const step = speed * extent.radius;
      const [ahead, side, above] = [held("w") - held("s"), held("d") - held("a"), held("e") - held("q")];
      return fly(near, ahead * step, side * step, above * step, extent);
    });
  }
}
