"use strict";
// The plane of error and speed: every family a curve over its period, measured plans as points, the
// front; over it, drawn apart since it follows the slider, the bound and the chosen plan.

// What can be pointed at, by its number: what `planOf` takes.
const spots = [];
const EVIDENT = { proven: "circle", measured: "diamond" };
// Nothing that moves the axes: the slider is laid along one.
const PLANE_OPTIONS = { displaylogo: false, modeBarButtons: [["toImage"]], doubleClick: false };
// What stands for no error on a logarithmic axis, far to the left of all.
const LEAST = 1e-7;
let heights = [0, 1];

function spot(...plan) {
  spots.push(plan);
  return spots.length - 1;
}

// Lower than half the original's speed nothing is of interest.
function speedLimits() {
  const shown = curves.flatMap(({ points }) => points.filter(({ x }) => Math.log10(x) < range[1]).map(({ y }) => y));
  const measured = picks.map(({ share }) => 1 / share);
  const low = Math.max(0.5, Math.min(0.9, ...shown)), high = Math.max(1.2, ...shown, ...measured);
  return [Math.log10(low) - 0.01, Math.log10(high) + 0.07 * Math.log10(high / low)];
}

function drawTuningPlane() {
  const place = byId("plane");
  byId("plane-caption").replaceChildren(...marked(planeWords()));
  if (!curves.length) return drawNothing(place, "No value was drawn, so there is nothing to show.");
  spots.length = 0;
  heights = speedLimits();
  const front = frontTrace(), points = pointTraces();
  // The slider below has their names.
  const asked = page.verdicts.map(({ error }) => upright(error, "", "dot", color("faint")).shape);
  draw(place, [...curveTraces(), front, ...points], layout(place, {
    xaxis: boundAxis(), yaxis: speedAxis(), shapes: [...asked, level(1)],
    annotations: [levelNote(1, "the original"), ...frontNotes(place)],
  }), PLANE_OPTIONS);
  drawOverlay();
}

function boundAxis() {
  const narrow = byId("plane").clientWidth < NARROW;
  const title = narrow ? `largest error (${metricWords})` : `error that no frame exceeds, at up to twice the speed (${metricWords})`;
  if (tuning.metric !== "psnr") return { ...errorAxis(title, range), fixedrange: true };
  const [high, low] = range.map((power) => -20 * power), step = high - low > 40 ? 10 : 5, values = [];
  for (let decibels = Math.ceil(low / step) * step; decibels <= high; decibels += step) values.push(decibels);
  return axis(narrow ? `least ${metricWords}` : `${metricWords} that no frame falls below, at up to twice the speed`, {
    type: "log", range, fixedrange: true, tickvals: values.map((value) => 10 ** (-value / 20)),
    ticktext: values.map((value) => `${value} dB`),
  });
}

function speedAxis() {
  const span = 10 ** (heights[1] - heights[0]);
  const steps = span > 8 ? [0.5, 1, 2, 4, 8, 16] : span > 3 ? [0.5, 0.75, 1, 1.5, 2, 3, 4, 6, 8] :
    [0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.1, 1.2, 1.4, 1.6, 1.8, 2, 2.5, 3];
  const values = steps.filter((value) => Math.log10(value) >= heights[0] && Math.log10(value) <= heights[1]);
  return axis("times as fast", {
    type: "log", range: heights, fixedrange: true, tickvals: values, ticktext: values.map((value) => `${value}×`),
  });
}

function level(at) {
  return {
    type: "line", xref: "paper", x0: 0, x1: 1, y0: at, y1: at, layer: "below",
    line: { color: color("soft"), width: 1.2 },
  };
}

function levelNote(at, text) {
  return {
    xref: "paper", x: 1, y: Math.log10(at), text, showarrow: false, xanchor: "right", yanchor: "top",
    font: { size: 12, color: color("soft") }, bgcolor: veil(), borderpad: 1,
  };
}

// A trace for each algorithm: its curves, one after another with gaps between.
function curveTraces() {
  return [...Map.groupBy(curves, ({ number }) => algorithmOf(number))].map(([name, same]) => {
    const trace = { x: [], y: [], customdata: [] }, size = [];
    for (const { number, points } of same) {
      for (const { period, x, y } of points) {
        trace.x.push(Math.max(x, LEAST));
        trace.y.push(y);
        trace.customdata.push(spot([[number, period]]));
        size.push(points.length > 1 ? 0 : 5); // a curve of one point is seen as a point
      }
      for (const values of [...Object.values(trace), size]) values.push(null);
    }
    return {
      ...trace, name, mode: "lines+markers", hoverinfo: "none", connectgaps: false, opacity: 0.55,
      line: { color: algorithmColor(name), width: 1.1, shape: "spline", smoothing: 0.5 },
      marker: { symbol: "hexagon", size, color: algorithmColor(name) },
    };
  });
}

// Steps: within a bound the plan is that of the last stop, up to the next one.
function frontTrace() {
  const known = stops.map(([bound, plan]) => [Math.max(bound, 10 ** range[0]), plan]);
  return {
    x: [...known.map(([bound]) => bound), ...(known.length ? [10 ** range[1]] : [])],
    y: [...known.map(([, plan]) => speedOf(plan.share)), ...(known.length ? [speedOf(known.at(-1)[1].share)] : [])],
    customdata: known.map(([, { parts, without }]) => spot(parts, without)),
    name: "what the slider picks", mode: "lines+markers", hoverinfo: "none",
    line: { color: color("accent"), width: 2.4, shape: "hv" },
    marker: { symbol: "circle", size: [...known.map(() => 5), 0], color: color("accent") },
  };
}

function pointTraces() {
  const plans = [...drawn.values()];
  const named = { proven: "proven on unseen frames", measured: "measured only" };
  return Object.keys(named).map((evidence) => {
    const own = plans.filter((plan) => plan.evidence === evidence), ratio = (plan) =>
      (plan.proven ? plan.proven.speedup : plan.finalist.drawn.speedup);
    const least = (plan) => (plan.proven ? plan.proven.mean : plan.finalist.drawn.worst);
    const colored = own.map(({ parts }) => algorithmColor(algorithmOf(parts[0][0])));
    return {
      x: own.map(({ need }) => Math.max(need, 10 ** range[0])), y: own.map((plan) => ratio(plan).median),
      customdata: own.map(({ parts, without }) => spot(parts, without)), name: named[evidence], mode: "markers", hoverinfo: "none",
      error_x: {
        type: "data", symmetric: false, thickness: 1, width: 0, color: color("soft"),
        array: own.map(() => 0), arrayminus: own.map((plan) => Math.max(0, plan.need - least(plan))),
      },
      error_y: {
        type: "data", symmetric: false, thickness: 1, width: 3, color: color("soft"),
        array: own.map((plan) => ratio(plan).high - ratio(plan).median),
        arrayminus: own.map((plan) => ratio(plan).median - ratio(plan).low),
      },
      marker: {
        symbol: EVIDENT[evidence], size: 11, color: colored, line: { width: 1.5, color: color("paper") },
      },
    };
  });
}

const planeAxes = {
  across: (x) => (Math.log10(x) - range[0]) / (range[1] - range[0]),
  along: (y) => (Math.log10(y) - heights[0]) / (heights[1] - heights[0]),
  noteX: Math.log10, noteY: Math.log10,
};

// Values by name where the front comes to them.
function frontNotes(place) {
  const values = ([, plan]) => plan.parts.map(([number]) => valueOf(number).text).join(" + ");
  const firsts = stops.filter((stop, at) => stops.findIndex((one) => values(one) === values(stop)) === at);
  const length = place.clientWidth < NARROW ? 16 : 30;
  const labels = firsts.map(([bound, plan]) => ({
    x: Math.max(bound, 10 ** range[0]), y: speedOf(plan.share), color: color("ink"),
    text: short(values([bound, plan]), length),
  }));
  const crowd = [...drawn.values()].map(({ need, share }) => ({ x: Math.max(need, 10 ** range[0]), y: 1 / share }));
  const strokes = stops.flatMap(([bound, plan], at) => {
    const next = stops[at + 1] || [10 ** range[1], plan], from = Math.max(bound, 10 ** range[0]), y = speedOf(plan.share);
    return [[from, y, next[0], y], [next[0], y, next[0], speedOf(next[1].share)]];
  });
  return placeLabels(place, planeAxes, labels, crowd, strokes);
}

function planeWords() {
  return "A curve is one value with its choices, from a refresh every "
    + `${tuning.periods[0]} frames (left) to every ${tuning.periods.at(-1)} (right), as the models foretell it. Up is faster, `
    + "left is nearer to the original. Points were drawn: upright bars are 95 % intervals of the speed, level ones reach from "
    + "the mean error to the largest, or from usual to twice the speed where that was not drawn. Drag the bound; "
    + "point at a curve to see what it is, click it to look closer.";
}

// The bound, what lies beyond it, and the chosen plan with its curve.
function drawOverlay() {
  const place = byId("plane"), over = byId("plane-over");
  over.hidden = !curves.length;
  if (over.hidden) return;
  const width = place.clientWidth - MARGIN.l - MARGIN.r, height = place.clientHeight - MARGIN.t - MARGIN.b;
  const right = (x) => planeAxes.across(Math.max(x, LEAST)) * width;
  const within = (x) => Math.min(width, Math.max(0, right(x)));
  const down = (y) => (1 - planeAxes.along(y)) * height;
  Object.assign(over.style, { left: `${MARGIN.l}px`, top: `${MARGIN.t}px`, width: `${width}px`, height: `${height}px` });
  const at = within(choice.bound), plan = choice.plan;
  const parts = [drawing("rect", { class: "beyond", x: at, y: 0, width: Math.max(0, width - at), height })];
  if (plan) {
    for (const [number] of plan.parts) {
      const curve = curves.find((one) => one.number === number);
      const line = curve.points.map(({ x, y }) => `${right(x).toFixed(1)},${down(y).toFixed(1)}`).join(" ");
      parts.push(drawing("polyline", { class: "curve", points: line, stroke: algorithmColor(algorithmOf(number)) }));
      parts.push(...periodMarks(number, right, down));
    }
  }
  parts.push(drawing("line", { class: "limit", x1: at, x2: at, y1: 0, y2: height }));
  if (plan) {
    const x = within(plan.need), y = down(speedOf(plan.share));
    parts.push(drawing("circle", { class: "ring", cx: x, cy: y, r: 9 }));
  }
  byId("plane-marks").replaceChildren(...parts);
  byId("grip").style.left = `${at}px`;
}

// A dot for each period that may be chosen; the first and the last are named.
function periodMarks(number, right, down) {
  const fill = algorithmColor(algorithmOf(number)), periods = periodsOf(number);
  return periods.flatMap((period) => {
    const cx = right(hastyError(number, period)), cy = down(1 / familyShare(number, period));
    const dot = drawing("circle", { cx, cy, r: 2.6, fill });
    if (period !== periods[0] && period !== periods.at(-1)) return [dot];
    return [dot, drawing("text", { x: cx + 7, y: cy + 13, fill }, `every ${period}`)];
  });
}

// The upper end of the bound's line can be dragged as the slider can.
function setUpGrip() {
  const grip = byId("grip"), slider = byId("bound");
  grip.addEventListener("pointerdown", (event) => {
    grip.setPointerCapture(event.pointerId);
    event.preventDefault();
  });
  grip.addEventListener("pointermove", (event) => {
    if (!grip.hasPointerCapture(event.pointerId)) return;
    const { left, width } = byId("plane-over").getBoundingClientRect();
    slider.value = (STEPS * (event.clientX - left)) / width;
    slider.dispatchEvent(new Event("input"));
  });
}

function spotCard(at) {
  const plan = planOf(...spots[at]), [[number]] = plan.parts;
  return [
    ...plan.parts.flatMap((part) => [
      make("b", {}, short(valueOf(part[0]).text, 90)), make("p", {}, wayOf(part)),
    ]),
    ...(plan.without.length ? [make("p", {}, leftWords(plan))] : []),
    make("p", {}, make("strong", {}, timesText(plan.share)), ` as fast, ${metricWords} `,
      make("strong", {}, errorTold(plan.need)), " at up to twice the speed"),
    make("p", {}, chip(plan.evidence)),
    ...(tuning.families[number].error.follows ? [] : [make("p", {}, "does not follow the model: interpolated")]),
  ];
}

function setUpTuningPlane() {
  pointing.card = spotCard;
  pointing.choose = (at) => choice.choosePlan(...spots[at]);
  setUpGrip();
  choice.listeners.bound.push(drawOverlay);
}
