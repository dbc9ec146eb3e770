"use strict";
// Every value that was thought of, with what was fitted to it in each way that it was drawn.

const tableRows = tuning.groups.flatMap((group, at) => [
  ...group.values.flatMap((value, number) => tuning.families.map((family, place) => ({ group, value, family, place }))
    .filter(({ family }) => family.group === at && family.value === number)),
  ...group.not_drawn.map((value) => ({ group, value, family: null, place: null })),
]);

// How a value was drawn, or how long a frame with it is thought to take at the longest period.
function howText({ value, place }) {
  if (place !== null) return page.families[place].way;
  return value.foretold == null ? "not drawn" : `not drawn: ${percent(value.foretold)} foretold`;
}

const fitted = (read) => ({ family }) => (family && family.time && family.error ? read(family) : null);
const interval = ({ value, low, high }, tell) =>
  (low == null || high == null ? tell(value) : `${tell(value)} ± ${tell((high - low) / 2)}`);

const linesOf = ({ places }) =>
  places.map(([from, , to]) => (from === to ? `${from}` : `${from}–${to}`)).join(", ");

const VALUE_COLUMNS = [
  ["expression", ({ value }) => value.text],
  ["how", howText],
  ...(tuning.groups.length > 1 ? [["shader", ({ group }) => group.fragment]] : []),
  ["lines", ({ value }) => (value.places.length ? value.places[0][0] : null), (_, { value }) => linesOf(value)],
  ["share", ({ value }) => value.share, (share) => percent(share), true],
  ["changes with", ({ value }) => value.changes.join(", ") || "nothing"],
  ["T(hit)", fitted(({ time }) => time.hit.value), (share) => percent(share), true],
  ["T(miss)", fitted(({ time }) => time.miss.value), (share) => percent(share), true],
  ["α", fitted(({ error, scale }) => scale * error.alpha.value),
    (_, { family: { error, scale } }) => interval(error.alpha, (value) => errorText(scale * value)), true],
  ["λ", fitted(({ error }) => error.rate.value), (value) => value.toPrecision(2), true],
  ["2× / foretold", fitted(({ haste }) => haste), (value) => `× ${value.toFixed(2)}`, true],
  ["R²", fitted(({ error }) => error.goodness.r_squared), (value, { family: { error } }) =>
    `${value.toFixed(2)}${error.follows ? "" : ", not followed"}`, true],
];

function fillValues() {
  sortedTable(byId("table"), VALUE_COLUMNS, tableRows, { by: "share", down: true }, (at) => {
    const { place } = tableRows[at];
    // The longest period within the bound, or the shortest there is.
    const periods = periodsOf(place), within = periods.filter((period) => hastyError(place, period) <= choice.bound);
    choice.choosePlan([[place, within.length ? within.at(-1) : periods[0]]]);
    byId("look-title").scrollIntoView();
  }, ({ place }) => place !== null && isFitted(place));
}

function setUpValues() {
  byId("numbers").addEventListener("toggle", (event) => event.target.open && fillValues());
}
