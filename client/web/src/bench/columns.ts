// The columns of a benchmark's table: what each shows, and what it is sorted by.
import type { BenchmarkResult, ResultRow } from "../api/types.ts";
import { nameOf, paperName } from "../techniques.ts";
import { count, figure } from "../ui/format.ts";
import type { SortColumn } from "../ui/sortTable.ts";

type Column = SortColumn<ResultRow>;

type PaperTable = Record<string, Record<string, number | null> | undefined>;

/** The study's time of this row in ms; null where it has none. */
export function paperTime(result: BenchmarkResult, row: ResultRow): number | null {
  const table = (result.scene.paper as { table2?: PaperTable } | undefined)?.table2;
  const name = paperName(row);
  return name === undefined ? null : (table?.[`${row.mode}_ms`]?.[name] ?? null);
}

function number(
  name: string,
  title: string,
  value: (row: ResultRow) => number | null | undefined,
  text: (value: number) => string = figure,
): Column {
  return {
    name,
    title,
    isNumber: true,
    key: (row) => value(row) ?? null,
    text: (row) => {
      const known = value(row);
      return known === null || known === undefined ? "–" : text(known);
    },
  };
}

function word(name: string, title: string, value: (row: ResultRow) => string): Column {
  return { name, title, isNumber: false, key: value, text: value };
}

export function columnsOf(result: BenchmarkResult): Column[] {
  return [
    word("Technique", "Structure and traversal", nameOf),
    word("Mode", "What was timed", (row) => row.mode),
    number("Median ms", "Median time of a frame", (row) => row.frame_ms.median),
    {
      ...number("95 % interval", "Of the median, by bootstrap", (row) => row.frame_ms.ci95_low),
      text: (row) => `${figure(row.frame_ms.ci95_low)} – ${figure(row.frame_ms.ci95_high)}`,
    },
    number("p95 ms", "95th percentile", (row) => row.frame_ms.p95),
    {
      ...number(
        "SD ms",
        "Standard deviation; unstable: the spread over repeats exceeds 3.5 %",
        (row) => row.frame_ms.sd,
      ),
      text: (row) => `${figure(row.frame_ms.sd)}${row.frame_ms.unstable ? " unstable" : ""}`,
    },
    number("Mrays/s", "All rays of the mode", (row) => row.mrays_per_s),
    number("Paper ms", "The study's mean time: GeForce GTX 280, 1024 × 1024, 400 frames", (row) =>
      paperTime(result, row),
    ),
    number("Steps/ray", "Nodes or cells", (row) => row.steps_per_ray),
    number("Tests/ray", "Triangle tests", (row) => row.tests_per_ray),
    number(
      "Id errors ppm",
      "Primary rays that hit another triangle than the reference",
      (row) => row.error.id_mismatch_ppm,
    ),
    number("≤ ppm", "Upper end of their 95 % interval", (row) => row.error.id_mismatch_ppm_upper95),
    number(
      "PSNR dB",
      "Of the image; ∞ when it is the same",
      (row) => row.error.image_psnr_db ?? Number.POSITIVE_INFINITY,
      (db) => (Number.isFinite(db) ? figure(db) : "∞"),
    ),
    number(
      "FLIP",
      "Mean perceived difference, 0 to 1",
      (row) => row.error.image_flip_mean,
      (flip) => flip.toFixed(4),
    ),
    word("Gate", "closed: the error is within the limit of its tier", (row) => row.gate?.status ?? "–"),
    number("Wrong rays", "By exact arithmetic", (row) => row.gate?.wrong, count),
  ];
}
