"use strict";
// What was measured of the chosen configuration, and how to measure it again.

function showDetails() {
  const row = choice.row, place = byId("details");
  if (!row) return place.replaceChildren();
  const what = make("p", { class: "what" }, make("code", {}, labelText(row, choice.group)), ` ${wayText(row)}`);
  if (row.failure) {
    const { code, message, kind } = row.failure;
    return place.replaceChildren(
      make("p", { class: "big" }, "no result"), what,
      make("p", { class: "failed" }, `${kind}: ${message} [${code}]`), ...repeatParts(row));
  }
  const facts = make("dl", { class: "facts" });
  definitions(facts, factsOf(row));
  place.replaceChildren(
    make("p", { class: "big" }, `${row.speedup[0].toFixed(2)}×`,
      make("small", {}, `as fast, 95 % interval ${row.speedup[1].toFixed(2)}–${row.speedup[2].toFixed(2)}`)),
    what, facts, ...outcomeParts(row), make("h3", {}, "Time of each frame"), strip(row), ...profileParts(row),
    ...ageParts(row), ...repeatParts(row));
}

function factsOf(row) {
  const facts = [
    ["time", `${ms(row.ms)} beside ${ms(row.originalMs)} of the original`],
    ["tail", `p99 is ${row.tail.toFixed(2)} × the median`],
  ];
  if (row.floor != null) {
    facts.push(["floor", `${percent(row.floor)} of the original; efficiency ${row.efficiency.toFixed(2)}`]);
  }
  if (row.ratio != null) {
    const fixed = choice.group.nodes[row.node].staticRatio;
    facts.push(["P/T", `${percent(row.ratio)} measured, ${percent(fixed)} by static cost`]);
  }
  if (row.reset != null) facts.push(["after a reset", `${row.reset.toFixed(2)} × the original’s time`]);
  if (row.bytes != null) facts.push(["memory", `${row.bytes} bytes a pixel in textures`]);
  const errors = row.errors;
  facts.push(["RMSE", `${errorText(errors.rmse)}${errors.psnr == null ? "" : ` (PSNR ${errors.psnr.toFixed(1)} dB)`}`]);
  const more = Object.entries(page.metrics).filter(([name]) => name !== "rmse" && errors[name] != null);
  facts.push(...more.map(([name, words]) => [words, errorText(errors[name])]));
  if (errors.ssim != null) facts.push(["SSIM", errors.ssim.toFixed(3)]);
  if (errors.pattern != null) facts.push(["block pattern", `${errors.pattern.toFixed(1)} × the noise around it`]);
  facts.push(["worst pixels", `p99 ${errorText(errors.p99)}, largest ${errorText(errors.max)}`]);
  return facts;
}

function outcomeParts(row) {
  if (!row.outcomes) return [];
  const parts = Object.entries(row.outcomes).sort((a, b) => b[1] - a[1]);
  const words = parts.map(([name, share]) => `${name} ${percent(share, 1)}`).join(", ");
  return [
    make("h3", {}, `What becomes of the pixels: ${percent(row.hits)} are hits`),
    make("div", { class: "bar", role: "img", "aria-label": words }, ...parts.map(([name, share]) =>
      make("i", {
        style: `width:${100 * share}%;background:${(page.legend[name] || ["#888"])[0]}`,
        title: `${name} ${percent(share, 1)}`,
      }))),
  ];
}

// A line for each part of a frame: its share of the original's time, with its interval.
function profileParts(row) {
  if (!row.profile.length) return [];
  const most = Math.max(...row.profile.map(([, share]) => share));
  return [
    make("h3", {}, "Where a frame goes, in shares of the original’s time"),
    make("div", { class: "parts" }, ...row.profile.flatMap(([name, share, low, high]) => [
      make("span", {}, name),
      make("span", { title: `95 % interval ${percent(low, 1)} to ${percent(high, 1)}` },
        make("i", { style: `width:${Math.max(0, 100 * share / most)}%` })),
      make("span", {}, percent(share, 1)),
    ])),
  ];
}

// A bar for each span of ages: its error, as wide as its share of the pixels.
function ageParts(row) {
  const ages = row.errors.byAge;
  if (!ages.length) return [];
  const most = Math.max(...ages.map(([, , , rmse]) => rmse)) || 1;
  const name = ([youngest, oldest]) => (youngest === oldest ? `${youngest}` : `${youngest}–${oldest}`);
  return [
    make("h3", {}, `RMSE by the age of what is reused, in frames: up to ${errorText(most)}`),
    make("div", { class: "ages" }, ...ages.map((age) => make("div", {
      // Ages of few pixels are still wide enough to point at.
      style: `flex-grow:${Math.max(100 * age[2], 4)}`,
      title: `${name(age)} frames old: ${percent(age[2], 1)} of the pixels, RMSE ${errorText(age[3])}`,
    }, make("i", { style: `height:${(56 * age[3]) / most}px` }), make("small", {}, name(age))))),
  ];
}

// Two histograms over one scale of milliseconds: original above the line, configuration below.
function strip(row) {
  const { start, end, counts } = row.histogram, width = 400, middle = 37, high = 32;
  const svg = drawing("svg", {
    viewBox: `0 0 ${width} 92`, role: "img", class: "strip",
    "aria-label": `Frames took from ${ms(start)} to ${ms(end)} and more`,
  });
  const add = (...parts) => svg.append(drawing(...parts));
  const step = width / counts[0].length;
  const colored = row.kind === "peer" ? color("peer") : algorithmColor(row.algorithm);
  counts.forEach((own, side) => {
    const most = Math.max(...own);
    own.forEach((count, at) => {
      const height = (high * count) / most;
      const y = side ? middle - height : middle + 2;
      if (count) add("rect", { x: at * step, y, width: step - 1, height, fill: side ? color("faint") : colored });
    });
  });
  add("line", { x1: 0, x2: width, y1: middle + 1, y2: middle + 1, stroke: color("line") });
  add("text", { x: 0, y: 87 }, ms(start));
  add("text", { x: width, y: 87, "text-anchor": "end" }, `${ms(end)} or more`);
  add("text", { x: width / 2, y: 87, "text-anchor": "middle" }, "grey: original");
  return svg;
}

function repeatParts(row) {
  return [make("h3", {}, "Measure it again"), ...commandParts(row.repeat)];
}

function setUpDetails() {
  choice.listeners.row.push(showDetails);
}
