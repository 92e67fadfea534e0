// The access token, kept for this tab alone.
const KEY = "raywalk-token";

export function token(): string {
  return sessionStorage.getItem(KEY) ?? "";
}

export function keepToken(value: string): void {
  if (value === "") sessionStorage.removeItem(KEY);
  else sessionStorage.setItem(KEY, value);
}
