// Which pixel is looked at: under the pointer, or by Alt with an arrow key from pixel to pixel.
import type { Pixel } from "./figures.ts";

const MOVES: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};
const STRIDE = 10; // with Shift

const within = (value: number, size: number) => Math.max(0, Math.min(size - 1, value));

/** Calls `picked` for pixels of the canvases, which show the same view. */
export class PixelPicker {
  private readonly picked: (pixel: Pixel) => void;
  private pixel: Pixel | null = null;

  constructor(canvases: HTMLCanvasElement[], picked: (pixel: Pixel) => void) {
    this.picked = picked;
    for (const canvas of canvases) {
      canvas.addEventListener("pointermove", (event) => this.point(canvas, event));
      canvas.addEventListener("keydown", (event) => this.step(canvas, event));
    }
  }

  private point(canvas: HTMLCanvasElement, event: PointerEvent): void {
    const box = canvas.getBoundingClientRect();
    const at = (offset: number, extent: number, size: number) => within(Math.floor((offset / extent) * size), size);
    this.pick({
      x: at(event.clientX - box.left, box.width, canvas.width),
      y: at(event.clientY - box.top, box.height, canvas.height),
    });
  }

  private step(canvas: HTMLCanvasElement, event: KeyboardEvent): void {
    const move = MOVES[event.key];
    if (!event.altKey || move === undefined) return;
    event.preventDefault();
    const from = this.pixel ?? { x: canvas.width >> 1, y: canvas.height >> 1 };
    const stride = event.shiftKey ? STRIDE : 1;
    this.pick({
      x: within(from.x + stride * move[0], canvas.width),
      y: within(from.y + stride * move[1], canvas.height),
    });
  }

  private pick(pixel: Pixel): void {
    this.pixel = pixel;
    this.picked(pixel);
  }
}
