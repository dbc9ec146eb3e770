"use strict";
// What the reader looks at: a group of rows, one of the rows, a measure of the error.

const choice = {
  group: page.groups[0],
  row: null,
  metric: "rmse",
  listeners: { group: [], row: [], metric: [] },

  tell(what) {
    for (const listener of this.listeners[what]) listener();
  },

  chooseGroup(place) {
    this.group = page.groups[place];
    this.metric = "rmse";
    // Where nothing has a result, the first row says why.
    this.row = this.group.rows[this.group.chosen ?? 0];
    // The group first: its lists must be filled before a row is chosen in them.
    this.tell("group");
    this.tell("row");
  },

  chooseRow(place) {
    this.row = this.group.rows[place];
    this.tell("row");
  },

  chooseMetric(name) {
    this.metric = name;
    this.tell("metric");
  },
};

function speedText(row) {
  const [middle, low, high] = row.speedup.map((value) => value.toFixed(2));
  return `${middle}× [${low}–${high}]`;
}

// How a configuration works, without what it caches.
function wayText(row) {
  if (row.kind === "peer") return "instead of caching";
  const settings = row.settings ? `, ${row.settings}` : "";
  return `${row.algorithm}, Δn\u00a0${row.period}, k\u00a0${row.block}${settings}`;
}

// The label of a payload is an id where it has no name; its text says more then.
function labelText(row, group) {
  const node = row.node == null ? null : group.nodes[row.node];
  return node && node.ids.includes(row.label) ? node.text : row.label;
}

function errorWords(row) {
  const told = Object.entries(page.metrics).filter(([name]) => row.errors[name] != null);
  return [told.map(([name, words]) => `${words} ${errorText(row.errors[name])}`).join(", ")];
}

// What is said of a row where its point is pointed at.
function rowCard(at) {
  const row = choice.group.rows[at], uri = page.pictures[row.thumbnail];
  return [
    ...(uri ? [make("img", { src: uri, alt: "" })] : []),
    make("b", {}, short(labelText(row, choice.group), 90)),
    make("p", {}, wayText(row)),
    make("p", {}, make("strong", {}, speedText(row)), ` as fast, ${percent(row.time[0])} of the time`),
    make("p", {}, ...errorWords(row)),
    ...(row.hits == null ? [] : [make("p", {}, `hits ${percent(row.hits)}`)]),
  ];
}
pointing.card = rowCard;
pointing.choose = (at) => choice.chooseRow(at);

// Rows with a result, each with its place in the group.
function measuredRows(group) {
  return group.rows.map((row, place) => ({ row, place })).filter(({ row }) => !row.failure);
}

function variantsOf(group) {
  return measuredRows(group).filter(({ row }) => row.kind === "variant");
}

function peersOf(group) {
  return measuredRows(group).filter(({ row }) => row.kind === "peer");
}

function algorithmsOf(group) {
  return [...new Set(variantsOf(group).map(({ row }) => row.algorithm))].sort();
}

// The two lists above the viewer: what is cached (or the peer), then how.
function setUpPickers() {
  const labels = byId("pick-label"), rows = byId("pick-row");
  const place = (row) => choice.group.rows.indexOf(row);

  choice.listeners.group.push(() => {
    const group = choice.group;
    const first = new Map();
    for (const row of group.rows) if (!first.has(row.label)) first.set(row.label, row);
    const options = [...first].map(([label, row]) =>
      make("option", { value: label }, short(labelText(row, group), 60)));
    const peer = options.filter((_, at) => [...first.values()][at].kind === "peer");
    const cached = options.filter((option) => !peer.includes(option));
    labels.replaceChildren(
      make("optgroup", { label: "cached values" }, ...cached),
      ...(peer.length ? [make("optgroup", { label: "peers" }, ...peer)] : []),
    );
  });
  choice.listeners.row.push(() => {
    if (!choice.row) return;
    labels.value = choice.row.label;
    const same = choice.group.rows.filter((row) => row.label === choice.row.label);
    const told = (row) => row.failure ? `${wayText(row)} (${row.failure.kind})`
      : `${wayText(row)} (${percent(row.time[0])})`;
    fillSelect(rows, same.map((row) => [place(row), told(row)]), place(choice.row));
  });
  labels.addEventListener("change", () => {
    const same = choice.group.rows.filter((row) => row.label === labels.value);
    // The other value in the same way, where there is one, so that the two can be compared.
    const alike = choice.row && same.find((row) => wayText(row) === wayText(choice.row));
    choice.chooseRow(place(alike || same[0]));
  });
  rows.addEventListener("change", () => choice.chooseRow(Number(rows.value)));
}
