// A table that sorts by the head that is pressed.
import { fill, h } from "./dom.ts";

export interface SortColumn<Row> {
  name: string;
  title: string;
  isNumber: boolean;
  key(row: Row): string | number | null; // null: nothing to sort by, at the end in either order
  text(row: Row): string;
}

/** The first column heads its row. `mark` gives a row a class. */
export function sortTable<Row>(
  label: string,
  columns: SortColumn<Row>[],
  rows: Row[],
  mark: (row: Row) => string | null = () => null,
): HTMLElement {
  let [by, isDown] = [-1, false];
  const body = h("tbody");
  const compare = (a: string | number | null, b: string | number | null) => {
    if (a === null || b === null) return Number(a === null) - Number(b === null);
    return (a === b ? 0 : a < b ? -1 : 1) * (isDown ? -1 : 1);
  };
  const cell = (column: SortColumn<Row>, row: Row, at: number) =>
    at === 0
      ? h("th", { scope: "row" }, column.text(row))
      : h("td", { class: column.isNumber ? "number" : null }, column.text(row));
  const show = () => {
    const column = columns[by];
    const sorted = [...rows];
    if (column !== undefined) sorted.sort((a, b) => compare(column.key(a), column.key(b)));
    fill(body, ...sorted.map((row) => h("tr", { class: mark(row) }, ...columns.map((one, at) => cell(one, row, at)))));
    for (const [at, head] of heads.entries()) {
      head.setAttribute("aria-sort", at === by ? (isDown ? "descending" : "ascending") : "none");
    }
  };
  const heads = columns.map((column, at) =>
    h(
      "th",
      { scope: "col", class: column.isNumber ? "number" : null },
      h(
        "button",
        {
          type: "button",
          class: "sort",
          title: column.title,
          onclick: () => {
            [by, isDown] = [at, at === by ? !isDown : false];
            show();
          },
        },
        column.name,
      ),
    ),
  );
  show();
  return h(
    "div",
    { class: "scroll", tabindex: 0, role: "region", "aria-label": label },
    h("table", { class: "sortable" }, h("thead", {}, h("tr", {}, ...heads)), body),
  );
}
