"use strict";
// Figures 8 and 9 of Sitthi-amorn et al. 2008, and figure 11 of Scherzer et al. 2010.

const settingOf = (row) => `Δn ${row.period}, k ${row.block}${row.settings ? `, ${row.settings}` : ""}`;
const timeAxis = (more) => axis("time, % of the original’s", more);
const figure = { setting: null, label: null };

// The values by ascending P/T, each with its rows by algorithm.
function nodesBySetting(group, setting) {
  const nodes = new Map();
  for (const { row, place } of variantsOf(group)) {
    if (settingOf(row) !== setting) continue;
    const node = group.nodes[row.node];
    const known = nodes.get(row.label) || { ratio: node.staticRatio, rows: new Map() };
    if (row.ratio != null) known.ratio = row.ratio;
    known.rows.set(row.algorithm, { row, place });
    known.label = row.label;
    nodes.set(row.label, known);
  }
  return [...nodes.values()].sort((a, b) => a.ratio - b.ratio);
}

function drawNodes() {
  const place = byId("nodes"), group = choice.group, nodes = nodesBySetting(group, figure.setting);
  byId("nodes-caption").replaceChildren(...marked(nodesCaption(nodes)));
  if (!nodes.length) return drawNothing(place, "No cached value has a result.");
  const rank = nodes.map((_, at) => at + 1), narrow = place.clientWidth < NARROW;
  const traces = [{
    // P/T is a share of the shading, to which the geometry is added. As measured it may exceed 1.
    x: rank, y: nodes.map(({ ratio }) => 100 * (group.geometry + (1 - group.geometry) * Math.max(0, 1 - ratio))),
    mode: "lines", name: "if the value were free", hoverinfo: "skip",
    line: { color: color("faint"), width: 1.4, dash: "dot", shape: "hvh" },
  }];
  let most = 100;
  for (const name of algorithmsOf(group)) {
    const own = nodes.map(({ rows }, at) => ({ at: at + 1, ...rows.get(name) })).filter(({ row }) => row);
    most = Math.max(most, ...own.map(({ row }) => 100 * row.time[2]));
    traces.push(nodeTrace(own, name));
    const pairs = own.filter(({ at }) => name !== "2-pass" && nodes[at - 1].rows.has("2-pass"));
    if (pairs.length) traces.push(ratioTrace(pairs, nodes, name));
  }
  const ticks = nodeTicks(nodes, narrow ? 5 : 12);
  const ratios = traces.filter(({ yaxis }) => yaxis === "y2").flatMap(({ y }) => y);
  // Symmetric about 1, and never less than a factor of two in all.
  const reach = Math.max(Math.log10(1.5), ...ratios.map((value) => Math.abs(Math.log10(value)))) * 1.08;
  draw(place, traces, layout(place, {
    xaxis: axis("P/T of the value, ascending", { ...ticks, range: [0.4, nodes.length + 0.6], anchor: "y2" }),
    yaxis: timeAxis({ domain: ratios.length ? [0.36, 1] : [0, 1], range: [0, most * 1.06] }),
    yaxis2: axis("÷ 2-pass", {
      domain: [0, 0.27], type: "log", range: [-reach, reach], visible: ratios.length > 0,
      tickvals: [0.25, 0.5, 0.75, 1, 1.5, 2, 4], ticktext: ["¼", "½", "¾", "1", "1½", "2", "4"],
    }),
    shapes: [level(100, "y", "solid"), level(100 * group.geometry, "y", "dot"), level(1, "y2", "solid")],
    annotations: [
      levelNote(100, "original"), levelNote(100 * group.geometry, "geometry alone"),
      ...nodeNotes(nodes, group, narrow ? 16 : 34),
    ],
  }));
}

// Names the fastest value and the chosen one.
function nodeNotes(nodes, group, length) {
  const points = nodes.flatMap(({ rows }, at) => [...rows.values()].map(({ row }) => ({ row, at: at + 1 })));
  const fastest = points.reduce((best, one) => (one.row.time[0] < best.row.time[0] ? one : best));
  const chosen = points.find(({ row }) => row === choice.row);
  return [fastest, ...(chosen && chosen.at !== fastest.at ? [chosen] : [])].map(({ row, at }) => ({
    x: at, y: 100 * row.time[0], text: escaped(short(labelText(row, group), length)), showarrow: true,
    arrowhead: 0, arrowwidth: 1, arrowcolor: color("soft"), standoff: 6, bgcolor: veil(),
    ax: at > nodes.length / 2 ? -26 : 26, ay: 30, xanchor: at > nodes.length / 2 ? "right" : "left",
    font: { size: 12, color: color(row === choice.row ? "ink" : "soft") },
  }));
}

function nodeTrace(own, name) {
  return {
    x: own.map(({ at }) => at), y: own.map(({ row }) => 100 * row.time[0]), name, mode: "markers",
    customdata: own.map(({ place }) => place), hoverinfo: "none",
    error_y: {
      type: "data", symmetric: false, thickness: 1, width: 0, color: algorithmColor(name),
      array: own.map(({ row }) => 100 * Math.max(0, row.time[2] - row.time[0])),
      arrayminus: own.map(({ row }) => 100 * Math.max(0, row.time[0] - row.time[1])),
    },
    marker: {
      symbol: algorithmSymbol(name), size: 8, color: algorithmColor(name),
      line: { width: 0.8, color: color("paper") },
    },
  };
}

function ratioTrace(pairs, nodes, name) {
  return {
    x: pairs.map(({ at }) => at), yaxis: "y2", mode: "lines+markers", showlegend: false, name,
    y: pairs.map(({ at, row }) => row.time[0] / nodes[at - 1].rows.get("2-pass").row.time[0]),
    customdata: pairs.map(({ place }) => place), hoverinfo: "none",
    line: { width: 1, color: algorithmColor(name) },
    marker: { symbol: algorithmSymbol(name), size: 6, color: algorithmColor(name) },
  };
}

function nodeTicks(nodes, most) {
  const step = Math.max(1, Math.ceil(nodes.length / most));
  const shown = nodes.map((node, at) => [at + 1, node]).filter((_, at) => at % step === 0);
  return {
    tickvals: shown.map(([at]) => at), ticktext: shown.map(([, { ratio }]) => percent(ratio)),
    showgrid: false,
  };
}

function level(at, yref, dash) {
  return {
    type: "line", xref: "paper", x0: 0, x1: 1, yref, y0: at, y1: at, layer: "below",
    line: { color: color("faint"), width: 1, dash },
  };
}

function levelNote(at, text) {
  return {
    xref: "paper", x: 1, y: at, text, showarrow: false, xanchor: "right", yanchor: "bottom",
    font: { size: 12, color: color("soft") }, bgcolor: veil(), borderpad: 1,
  };
}

function nodesCaption(nodes) {
  const three = nodes.filter(({ rows }) => rows.has("3-pass") && rows.has("2-pass"));
  const won = three.filter(({ rows }) => rows.get("3-pass").row.time[0] < rows.get("2-pass").row.time[0]);
  const found = three.length
    ? ` Here three passes beat two for ${won.length} of ${three.length} values; in the paper they do for almost all.`
    : "";
  return "Above, time of a frame with each value cached, bars are 95 % intervals; below, the same over "
    + `that of two passes. After figure 8 of Sitthi-amorn et al. 2008.${found}`;
}

function drawPeriods() {
  const place = byId("periods"), group = choice.group;
  const own = variantsOf(group).filter(({ row }) => row.label === figure.label);
  const periods = [...new Set(own.map(({ row }) => row.period))].sort((a, b) => a - b);
  byId("periods-caption").textContent = "Time of a frame as the period Δn grows; a line for each algorithm "
    + "and block of k × k pixels. After figure 9 of Sitthi-amorn et al. 2008.";
  if (!periods.length) return drawNothing(place, "No cached value has a result.");
  if (periods.length < 2) {
    return drawNothing(place, "This value was measured with one period only. "
      + "`shadercache sweep` with `--period 4,8,16,32` gives the figure.");
  }
  const lines = Map.groupBy(own, ({ row }) => `${row.algorithm}|${row.block}|${row.settings}`);
  const blocks = [...new Set(own.map(({ row }) => row.block))].sort((a, b) => a - b);
  const dashes = ["solid", "dash", "dot", "dashdot"];
  const traces = [...lines.values()].map((same) => {
    same.sort((a, b) => a.row.period - b.row.period);
    const { algorithm, block, settings } = same[0].row;
    return {
      ...nodeTrace(same.map((one) => ({ ...one, at: one.row.period })), algorithm),
      mode: "lines+markers",
      name: `${algorithm}${blocks.length > 1 ? `, k ${block}` : ""}${settings ? `, ${settings}` : ""}`,
      line: { width: 1.6, color: algorithmColor(algorithm), dash: dashes[blocks.indexOf(block) % 4] },
    };
  });
  const most = Math.max(100, ...own.map(({ row }) => 100 * row.time[2]));
  draw(place, traces, layout(place, {
    xaxis: axis("period Δn, frames", { type: "log", tickvals: periods, ticktext: periods.map(String) }),
    yaxis: timeAxis({ range: [0, most * 1.06] }),
    shapes: [level(100, "y", "solid"), level(100 * group.geometry, "y", "dot")],
    annotations: [levelNote(100, "original"), levelNote(100 * group.geometry, "geometry alone")],
  }));
}

function drawCurves() {
  const place = byId("curves"), group = choice.group, metric = choice.metric;
  const known = variantsOf(group).filter(({ row }) => row.errors[metric] != null);
  byId("curves-caption").textContent = "A line is one value by its fastest algorithm, from the shortest period to "
    + "the longest; coloured are those on the front. After figure 11 of Scherzer et al. 2010.";
  if (!known.length) return drawNothing(place, "No cached value has a result.");
  const limits = decades(known.map(({ row }) => row.errors[metric]));
  const front = new Set(group.fronts[metric].variant.map((at) => group.rows[at].label));
  const ends = [];
  const traces = [...Map.groupBy(known, ({ row }) => row.label)].map(([label, same]) => {
    const fastest = [...Map.groupBy(same, ({ row }) => row.period)].map(([, rows]) =>
      rows.reduce((best, one) => (one.row.time[0] < best.row.time[0] ? one : best)));
    fastest.sort((a, b) => a.row.period - b.row.period);
    const y = fastest.map(({ row }) => Math.max(row.errors[metric], 10 ** limits[0]));
    const x = fastest.map(({ row }) => 100 * row.time[0]);
    const first = front.has(label) || (choice.row && choice.row.label === label);
    const colored = first ? color("accent") : color("faint");
    ends.push({ x: x.at(-1), y: y.at(-1), text: short(labelText(fastest[0].row, group), 20), color: colored, first });
    return {
      x, y, mode: "lines+markers", name: label, showlegend: false, hoverinfo: "none",
      customdata: fastest.map(({ place: at }) => at), opacity: first ? 1 : 0.55,
      line: { width: first ? 2 : 1, color: colored }, marker: { size: first ? 7 : 5, color: colored },
    };
  });
  const farthest = Math.max(110, ...traces.flatMap(({ x }) => x)) * 1.03;
  ends.sort((a, b) => b.first - a.first);
  const crowd = traces.flatMap(({ x, y }) => x.map((value, at) => ({ x: value, y: y[at] })));
  draw(place, traces, layout(place, {
    xaxis: timeAxis({ range: [0, farthest] }),
    yaxis: errorAxis(page.metrics[metric], limits),
    shapes: [upright(100, "", "solid", color("faint")).shape],
    annotations: placeLabels(place, timeAndError(farthest, limits), ends.slice(0, 10), crowd, []),
  }));
}

function setUpFigures() {
  byId("nodes-setting").addEventListener("change", (event) => {
    figure.setting = event.target.value;
    drawNodes();
  });
  byId("periods-label").addEventListener("change", (event) => {
    figure.label = event.target.value;
    drawPeriods();
  });
  choice.listeners.group.push(() => {
    const group = choice.group, settings = new Map(), labels = new Map();
    for (const { row } of variantsOf(group)) {
      settings.set(settingOf(row), (settings.get(settingOf(row)) || 0) + 1);
      if (!labels.has(row.label)) labels.set(row.label, { row, ways: new Set() });
      labels.get(row.label).ways.add(row.period);
    }
    const best = (counts) => counts.reduce((a, b) => (b[1] > a[1] ? b : a), ["", 0])[0];
    const chosen = choice.row && choice.row.kind === "variant" ? settingOf(choice.row) : null;
    // The setting of the chosen row, where it is as complete as any.
    const most = best([...settings]);
    figure.setting = settings.get(chosen) === settings.get(most) ? chosen : most;
    fillSelect(byId("nodes-setting"), [...settings.keys()].map((key) => [key, key]), figure.setting);
    figure.label = best([...labels].map(([label, { ways }]) => [label, ways.size]));
    if (choice.row && labels.has(choice.row.label)) figure.label = choice.row.label;
    fillSelect(byId("periods-label"), [...labels].map(([label, { row }]) =>
      [label, short(labelText(row, group), 40)]), figure.label);
    soon(drawNodes);
    soon(drawPeriods);
  });
  choice.listeners.row.push(() => soon(drawNodes));
  for (const what of ["row", "metric"]) choice.listeners[what].push(() => soon(drawCurves));
}
