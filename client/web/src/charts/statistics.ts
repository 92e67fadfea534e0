// Order statistics of a few numbers.

/** The value at `share` of the sorted numbers, between two of them where need be; NaN without numbers. */
export function quantileOf(numbers: number[], share: number): number {
  const sorted = [...numbers].sort((a, b) => a - b);
  const place = share * (sorted.length - 1);
  const low = Math.floor(place);
  const [from, to] = [sorted[low], sorted[Math.min(low + 1, sorted.length - 1)]];
  return from === undefined || to === undefined ? Number.NaN : from + (place - low) * (to - from);
}
