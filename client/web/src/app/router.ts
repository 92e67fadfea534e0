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

/**
 * Rewrites the address without a new entry in the history and without an event. The page's link leads back to it from
 * other pages.
 */
export function replaceAddress(page: string, parameters: Record<string, string>): void {
  const text = addressText(page, parameters);
  history.replaceState(null, "", text);
  document.querySelector(`nav a[data-page="${page}"]`)?.setAttribute("href", text);
}
