// Machine: the device, what lies in memory, versions, and what is wrong.
import { evictScene, evictStructure, getSystem, listScenes, listStructures, pin } from "../api/resources.ts";
import type { Scene, Structure, System } from "../api/types.ts";
import type { OpenPage, Page } from "../app/page.ts";
import { fill, h, put } from "../ui/dom.ts";
import { bytes, count, duration, milliseconds, plural } from "../ui/format.ts";
import { dismiss, noticeOf } from "../ui/notice.ts";

const REFRESH_MS = 3000;

function facts(entries: [string, string][]): HTMLElement {
  const parts = entries.flatMap(([name, value]) => [h("dt", {}, name), h("dd", {}, value)]);
  return h("dl", { class: "facts" }, ...parts);
}

function card(title: string, ...children: (HTMLElement | null)[]): HTMLElement {
  return h("section", { class: "card", "aria-label": title }, h("h2", {}, title), ...children);
}

class Machine implements Page {
  private readonly warnings = h("div", { class: "wide" });
  private readonly resident = h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "Resident" });
  private readonly total = h("p", { class: "hint" });
  private readonly device = h("div");
  private readonly versions = h("div");
  private readonly timer: ReturnType<typeof setInterval>;
  private shown = "";

  constructor(root: HTMLElement, _: URLSearchParams) {
    put(root, [
      h("h1", { class: "hidden" }, "Machine"),
      this.warnings,
      card("Device", this.device),
      card("Versions", this.versions),
      h("section", { class: "card wide", "aria-label": "Memory" }, h("h2", {}, "In memory"), this.total, this.resident),
    ]);
    this.timer = setInterval(() => void this.refresh(), REFRESH_MS);
    void this.refresh();
  }

  recover(): void {
    void this.refresh();
  }

  close(): void {
    clearInterval(this.timer);
    dismiss("machine");
  }

  private async refresh(): Promise<void> {
    if (document.visibilityState === "hidden") return;
    try {
      const [system, scenes, structures] = await Promise.all([getSystem(), listScenes(), listStructures()]);
      this.showSystem(system);
      this.showResident(
        scenes.filter((scene) => scene.loaded),
        structures,
      );
    } catch (error) {
      noticeOf("machine", error, { label: "Try again", run: () => void this.refresh() });
    }
  }

  private showSystem(system: System): void {
    const { machine, device } = system;
    const reason = device.no_cuda;
    const isSaid = reason === null || system.warnings.some((warning) => warning.includes(reason));
    const texts = isSaid ? system.warnings : [`No GPU is used: ${reason}`, ...system.warnings];
    fill(this.warnings, texts.length > 0 && h("ul", { class: "warnings" }, ...texts.map((text) => h("li", {}, text))));
    this.warnings.hidden = texts.length === 0;
    const { total_bytes, free_bytes, resident_bytes } = device.memory;
    const memory =
      total_bytes > 0
        ? `${bytes(resident_bytes)} used by Raywalk, ${bytes(free_bytes)} of ${bytes(total_bytes)} free`
        : "";
    fill(
      this.device,
      facts([
        ["Renders on", device.name],
        ["Kind", device.kind === "cuda" ? "GPU (CUDA)" : `CPU, ${plural(machine.threads, "thread")}`],
        ...(memory === "" ? [] : ([["Device memory", memory]] as [string, string][])),
        ...(Object.entries(device.details) as [string, string][]),
        ["Host", `${machine.hostname}, ${plural(machine.cores, "core")}, ${bytes(machine.memory_bytes)}`],
        ["Processor", machine.cpu],
        ["System", `${machine.os}, ${machine.kernel}`],
        ["Governor", machine.governor],
        ["Running for", duration(system.uptime_s)],
      ]),
    );
    fill(
      this.versions,
      facts([
        ["Raywalk", machine.version],
        ["Commit", machine.git_commit],
        ["Compiler", machine.compiler],
        ["Build", machine.build_type],
        ["Flags", machine.build_flags],
        ...(Object.entries(machine.libraries) as [string, string][]),
      ]),
    );
    const { scenes, structures } = system.resident;
    this.total.textContent = `${plural(scenes, "scene")}, ${plural(structures, "structure")}, ${bytes(system.resident.bytes)}. What is pinned is not evicted.`;
  }

  private showResident(scenes: Scene[], structures: Structure[]): void {
    const now = JSON.stringify([scenes, structures]);
    if (now === this.shown) return;
    this.shown = now;
    const focused = this.resident.contains(document.activeElement)
      ? document.activeElement?.getAttribute("data-of")
      : null;
    const head = ["Name", "Size", "Contents", "Time", "Actions"].map((name) =>
      h("th", { scope: "col", class: name === "Size" || name === "Actions" ? "number" : null }, name),
    );
    const rows = scenes.flatMap((scene) => [
      this.sceneRow(scene),
      ...structures
        .filter((structure) => structure.scene === scene.name)
        .map((structure) => this.structureRow(structure)),
    ]);
    fill(
      this.resident,
      rows.length === 0
        ? h("p", { class: "hint" }, "Nothing is resident; Preview loads what it shows.")
        : h("table", {}, h("thead", {}, h("tr", {}, ...head)), h("tbody", {}, ...rows)),
    );
    if (focused === null) return;
    const same = [...this.resident.querySelectorAll<HTMLElement>("[data-of]")].find(
      (control) => control.dataset.of === focused,
    );
    (same ?? this.resident).focus();
  }

  private sceneRow(scene: Scene): HTMLElement {
    const contents = `${plural(scene.triangles, "triangle")}, ${scene.fidelity}`;
    const cells = [bytes(scene.size_bytes ?? 0), contents, `loaded in ${milliseconds(scene.load_ms ?? 0)}`];
    return this.row("scene", scene.name, cells, scene.pinned === true, `scenes/${scene.name}`, () =>
      evictScene(scene.name),
    );
  }

  private structureRow(structure: Structure): HTMLElement {
    const isReady = structure.state === "ready";
    const contents = isReady
      ? `${plural(structure.nodes ?? 0, "node")}, ${count(structure.references ?? 0)} references`
      : (structure.error ?? structure.state);
    const time = isReady ? `built in ${milliseconds(structure.build_ms ?? 0)}` : "";
    const cells = [bytes(structure.size_bytes ?? 0), contents, time];
    const path = `structures/${structure.id}`;
    return this.row("structure", structure.id, cells, structure.pinned === true, path, () =>
      evictStructure(structure.id),
    );
  }

  private row(
    what: "scene" | "structure",
    name: string,
    cells: string[],
    isPinned: boolean,
    path: string,
    evict: () => Promise<unknown>,
  ): HTMLElement {
    const act = async (work: () => Promise<unknown>) => {
      try {
        await work();
        dismiss("machine");
      } catch (error) {
        noticeOf("machine", error);
      }
      await this.refresh();
    };
    const pinned = h("input", {
      type: "checkbox",
      checked: isPinned,
      "data-of": `pin ${name}`,
      onchange: () => void act(() => pin(path, pinned.checked)),
    });
    return h(
      "tr",
      { class: what },
      h("th", { scope: "row" }, name),
      ...cells.map((cell, at) => h("td", { class: at === 0 ? "number" : null }, cell)),
      h(
        "td",
        {},
        h(
          "div",
          { class: "actions" },
          h("label", { class: "check" }, pinned, h("span", {}, "pin", h("span", { class: "hidden" }, ` ${name}`))),
          h(
            "button",
            {
              type: "button",
              disabled: isPinned,
              "aria-label": `Evict ${name}`,
              "data-of": `evict ${name}`,
              onclick: () => void act(evict),
            },
            "Evict",
          ),
        ),
      ),
    );
  }
}

export const openMachine: OpenPage = (root, parameters) => new Machine(root, parameters);
