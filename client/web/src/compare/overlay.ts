// A canvas over a stage: heat maps, differences and marks.
import { h } from "../ui/dom.ts";

export class Overlay {
  readonly canvas = h("canvas", { class: "overlay", "aria-hidden": "true", hidden: true });

  hide(): void {
    this.canvas.hidden = true;
  }

  /** Opaque pixels, RGBA. */
  show(pixels: Uint8ClampedArray<ArrayBuffer>, width: number, height: number): void {
    this.canvas.width = width;
    this.canvas.height = height;
    this.canvas.getContext("2d")?.putImageData(new ImageData(pixels, width, height), 0, 0);
    this.canvas.hidden = false;
  }

  /** A frame around each marked pixel: red for 1, yellow for 2. The image stays to be seen. */
  mark(marks: Uint8Array, width: number, height: number): void {
    this.canvas.width = width;
    this.canvas.height = height;
    const context = this.canvas.getContext("2d");
    if (context === null) return;
    for (const [at, mark] of marks.entries()) {
      if (mark === 0) continue;
      const [x, y] = [at % width, Math.floor(at / width)];
      context.strokeStyle = mark === 1 ? "#ff3b30" : "#ffd60a";
      context.strokeRect(x - 2.5, y - 2.5, 6, 6);
    }
    this.canvas.hidden = false;
  }
}
