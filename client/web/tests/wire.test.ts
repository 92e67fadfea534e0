// What comes over the wire in pieces.
import assert from "node:assert/strict";
import { test } from "node:test";
import { EventParser } from "../src/api/events.ts";
import { parseServerTiming } from "../src/api/frames.ts";

test("events in any pieces", () => {
  const text = ': ping\n\nid: 1\nevent: job\ndata: {"a":1}\n\nid: 2\r\ndata: {"a":\r\ndata: 2}\r\n\r\n';
  for (let size = 1; size <= text.length; size += 1) {
    const parser = new EventParser();
    const found: string[] = [];
    for (let at = 0; at < text.length; at += size) found.push(...parser.feed(text.slice(at, at + size)));
    assert.deepEqual(found, ['{"a":1}', '{"a":\n2}'], `pieces of ${size}`);
  }
});

test("an event that has not ended is not there yet", () => {
  const parser = new EventParser();
  assert.deepEqual(parser.feed("data: 1\n"), []);
  assert.deepEqual(parser.feed("\n"), ["1"]);
});

test("Server-Timing", () => {
  const parts = parseServerTiming("queue;dur=0.125, trace;dur=12.5, other;desc=x");
  assert.deepEqual(
    [...parts],
    [
      ["queue", 0.125],
      ["trace", 12.5],
    ],
  );
  assert.equal(parseServerTiming("").size, 0);
});
