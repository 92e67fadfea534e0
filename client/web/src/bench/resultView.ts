// A finished benchmark: its table, its chart, and the files.
import { downloadResult } from "../api/resources.ts";
import type { AccuracyResult, BenchmarkResult } from "../api/types.ts";
import { Plot } from "../charts/plot.ts";
import { nameOf } from "../techniques.ts";
import { h } from "../ui/dom.ts";
import { selectField } from "../ui/fields.ts";
import { noticeOf } from "../ui/notice.ts";
import { saveFile } from "../ui/save.ts";
import { sortTable } from "../ui/sortTable.ts";
import { accuracyColumns } from "./accuracyColumns.ts";
import { columnsOf } from "./columns.ts";

export interface ResultView {
  element: HTMLElement;
  close(): void;
}

function downloads(id: string): HTMLElement {
  const save = async (accept: string, suffix: string) => {
    try {
      saveFile(await downloadResult(id, accept), `raywalk-${id}.${suffix}`);
    } catch (error) {
      noticeOf("bench", error);
    }
  };
  return h(
    "div",
    { class: "toolbar" },
    h("button", { type: "button", onclick: () => void save("text/csv", "csv") }, "CSV"),
    h("button", { type: "button", onclick: () => void save("application/json", "json") }, "JSON"),
  );
}

function notesOf(notes: string[], warnings: string[]): HTMLElement | null {
  const all = [...notes, ...warnings];
  return all.length === 0 ? null : h("ul", { class: "hint notes" }, ...all.map((note) => h("li", {}, note)));
}

/** Times of the frames, one line a technique, for the mode that is chosen. */
function frameChart(result: BenchmarkResult): { element: HTMLElement; close(): void } {
  const plot = new Plot("Time of each frame, one line a technique; the table has the figures", "frame", "ms");
  const modes = [...new Set(result.rows.map((row) => row.mode))];
  const names = [...new Set(result.rows.map(nameOf))];
  const show = (mode: string) => {
    const rows = result.rows.filter((row) => row.mode === mode && (row.frame_times_ms?.length ?? 0) > 0);
    const frames = Math.max(0, ...rows.map((row) => row.frame_times_ms?.length ?? 0));
    plot.show(rows.map((row) => ({ name: nameOf(row), colour: names.indexOf(nameOf(row)) })));
    plot.set(
      Array.from({ length: frames }, (_, at) => at),
      rows.map((row) => row.frame_times_ms ?? []),
    );
  };
  const mode = selectField(
    "Mode of the chart",
    modes.map((value) => ({ value, label: value })),
    show,
  );
  show(modes[0] ?? "");
  return { element: h("div", { class: "chart" }, mode.element, plot.element), close: () => plot.close() };
}

export function benchmarkView(id: string, result: BenchmarkResult): ResultView {
  const chart = frameChart(result);
  const { spec, scene } = result;
  const facts = `${scene.title}, ${scene.fidelity}; ${spec.width} × ${spec.height}, ${spec.frames} frames; ${result.machine.device}`;
  const table = sortTable("Results", columnsOf(result), result.rows, (row) =>
    row.gate?.status === "open" ? "open" : null,
  );
  const stopped = result.stop_reason === "time_limit" ? ["Measuring stopped at the time limit."] : [];
  return {
    element: h(
      "div",
      { class: "result" },
      h("p", { class: "hint" }, facts),
      downloads(id),
      table,
      h("p", { class: "hint" }, "Paper: the study's times on a GeForce GTX 280, 1024 × 1024, 400 frames."),
      notesOf([...stopped, ...result.notes], scene.warnings),
      chart.element,
    ),
    close: chart.close,
  };
}

export function accuracyView(id: string, result: AccuracyResult): ResultView {
  const failed = result.cases.filter((one) => one.strict && one.failures > 0).length;
  const cases =
    result.cases.length > 0 ? `${result.cases.length} runs of hard cases, ${failed} strict ones failed.` : "";
  return {
    element: h(
      "div",
      { class: "result" },
      h("p", { class: "hint" }, `${result.scene?.title ?? "Hard cases"}; ${result.machine.device}. ${cases}`),
      downloads(id),
      result.rows.length > 0 && sortTable("Results", accuracyColumns, result.rows),
      notesOf(result.notes, []),
    ),
    close: () => {},
  };
}
