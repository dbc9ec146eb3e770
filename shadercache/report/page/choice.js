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

// What takes long is done later, one after another, so that the page shows what it has meanwhile.
const waiting = new Set();
let running = false;

// A set: a plot that several listeners ask for is drawn once.
function soon(task) {
  if (!waiting.size && !running) setTimeout(nextTask);
  waiting.add(task);
}

async function nextTask() {
  const [task] = waiting;
  // Taken out before it runs: who asks for it meanwhile has something newer to show.
  waiting.delete(task);
  running = true;
  await task();
  running = false;
  if (waiting.size) setTimeout(nextTask);
  // The first time only: whoever opens the page by a script waits for this mark.
  else document.documentElement.dataset.drawn ||= String(Math.round(performance.now()));
}

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
