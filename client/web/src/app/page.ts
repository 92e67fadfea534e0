// What a page is to the shell.
export interface Page {
  /** The address changed to other parameters of this page. Without it the page is opened anew. */
  readdress?(parameters: URLSearchParams): void;
  /** The daemon is back after it was lost. */
  recover(): void;
  close(): void;
}

export type OpenPage = (root: HTMLElement, parameters: URLSearchParams) => Page;
