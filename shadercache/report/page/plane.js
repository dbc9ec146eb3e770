"use strict";
// The plane of error and time: every configuration, the peers, the fronts, the floor.

function drawPlane() {
  const place = byId("plane"), group = choice.group, metric = choice.metric;
  const known = measuredRows(group).filter(({ row }) => row.errors[metric] != null);
  byId("plane-caption").replaceChildren(...marked(planeCaption(group, known)));
  if (!known.length) return drawNothing(place, "No configuration has a result.");
  const limits = decades(known.map(({ row }) => row.errors[metric]));
  // On a logarithmic axis what has no error stands on the lower edge.
  const height = (row) => Math.max(row.errors[metric], 10 ** limits[0]);
  const width = (row) => 100 * row.time[0];
  const farthest = Math.max(110, ...known.map(({ row }) => width(row))) * 1.03;

  // Lines first: Plotly draws later traces over earlier ones.
  const traces = [];
  for (const kind of ["peer", "variant"]) {
    const front = (group.fronts[metric] || {})[kind] || [];
    if (front.length < 2) continue;
    traces.push(frontTrace(front.map((at) => group.rows[at]), kind, width, height));
  }
  traces.push(floorTrace(known, (group.fronts[metric] || {}).variant || [], height));
  for (const name of algorithmsOf(group)) {
    const own = known.filter(({ row }) => row.algorithm === name);
    traces.push(pointTrace(own, name, algorithmSymbol(name), algorithmColor(name), width, height));
  }
  const peers = known.filter(({ row }) => row.kind === "peer");
  if (peers.length) {
    traces.push(pointTrace(peers, "peers", "diamond", color("peer"), width, height, 10));
  }
  if (choice.row && !choice.row.failure && choice.row.errors[metric] != null) {
    traces.push({
      x: [width(choice.row)], y: [height(choice.row)], mode: "markers", hoverinfo: "skip",
      showlegend: false, name: "chosen",
      marker: { symbol: "circle-open", size: 18, color: color("ink"), line: { width: 2 } },
    });
  }
  const lines = [
    upright(100, "original", "solid", color("soft")),
    upright(100 * group.geometry, "geometry alone", "dot", color("faint")),
  ];
  const labels = planeLabels(group, metric, peers, width, height, place.clientWidth < NARROW);
  const crowd = known.map(({ row }) => ({ x: width(row), y: height(row) }));
  const strokes = [...stairs(traces), [100, 10 ** limits[0], 100, 10 ** limits[1]]];
  const notes = placeLabels(place, timeAndError(farthest, limits), labels, crowd, strokes);
  draw(place, traces, layout(place, {
    xaxis: axis(`time of a frame, % of the original’s ${ms(group.original[0])}`, { range: [0, farthest] }),
    yaxis: errorAxis(`${page.metrics[metric]} (less is better)`, limits),
    shapes: lines.map(({ shape }) => shape),
    annotations: [...lines.map(({ note }) => note), ...notes],
  }));
}

// The level and upright strokes of all lines of the plot.
function stairs(traces) {
  return traces.filter(({ mode }) => mode.includes("lines")).flatMap(({ x, y }) =>
    x.slice(1).flatMap((to, at) => (to == null || x[at] == null ? []
      : [[x[at], y[at], to, y[at]], [to, y[at], to, y[at + 1]]])));
}

function frontTrace(rows, kind, width, height) {
  const variant = kind === "variant";
  return {
    x: rows.map(width), y: rows.map(height), mode: "lines", hoverinfo: "skip",
    name: variant ? "front of caching" : "front of the peers",
    line: {
      shape: "hv", width: variant ? 2 : 1.5, dash: variant ? "solid" : "dash",
      color: color(variant ? "accent" : "peer"),
    },
    opacity: 0.65,
  };
}

// From each point of the front back to the time that its parts would take.
function floorTrace(known, front, height) {
  const x = [], y = [];
  for (const { row, place } of known) {
    if (row.floor == null || !front.includes(place)) continue;
    x.push(100 * row.floor, 100 * row.time[0], null);
    y.push(height(row), height(row), null);
  }
  return {
    x, y, mode: "lines+markers", hoverinfo: "skip", name: "floor", connectgaps: false,
    line: { color: color("faint"), width: 1, dash: "dot" },
    // Of each three entries (floor, time, gap) only the floor has a mark.
    marker: { symbol: "line-ns-open", size: x.map((_, at) => (at % 3 ? 0 : 9)), color: color("faint") },
  };
}

function pointTrace(own, name, symbol, colored, width, height, size = innerWidth < NARROW ? 6 : 8) {
  return {
    x: own.map(({ row }) => width(row)), y: own.map(({ row }) => height(row)), name,
    customdata: own.map(({ place }) => place), mode: "markers", hoverinfo: "none",
    marker: { symbol, size, color: colored, opacity: 0.72, line: { width: 0.8, color: color("paper") } },
  };
}

function planeLabels(group, metric, peers, width, height, narrow) {
  const front = ((group.fronts[metric] || {}).variant || []).map((at) => group.rows[at]);
  const length = narrow ? 14 : 24;
  const point = (row, text, colored) => ({ x: width(row), y: height(row), text, color: colored });
  const chosen = choice.row && !choice.row.failure && choice.row.errors[metric] != null ? [choice.row] : [];
  const seen = new Set(chosen);
  const named = (row) => `${short(labelText(row, group), length)}, ${row.algorithm.replace("-pass", "")} · ${row.period}`;
  const own = chosen.map((row) => point(row, row.kind === "peer" ? row.label : named(row), color("ink")));
  const others = peers.filter(({ row }) => !seen.has(row))
    .map(({ row }) => point(row, short(row.label, length), color("peer")));
  const fronts = front.filter((row) => !seen.has(row))
    .map((row) => point(row, named(row), algorithmColor(row.algorithm)));
  // In this order: where room is short, the later ones go without a label.
  return [...own, ...others, ...fronts].slice(0, narrow ? 7 : 16);
}

function planeCaption(group, known) {
  const zeros = known.filter(({ row }) => row.errors[choice.metric] === 0).length;
  const parts = [
    `Each point is a configuration; left is faster, down is nearer to the original. Point at one to `
    + `see it, click it to look closer. Labels give the value, its passes and its period.`,
  ];
  if (zeros) parts.push(`${zeros} without any error ${zeros === 1 ? "stands" : "stand"} on the lower edge.`);
  const lost = measuredRows(group).length - known.length;
  if (lost) parts.push(`${lost} have no ${page.metrics[choice.metric]}.`);
  return parts.join(" ");
}

function setUpPlane() {
  choice.listeners.group.push(() => {
    const has = (name) => measuredRows(choice.group).some(({ row }) => row.errors[name] != null);
    segments(byId("metric"), "metric",
      Object.entries(page.metrics).map(([name, words]) => [name, words, has(name) ? "" : "measured by sweeps with --perceptual"]),
      choice.metric, (name) => choice.chooseMetric(name));
  });
  for (const what of ["row", "metric"]) choice.listeners[what].push(() => soon(drawPlane));
}
