// What two images differ in, and other figures.
import assert from "node:assert/strict";
import { test } from "node:test";
import { quantileOf } from "../src/charts/statistics.ts";
import { channel, compareColours, compareIds, quantile, ulps } from "../src/compare/difference.ts";
import { heat, heatPixels } from "../src/compare/heat.ts";
import { bytes, count, duration, figure, plural } from "../src/ui/format.ts";
import { Quality } from "../src/viewer/quality.ts";

const floats = (...values: number[]) => Float32Array.from(values);

test("other triangles, apart from ties", () => {
  const above = new Float32Array(new Uint32Array([0x3f800002]).buffer)[0] ?? 0; // 2 ulp above 1
  const figures = compareIds(
    floats(1, 2, -1, 4, 5),
    floats(1, 3, 7, 6, 9),
    floats(1, 1, 1, 1, 1),
    floats(1, above, 1, 1.5, 1),
  );
  assert.deepEqual([...figures.marks], [0, 2, 1, 1, 2]);
  assert.deepEqual([figures.mismatches, figures.ties, figures.pixels], [2, 2, 5]);
});

test("units in the last place", () => {
  assert.equal(ulps(1, 1), 0);
  assert.equal(ulps(Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY), 0);
  assert.equal(ulps(-1, 1), Number.POSITIVE_INFINITY);
  assert.equal(ulps(Number.NaN, 1), Number.POSITIVE_INFINITY);
});

test("colours are compared as they are seen", () => {
  const same = compareColours(floats(0.5, 0.5, 0.5), floats(0.5, 0.5, 0.5));
  assert.deepEqual([same.max, same.rmse, same.changed], [0, 0, 0]);
  const other = compareColours(floats(0, 0, 0, 2, 2, 2), floats(1, 0, 0, 3, 3, 3)); // brighter than white is white
  assert.deepEqual([...other.levels], [255, 0]);
  assert.equal(other.changed, 1);
  assert.ok(Math.abs(other.rmse - Math.sqrt(1 / 6)) < 1e-12);
});

test("channels and quantiles", () => {
  assert.deepEqual([...channel(floats(1, 2, 3, 4), 1, 2)], [2, 4]);
  assert.equal(quantile(floats(5, 1, 3), 0.5), 3);
  assert.equal(quantileOf([4, 1], 0.5), 2.5);
  assert.ok(Number.isNaN(quantileOf([], 0.5)));
});

test("heat from blue to red", () => {
  assert.deepEqual(heat(0), [13, 8, 51]);
  assert.deepEqual(heat(2), [219, 41, 31]);
  const pixels = heatPixels(floats(0, 10), 10);
  assert.deepEqual([...pixels.slice(4)], [219, 41, 31, 255]);
});

test("numbers for people", () => {
  assert.deepEqual([figure(0), figure(0.01234), figure(3.14159), figure(12345)], ["0", "0.012", "3.14", "12,345"]);
  assert.deepEqual([bytes(999), bytes(1500), bytes(2e9)], ["999 B", "1.50 kB", "2.00 GB"]);
  assert.deepEqual([duration(5), duration(65), duration(3700)], ["5 s", "1 min 5 s", "1 h 1 min"]);
  assert.deepEqual([plural(1, "light"), plural(2, "light"), count(1234)], ["1 light", "2 lights", "1,234"]);
});

test("fewer pixels where the device is slow, all where it keeps up", () => {
  const quality = new Quality();
  const pixels = 512 * 512;
  assert.equal(quality.movingScale(pixels), 0.5);
  for (let i = 0; i < 20; i += 1) quality.learn(pixels, 500);
  assert.ok(Math.abs(quality.movingScale(pixels) - 0.3) < 0.01);
  for (let i = 0; i < 20; i += 1) quality.learn(pixels, 1e9);
  assert.equal(quality.movingScale(pixels), 0.2);
  for (let i = 0; i < 60; i += 1) quality.learn(pixels, 5);
  assert.equal(quality.movingScale(pixels), 1);
});
