"use strict";
// What the plots have in common: colours, axes, labels that do not cover one another, the card.

const SYMBOLS = { "1-pass": "circle", "2-pass": "square", "3-pass": "triangle-up" };
const COLORS = { "1-pass": "one", "2-pass": "two", "3-pass": "three" };
const NARROW = 600;

function algorithmColor(name) {
  return color(COLORS[name] || "other");
}

function algorithmSymbol(name) {
  return SYMBOLS[name] || "star";
}

function axis(title, more) {
  return {
    title: { text: title, standoff: 8, font: { size: 13, color: color("soft") } },
    gridcolor: color("grid"), linecolor: color("line"), zeroline: false, ticks: "outside",
    tickcolor: color("line"), tickfont: { size: 12, color: color("soft") }, ...more,
  };
}

// A logarithmic axis of errors between powers of ten.
function errorAxis(title, limits) {
  const steps = limits[1] - limits[0] < 3.2 ? [1, 2, 5] : [1];
  const values = [];
  for (let power = Math.floor(limits[0]); power <= limits[1]; power++) {
    for (const step of steps) {
      const at = power + Math.log10(step);
      if (at >= limits[0] && at <= limits[1]) values.push(step * 10 ** power);
    }
  }
  return axis(title, {
    type: "log", range: limits, tickvals: values, ticktext: values.map((value) => errorText(value).replace(/(\.0*[125])0$/, "$1")),
  });
}

// Margins are fixed: then it is known where labels come to stand before anything is drawn.
const MARGIN = { l: 58, r: 14, t: 12, b: 50 };

function layout(place, more) {
  return {
    width: place.clientWidth, height: place.clientHeight, margin: MARGIN, showlegend: false,
    font: { family: getComputedStyle(document.body).fontFamily, size: 13, color: color("ink") },
    paper_bgcolor: "rgba(0,0,0,0)", plot_bgcolor: "rgba(0,0,0,0)", hovermode: "closest",
    dragmode: false, ...more,
    modebar: { bgcolor: "rgba(0,0,0,0)", color: color("faint"), activecolor: color("ink") },
  };
}

const PLOT_OPTIONS = {
  displaylogo: false, modeBarButtons: [["toImage", "zoom2d", "pan2d", "zoomIn2d", "zoomOut2d", "resetScale2d"]],
};

// What a page says of a point that is pointed at, as elements, and does where one is clicked: both
// are called with the point's customdata.
const pointing = { card: () => [], choose: () => {} };

// Draws into a place, with a key above it, and sees to it that the card tells of what is pointed at.
function draw(place, traces, shape, options = PLOT_OPTIONS) {
  place.classList.remove("empty");
  const hidden = place.hiddenNames || (place.hiddenNames = new Set());
  for (const trace of traces) trace.visible = !hidden.has(trace.name);
  // drawNothing may have left a sentence here; Plotly would draw below it.
  if (!place.heard) place.replaceChildren();
  Plotly.react(place, traces, shape, options);
  drawKey(place, traces, hidden);
  // Plotly.react keeps the listeners of the first drawing; more would each be called.
  if (place.heard) return;
  place.heard = true;
  place.on("plotly_hover", (event) => showCard(event.points[0].customdata, event.event));
  place.on("plotly_unhover", hideCard);
  place.on("plotly_click", (event) => {
    const at = event.points[0].customdata;
    if (at != null) pointing.choose(at);
  });
}

// A sentence in the place of a plot that there is nothing for.
function drawNothing(place, text) {
  if (place.heard) Plotly.purge(place);
  place.heard = false;
  place.classList.add("empty");
  place.replaceChildren(...marked(text));
  byId(`${place.id}-key`).replaceChildren();
}

// What the plot shows, as buttons that hide and show it.
function drawKey(place, traces, hidden) {
  const shown = traces.filter(({ x, showlegend }) => x.length && showlegend !== false);
  byId(`${place.id}-key`).replaceChildren(...shown.map((trace) => {
    const button = make("button", { type: "button", "aria-pressed": String(!hidden.has(trace.name)) },
      glyph(trace), trace.name);
    button.addEventListener("click", () => {
      const visible = hidden.delete(trace.name) || !hidden.add(trace.name);
      const same = traces.map(({ name }, at) => (name === trace.name ? at : -1)).filter((at) => at >= 0);
      Plotly.restyle(place, { visible }, same);
      button.setAttribute("aria-pressed", String(visible));
    });
    return button;
  }));
}

const MARKS = {
  circle: "M14 6a4 4 0 1 0-8 0a4 4 0 1 0 8 0", square: "M6.4 2.4h7.2v7.2h-7.2z",
  "triangle-up": "M10 1.6l4.6 8h-9.2z", diamond: "M10 .8l5.2 5.2l-5.2 5.2l-5.2-5.2z",
  star: "M10 1l1.5 3.5l3.7.3l-2.8 2.5l.9 3.7l-3.3-2l-3.3 2l.9-3.7l-2.8-2.5l3.7-.3z",
};

function drawing(tag, attributes, text) {
  const part = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) part.setAttribute(name, value);
  if (text) part.textContent = text;
  return part;
}

function glyph({ mode, marker, line: stroke }) {
  const svg = drawing("svg", { viewBox: "0 0 20 12", width: 20, height: 12, "aria-hidden": "true" });
  if (mode.includes("lines")) {
    const dashes = { dot: "2 3", dash: "5 3", dashdot: "5 2 1 2" }[stroke.dash] || "";
    svg.append(drawing("path", {
      d: "M0 6h20", stroke: stroke.color, "stroke-width": stroke.width, "stroke-dasharray": dashes,
    }));
  }
  if (MARKS[marker && marker.symbol]) {
    svg.append(drawing("path", { d: MARKS[marker.symbol], fill: [marker.color].flat()[0] }));
  }
  return svg;
}

// Limits of a logarithmic axis, as powers of ten: at least a factor of ten apart.
function decades(values) {
  const known = values.filter((value) => value > 0);
  if (!known.length) return [-4, -1];
  const low = Math.log10(Math.min(...known)), high = Math.log10(Math.max(...known));
  const pad = Math.max(0.08 * (high - low), (1 - (high - low)) / 2, 0.06);
  return [low - pad, high + pad];
}

// An upright line over the whole height, with its name at the lower end.
function upright(at, title, dash, colored) {
  return {
    shape: {
      type: "line", x0: at, x1: at, yref: "paper", y0: 0, y1: 1, layer: "below",
      line: { color: colored, width: 1.2, dash },
    },
    note: {
      x: at, yref: "paper", y: 0, text: title, textangle: -90, showarrow: false, xanchor: "right",
      yanchor: "bottom", yshift: 6, xshift: -1, font: { size: 12, color: colored },
    },
  };
}

// Where labels can stand around their points: shift and anchors, the best first.
const SIDES = [
  [6, 7, "left", "bottom"], [-6, 7, "right", "bottom"], [6, -7, "left", "top"], [-6, -7, "right", "top"],
  [0, 9, "center", "bottom"], [0, -9, "center", "top"], [11, 0, "left", "middle"], [-11, 0, "right", "middle"],
  [14, 18, "left", "bottom"], [-14, -18, "right", "top"], [14, -18, "left", "top"], [-14, 18, "right", "bottom"],
];

function box(x, y, width, height, [dx, dy, across, along]) {
  const left = { left: 0, center: -width / 2, right: -width }[across];
  const top = { top: 0, middle: -height / 2, bottom: -height }[along];
  return [x + dx + left, y - dy + top, x + dx + left + width, y - dy + top + height];
}

function overlap(a, b) {
  return Math.max(0, Math.min(a[2], b[2]) - Math.max(a[0], b[0])) *
    Math.max(0, Math.min(a[3], b[3]) - Math.max(a[1], b[1]));
}

// Where a plot with a linear axis of time and a logarithmic one of errors has a point: from 0 to 1
// from the left, and from below; and what Plotly takes for an annotation's place.
function timeAndError(farthest, limits) {
  return {
    across: (x) => x / farthest, along: (y) => (Math.log10(y) - limits[0]) / (limits[1] - limits[0]),
    noteX: (x) => x, noteY: Math.log10,
  };
}

// Annotations for points {x, y, text, color} in a plot with such axes. Each stands where it covers
// the least of the points in `crowd` and of the upright and level `strokes` [x, y, x, y]; one that
// would cover much is left out.
function placeLabels(place, axes, points, crowd, strokes) {
  const width = place.clientWidth - MARGIN.l - MARGIN.r, height = place.clientHeight - MARGIN.t - MARGIN.b;
  const right = (x) => axes.across(x) * width;
  const down = (y) => (1 - axes.along(y)) * height;
  const obstacles = crowd.map(({ x, y }) => [right(x) - 5, down(y) - 5, right(x) + 5, down(y) + 5]);
  for (const [x, y, toX, toY] of strokes) {
    const across = [right(x), right(toX)].sort((a, b) => a - b), along = [down(y), down(toY)].sort((a, b) => a - b);
    obstacles.push([across[0] - 2, along[0] - 2, across[1] + 2, along[1] + 2]);
  }
  const pen = document.createElement("canvas").getContext("2d");
  pen.font = `12px ${getComputedStyle(document.body).fontFamily}`;
  const taken = [], notes = [];
  for (const point of points) {
    const length = pen.measureText(point.text).width + 8;
    let best = null;
    for (const side of SIDES) {
      const area = box(right(point.x), down(point.y), length, 19, side);
      if (area[0] < 0 || area[2] > width || area[1] < 0 || area[3] > height) continue;
      if (taken.some((other) => overlap(area, other) > 0)) continue;
      const cost = obstacles.reduce((sum, other) => sum + overlap(area, other), 0);
      if (!best || cost < best.cost) best = { cost, side, area };
    }
    // Better no label than one of which a quarter lies on points and lines.
    if (!best || best.cost > 0.25 * 19 * length) continue;
    taken.push(best.area);
    const [dx, dy, xanchor, yanchor] = best.side;
    notes.push({
      x: axes.noteX(point.x), y: axes.noteY(point.y), text: escaped(point.text), showarrow: false, xshift: dx, yshift: dy,
      xanchor, yanchor, borderpad: 0, font: { size: 12, color: point.color }, bgcolor: veil(),
    });
  }
  return notes;
}

// What lies under a label shines through a little.
function veil() {
  // The style gives this colour as #rrggbb.
  const [red, green, blue] = color("paper").match(/[0-9a-f]{2}/gi).map((part) => parseInt(part, 16));
  return `rgba(${red},${green},${blue},0.72)`;
}

// Plotly reads some markup in texts.
function escaped(text) {
  return text.replace(/&/g, "&amp;").replace(/</g, "&lt;");
}

let shownAt = 0;

function showCard(at, event) {
  if (at == null) return;
  shownAt = scrollY;
  const card = byId("card");
  card.replaceChildren(...pointing.card(at));
  card.hidden = false;
  const touch = event && event.touches && event.touches[0];
  const { clientX, clientY } = touch || event || { clientX: 0, clientY: 0 };
  const { width, height } = card.getBoundingClientRect();
  const right = clientX + 18 + width < innerWidth ? clientX + 18 : clientX - 18 - width;
  card.style.left = `${Math.max(8, Math.min(right, innerWidth - width - 8))}px`;
  card.style.top = `${Math.max(8, Math.min(clientY - height / 2, innerHeight - height - 8))}px`;
}

function hideCard() {
  byId("card").hidden = true;
}
// Events of a scroll may come in after its end; then the card still stands at its point.
addEventListener("scroll", () => scrollY === shownAt || hideCard(), { passive: true });
