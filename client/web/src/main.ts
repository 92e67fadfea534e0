// The shell: opens the page that the address names.
import { Connection } from "./app/connection.ts";
import type { OpenPage, Page } from "./app/page.ts";
import { parseAddress } from "./app/router.ts";
import { themeSwitch } from "./app/theme.ts";
import { fill } from "./ui/dom.ts";

const PAGES: Record<string, { title: string; open(): Promise<OpenPage> }> = {
  preview: { title: "Preview", open: async () => (await import("./pages/preview.ts")).openPreview },
  compare: { title: "Compare", open: async () => (await import("./pages/compare.ts")).openCompare },
  walkthrough: {
    title: "Walkthrough",
    open: async () => (await import("./pages/walkthrough.ts")).openWalkthrough,
  },
  benchmarks: { title: "Benchmarks", open: async () => (await import("./pages/benchmarks.ts")).openBenchmarks },
  machine: { title: "Machine", open: async () => (await import("./pages/machine.ts")).openMachine },
};

const main = document.getElementById("main") as HTMLElement;
let page: Page | null = null;
let shown = "";

async function route(): Promise<void> {
  const { page: asked, parameters } = parseAddress(location.hash);
  const name = asked in PAGES ? asked : "preview";
  if (name === shown && page?.readdress) return page.readdress(parameters);
  shown = name;
  page?.close();
  page = null;
  for (const link of document.querySelectorAll("nav a")) {
    if (link.getAttribute("data-page") === name) {
      link.setAttribute("aria-current", "page");
      link.scrollIntoView({ block: "nearest", inline: "center" }); // on a phone not all fit
    } else link.removeAttribute("aria-current");
  }
  const entry = PAGES[name];
  document.title = `${entry?.title} · Raywalk`;
  const open = await entry?.open();
  if (shown !== name || open === undefined) return; // another page was asked for meanwhile
  fill(main);
  main.className = `page-${name}`;
  page = open(main, parameters);
}

const connection = new Connection(() => page?.recover());
document.getElementById("top-end")?.append(connection.element, themeSwitch());
document.querySelector(".skip")?.addEventListener("click", (event) => {
  event.preventDefault(); // the address is the page's
  main.focus();
});
window.addEventListener("hashchange", () => void route());
// The shell is painted before the page's work begins; nobody waits for a page that is not seen.
if (document.visibilityState === "hidden") void route();
else requestAnimationFrame(() => setTimeout(() => void route()));
