"use strict";
// All numbers, for those who want to read them; made when it is opened.

const COLUMNS = [
  ["value", (row) => labelText(row, choice.group)],
  ["how", (row) => wayText(row)],
  ["time", (row) => row.time && row.time[0], (value) => percent(value), true],
  ["speed-up [95 %]", (row) => row.speedup && row.speedup[0], (_, row) => speedText(row), true],
  ["tail", (row) => row.tail, (value) => value.toFixed(2), true],
  ["P/T", (row) => row.ratio, (value) => percent(value), true],
  ["hits", (row) => row.hits, (value) => percent(value), true],
  ["RMSE", (row) => row.errors && row.errors.rmse, errorText, true],
  ["FLIP", (row) => row.errors && row.errors.flip, errorText, true],
  ["flicker", (row) => row.errors && row.errors.flicker, errorText, true],
  ["efficiency", (row) => row.efficiency, (value) => value.toFixed(2), true],
  ["no result", (row) => row.failure && `${row.failure.kind} [${row.failure.code}]`],
];
const sorting = { by: "speed-up [95 %]", down: true };

function fillTable() {
  const { rows } = choice.group;
  const used = COLUMNS.filter(([, read], at) => at < 4 || rows.some((row) => read(row) != null));
  sortedTable(byId("table"), used, rows, sorting, (place) => {
    choice.chooseRow(place);
    byId("look-title").scrollIntoView();
  });
}

function setUpTable() {
  byId("numbers").addEventListener("toggle", (event) => event.target.open && fillTable());
  choice.listeners.group.push(() => byId("numbers").open && fillTable());
}
