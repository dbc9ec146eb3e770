"use strict";
// All numbers, for those who want to read them; made when it is opened.

const COLUMNS = [
  ["value", (row, group) => labelText(row, group)],
  ["how", (row) => wayText(row)],
  ["time", (row) => row.time && row.time[0], percent],
  ["speed-up [95 %]", (row) => row.speedup && row.speedup[0], (_, row) => speedText(row)],
  ["tail", (row) => row.tail, (value) => value.toFixed(2)],
  ["P/T", (row) => row.ratio, percent],
  ["hits", (row) => row.hits, percent],
  ["RMSE", (row) => row.errors && row.errors.rmse, errorText],
  ["FLIP", (row) => row.errors && row.errors.flip, errorText],
  ["flicker", (row) => row.errors && row.errors.flicker, errorText],
  ["efficiency", (row) => row.efficiency, (value) => value.toFixed(2)],
  ["no result", (row) => row.failure && `${row.failure.kind} [${row.failure.code}]`],
];
const sorting = { column: 3, down: true };

function fillTable() {
  const group = choice.group;
  const used = COLUMNS.map((column, at) => at).filter((at) =>
    at < 4 || group.rows.some((row) => COLUMNS[at][1](row, group) != null));
  const key = COLUMNS[sorting.column][1];
  const order = group.rows.map((row, place) => ({ place, row, value: key(row, group) }));
  const sign = sorting.down ? -1 : 1;
  // Rows without the value come last in either direction.
  order.sort((a, b) => (a.value == null) - (b.value == null)
    || sign * (typeof a.value === "string" ? a.value.localeCompare(b.value) : a.value - b.value));
  byId("table").replaceChildren(
    make("thead", {}, make("tr", {}, ...used.map(headCell))),
    make("tbody", {}, ...order.map(({ row, place }) =>
      make("tr", {}, ...used.map((at) => bodyCell(row, place, at, group))))),
  );
}

function isNumber(at) {
  return at > 1 && at < COLUMNS.length - 1;
}

function headCell(at) {
  const button = make("button", { type: "button" }, COLUMNS[at][0]);
  button.addEventListener("click", () => {
    sorting.down = sorting.column === at ? !sorting.down : isNumber(at);
    sorting.column = at;
    fillTable();
    // The heading that was pressed is gone: its successor takes the keyboard's focus.
    byId("table").querySelectorAll("th button")[[...button.closest("tr").children].indexOf(button.closest("th"))].focus();
  });
  const sorted = sorting.column === at ? (sorting.down ? "descending" : "ascending") : null;
  return make("th", { scope: "col", "aria-sort": sorted, class: isNumber(at) ? "number" : null }, button);
}

function bodyCell(row, place, at, group) {
  const [, read, show] = COLUMNS[at], value = read(row, group);
  const text = value == null ? "" : show ? show(value, row) : String(value);
  if (at > 0) return make("td", { class: isNumber(at) ? "number" : null }, text);
  const button = make("button", { type: "button", title: text }, text);
  button.addEventListener("click", () => {
    choice.chooseRow(place);
    byId("look-title").scrollIntoView();
  });
  return make("td", {}, button);
}

function setUpTable() {
  byId("numbers").addEventListener("toggle", (event) => event.target.open && fillTable());
  choice.listeners.group.push(() => byId("numbers").open && fillTable());
}
