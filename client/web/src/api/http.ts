// Every request to the daemon goes through `call`: token, errors, and the news whether the daemon is there.
import { isAbort, Problem, Unreachable } from "./errors.ts";
import { token } from "./token.ts";
import type { ProblemDocument } from "./types.ts";

export type Contact = "answered" | "unreachable" | "refused";

const listeners = new Set<(contact: Contact) => void>();

/** Tells of each request how it ended; `refused` is a missing or wrong token. */
export function onContact(listener: (contact: Contact) => void): void {
  listeners.add(listener);
}

function tell(contact: Contact): void {
  for (const listener of listeners) listener(contact);
}

interface Ask {
  json?: unknown;
  accept?: string;
  headers?: Record<string, string>;
  signal?: AbortSignal | undefined;
}

async function problemOf(response: Response): Promise<Problem> {
  const fallback = { status: response.status, code: "unknown", detail: response.statusText, retryable: false };
  try {
    const document = (await response.json()) as Partial<ProblemDocument>;
    return new Problem({ ...fallback, ...document });
  } catch {
    return new Problem(fallback);
  }
}

/** The answer when it is a success. Throws Problem or Unreachable, and AbortError when `signal` says so. */
export async function call(method: string, path: string, ask: Ask = {}): Promise<Response> {
  const headers: Record<string, string> = { Accept: ask.accept ?? "application/json", ...ask.headers };
  if (ask.json !== undefined) headers["Content-Type"] = "application/json";
  if (token() !== "") headers.Authorization = `Bearer ${token()}`;
  const init: RequestInit = { method, headers, cache: "no-store", signal: ask.signal ?? null };
  if (ask.json !== undefined) init.body = JSON.stringify(ask.json);
  let response: Response;
  try {
    response = await fetch(path, init);
  } catch (error) {
    if (isAbort(error)) throw error;
    tell("unreachable");
    throw new Unreachable();
  }
  if (response.status === 401) tell("refused");
  else tell("answered");
  if (!response.ok) throw await problemOf(response);
  return response;
}

/** The body of an answer, all of it; a connection that breaks is Unreachable. */
export async function body<T>(read: Promise<T>): Promise<T> {
  try {
    return await read;
  } catch (error) {
    if (isAbort(error) || !(error instanceof TypeError)) throw error;
    tell("unreachable");
    throw new Unreachable();
  }
}

export async function json<T>(method: string, path: string, ask: Ask = {}): Promise<T> {
  const response = await call(method, path, ask);
  return body(response.json() as Promise<T>);
}
