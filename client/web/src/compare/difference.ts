// What two images of the same camera differ in.
const TIE_ULPS = 2;

export interface IdFigures {
  pixels: number;
  mismatches: number; // another triangle, ties apart
  ties: number; // another triangle at the same distance, to 2 ulp
  marks: Uint8Array; // a pixel: 1 mismatch, 2 tie
}

/** Distance of two floats in units of the last place; infinite when a NaN or signs differ. */
export function ulps(a: number, b: number): number {
  if (Object.is(a, b) || a === b) return 0;
  if (Number.isNaN(a) || Number.isNaN(b) || a < 0 !== b < 0) return Number.POSITIVE_INFINITY;
  const bits = new Uint32Array(new Float32Array([a, b]).buffer);
  return Math.abs((bits[0] ?? 0) - (bits[1] ?? 0));
}

/** Ids are -1 for a miss; `t` are the distances of the hits. All have one value a pixel. */
export function compareIds(a: Float32Array, b: Float32Array, tA: Float32Array, tB: Float32Array): IdFigures {
  const figures: IdFigures = { pixels: a.length, mismatches: 0, ties: 0, marks: new Uint8Array(a.length) };
  for (let i = 0; i < a.length; i += 1) {
    if (a[i] === b[i]) continue;
    const isHit = (a[i] ?? -1) >= 0 && (b[i] ?? -1) >= 0;
    const isTie = isHit && ulps(tA[i] ?? 0, tB[i] ?? 0) <= TIE_ULPS;
    figures.marks[i] = isTie ? 2 : 1;
    if (isTie) figures.ties += 1;
    else figures.mismatches += 1;
  }
  return figures;
}

/** One channel of linear light as an 8-bit sRGB level, not rounded. */
export function srgbLevel(linear: number): number {
  const light = Math.max(0, Math.min(1, linear));
  return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055);
}

export interface ColourFigures {
  levels: Float32Array; // a pixel: the largest difference of a channel, in 8-bit sRGB levels
  max: number; // of them
  rmse: number; // over all channels, of sRGB values in 0..1
  changed: number; // pixels with another 8-bit value
}

/** Both have three channels of linear light a pixel. */
export function compareColours(a: Float32Array, b: Float32Array): ColourFigures {
  const pixels = Math.floor(a.length / 3);
  const levels = new Float32Array(pixels);
  let [max, squares, changed] = [0, 0, 0];
  for (let i = 0; i < pixels; i += 1) {
    let [worst, differs] = [0, false];
    for (let channel = 3 * i; channel < 3 * i + 3; channel += 1) {
      if (a[channel] === b[channel]) continue;
      const [left, right] = [srgbLevel(a[channel] ?? 0), srgbLevel(b[channel] ?? 0)];
      const difference = Math.abs(left - right);
      worst = Math.max(worst, difference);
      squares += difference * difference;
      differs ||= Math.round(left) !== Math.round(right);
    }
    levels[i] = worst;
    max = Math.max(max, worst);
    if (differs) changed += 1;
  }
  return { levels, max, rmse: Math.sqrt(squares / Math.max(1, 3 * pixels)) / 255, changed };
}

/** Every `stride`-th value from `offset`: one channel. */
export function channel(values: Float32Array, offset: number, stride: number): Float32Array {
  return Float32Array.from({ length: Math.floor(values.length / stride) }, (_, i) => values[stride * i + offset] ?? 0);
}

/** The value that `share` of all lie at or below. */
export function quantile(values: Float32Array, share: number): number {
  const sorted = values.slice().sort();
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? 0;
}
