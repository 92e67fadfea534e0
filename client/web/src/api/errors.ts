// What can go wrong with a request, as two kinds of error.
import type { ProblemDocument } from "./types.ts";

/** The daemon answered with a problem document. */
export class Problem extends Error {
  readonly status: number;
  readonly code: string;
  readonly retryable: boolean;

  constructor(document: Pick<ProblemDocument, "status" | "code" | "detail" | "retryable">) {
    super(document.detail);
    this.status = document.status;
    this.code = document.code;
    this.retryable = document.retryable;
  }
}

/** No answer: the daemon is not there, or stopped half-way. */
export class Unreachable extends Error {
  constructor() {
    super("The daemon does not answer.");
    this.name = "Unreachable";
  }
}

/** What was asked for is not resident any more. */
export function isEvicted(error: unknown): boolean {
  return error instanceof Problem && (error.status === 404 || error.status === 409);
}

export function isAbort(error: unknown): boolean {
  return error instanceof DOMException && error.name === "AbortError";
}

/** One sentence for people. */
export function sentence(error: unknown): string {
  return error instanceof Error ? error.message : "Something unexpected happened.";
}
