// Gives the user a file, or a text for the clipboard.
import { h } from "./dom.ts";
import { notice } from "./notice.ts";

export function saveFile(content: Blob, name: string): void {
  const url = URL.createObjectURL(content);
  const link = h("a", { href: url, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** Copies a text; where the browser refuses, shows it to be copied by hand. */
export async function copyText(text: string, what: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
    notice("copied", "info", `${what} copied: ${text}`);
  } catch {
    notice("copied", "info", `Copy it from here: ${text}`);
  }
}
