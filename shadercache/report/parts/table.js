"use strict";
// A table that is sorted by a click on a heading.

// `columns`: [heading, key of a row, its text by key and row, is it a number?]. `open` is called with
// the place of a row whose first cell is clicked, of those that it `opens`. `sorting` is by the heading
// of a column, `down` or up; rows without a value come last in either order.
function sortedTable(table, columns, rows, sorting, open, opens = () => true) {
  const fill = () => sortedTable(table, columns, rows, sorting, open, opens);
  const [, key] = columns.find(([name]) => name === sorting.by) || columns[0], sign = sorting.down ? -1 : 1;
  const order = rows.map((row, place) => ({ place, row, value: key(row) }));
  order.sort((a, b) => (a.value == null) - (b.value == null)
    || sign * (typeof a.value === "string" ? a.value.localeCompare(b.value) : a.value - b.value));
  table.replaceChildren(
    make("thead", {}, make("tr", {}, ...columns.map((column, at) => headCell(table, column, at, sorting, fill)))),
    make("tbody", {}, ...order.map(({ row, place }) =>
      make("tr", {}, ...columns.map((column, at) => bodyCell(column, row, at || !opens(row) ? null : () => open(place)))))),
  );
}

function headCell(table, [name, , , number], at, sorting, fill) {
  const button = make("button", { type: "button" }, name);
  button.addEventListener("click", () => {
    sorting.down = sorting.by === name ? !sorting.down : Boolean(number);
    sorting.by = name;
    fill();
    // The heading that was pressed is gone: its successor takes the keyboard's focus.
    table.querySelectorAll("th button")[at].focus();
  });
  const sorted = sorting.by === name ? (sorting.down ? "descending" : "ascending") : null;
  return make("th", { scope: "col", "aria-sort": sorted, class: number ? "number" : null }, button);
}

function bodyCell([, read, show, number], row, open) {
  const value = read(row), text = value == null ? "" : show ? show(value, row) : String(value);
  if (!open) return make("td", { class: number ? "number" : null }, text);
  const button = make("button", { type: "button", title: text }, text);
  button.addEventListener("click", open);
  return make("td", {}, button);
}
