// Pages by address: `#/page?name=value`. The address is the state that can be shared.
export interface Address {
  page: string;
  parameters: URLSearchParams;
}

export function parseAddress(hash: string): Address {
  const [path = "", query = ""] = hash.replace(/^#\/?/, "").split("?", 2);
  return { page: path, parameters: new URLSearchParams(query) };
}

export function addressText(page: string, parameters: Record<string, string>): string {
  const query = new URLSearchParams(parameters).toString().replaceAll("%2C", ",");
  return `#/${page}${query === "" ? "" : `?${query}`}`;
}

/** Rewrites the address without a new entry in the history and without an event. */
export function replaceAddress(page: string, parameters: Record<string, string>): void {
  history.replaceState(null, "", addressText(page, parameters));
}
