// The columns of a measurement of speed against error.
import type { AccuracyResult } from "../api/types.ts";
import { nameOf } from "../techniques.ts";
import { count, figure } from "../ui/format.ts";
import type { SortColumn } from "../ui/sortTable.ts";

type Row = AccuracyResult["rows"][number];

const word = (name: string, title: string, text: (row: Row) => string): SortColumn<Row> => ({
  name,
  title,
  isNumber: false,
  key: text,
  text,
});
const number = (name: string, title: string, key: (row: Row) => number, text = figure): SortColumn<Row> => ({
  name,
  title,
  isNumber: true,
  key,
  text: (row) => text(key(row)),
});

export const accuracyColumns: SortColumn<Row>[] = [
  word("Technique", "Structure and traversal", nameOf),
  word("Knobs", "Options of the kernel", (row) => Object.values(row.knobs).join(", ")),
  word("Rays", "Class of the rays", (row) => row.class),
  number("Count", "Rays of the list", (row) => row.rays, count),
  number("Mrays/s", "At the median launch", (row) => row.mrays_per_s),
  number("Wrong", "By exact arithmetic", (row) => row.error.wrong.count, count),
  number("Wrong ppm", "Of those that were judged", (row) => row.error.wrong.ppm),
  number("≤ ppm", "Upper end of the 95 % interval", (row) => row.error.wrong.ppm_upper95),
];
