// Server-sent events over fetch, which can carry a token.
import { body, call } from "./http.ts";
import type { Job } from "./types.ts";

const PAUSE_MS = 80; // events of a quick job come by the hundred in a second

/** Splits a text stream into the data of its events. Feed it pieces as they come. */
export class EventParser {
  private rest = "";

  /** The data of each event that ended with this piece. */
  feed(piece: string): string[] {
    this.rest += piece;
    const blocks = this.rest.split(/\r?\n\r?\n/);
    this.rest = blocks.pop() ?? "";
    return blocks.map(dataOf).filter((data) => data !== "");
  }
}

function dataOf(block: string): string {
  const lines = block.split(/\r?\n/).filter((line) => line.startsWith("data:"));
  return lines.map((line) => line.slice(5).trimStart()).join("\n");
}

/**
 * Calls `onJob` with the job as it changes until it has ended; where changes come faster than people see, with the
 * newest. Throws Problem, Unreachable or AbortError.
 */
export async function followJob(id: string, onJob: (job: Job) => void, signal: AbortSignal): Promise<void> {
  const path = `/v1/jobs/${encodeURIComponent(id)}/events`;
  const response = await call("GET", path, { accept: "text/event-stream", signal });
  if (response.body === null) return;
  const reader = response.body.getReader();
  const decoder = new TextDecoder();
  const parser = new EventParser();
  let newest: string | undefined;
  const deliver = () => {
    if (newest !== undefined && !signal.aborted) onJob(JSON.parse(newest) as Job);
    newest = undefined;
  };
  const timer = setInterval(deliver, PAUSE_MS);
  try {
    for (;;) {
      const { done, value } = await body(reader.read());
      if (done) break;
      newest = parser.feed(decoder.decode(value, { stream: true })).at(-1) ?? newest;
    }
  } finally {
    clearInterval(timer);
    deliver();
  }
}
