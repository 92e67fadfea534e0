// Colours of heat maps: dark blue through green and yellow to red, as the daemon's own.
const STOPS: readonly (readonly [number, number, number])[] = [
  [0.05, 0.03, 0.2],
  [0.16, 0.22, 0.58],
  [0.1, 0.55, 0.6],
  [0.35, 0.78, 0.32],
  [0.96, 0.86, 0.22],
  [0.86, 0.16, 0.12],
];

/** Red, green and blue, 0 to 255; `share` in 0..1, what lies outside is cut. */
export function heat(share: number): [number, number, number] {
  const place = Math.max(0, Math.min(1, share)) * (STOPS.length - 1);
  const low = Math.min(Math.floor(place), STOPS.length - 2);
  const [from, to] = [STOPS[low], STOPS[low + 1]];
  const mix = (channel: 0 | 1 | 2): number => {
    const [a, b] = [from?.[channel] ?? 0, to?.[channel] ?? 0];
    return Math.round(255 * (a + (place - low) * (b - a)));
  };
  return [mix(0), mix(1), mix(2)];
}

/** The values as opaque pixels (RGBA); 0 is dark blue, `full` and more are red. */
export function heatPixels(values: Float32Array, full: number): Uint8ClampedArray<ArrayBuffer> {
  const table = Array.from({ length: 256 }, (_, at) => heat(at / 255));
  const pixels = new Uint8ClampedArray(4 * values.length);
  const factor = 255 / Math.max(full, 1e-12);
  for (let i = 0; i < values.length; i += 1) {
    const at = Math.max(0, Math.min(255, Math.round((values[i] ?? 0) * factor)));
    pixels.set(table[at] ?? [0, 0, 0], 4 * i);
    pixels[4 * i + 3] = 255;
  }
  return pixels;
}
