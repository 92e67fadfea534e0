// How many pixels to ask for while the camera moves: as many as keep the image under the hand.
const BUDGET_MS = 45;
const SMALLEST = 0.2; // of a side
const LEARNING = 0.4;

export class Quality {
  private msPerPixel = 0;

  /** Learns from a frame: its pixels, and the milliseconds from asking to drawing. */
  learn(pixels: number, ms: number): void {
    const now = ms / pixels;
    this.msPerPixel = this.msPerPixel === 0 ? now : (1 - LEARNING) * this.msPerPixel + LEARNING * now;
  }

  /** Nothing is known any more: another scene, structure or mode. */
  forget(): void {
    this.msPerPixel = 0;
  }

  /** The share of each side of an image of `pixels` while it moves; 1 where the device keeps up. */
  movingScale(pixels: number): number {
    if (this.msPerPixel === 0) return 0.5;
    const scale = Math.sqrt(BUDGET_MS / (this.msPerPixel * pixels));
    return scale > 0.85 ? 1 : Math.max(SMALLEST, scale);
  }
}
