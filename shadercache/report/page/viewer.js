"use strict";
// The original and a layer over it, divided by a slider.

const LAYERS = {
  cached: "cached", difference: "difference × 10", hits: "hit map", age: "age", payload: "payload",
};
const ABSENCES = {
  cached: "there is no such picture", difference: "it takes two pictures of one size",
  hits: "this has no cache", age: "kept by sweeps with --cache age=on", payload: "there is no such picture",
};
// Of these single pixels are what they show.
const EXACT = new Set(["difference", "hits", "age"]);
const view = { layer: "cached" };

function showPictures() {
  const row = choice.row, layers = (row && row.layers) || {};
  const there = Object.keys(LAYERS).filter((name) => page.pictures[layers[name]]);
  const chosen = there.includes(view.layer) ? view.layer : there[0];
  const name = (layer) => (layer === "cached" && row && row.kind === "peer" ? row.label : LAYERS[layer]);
  segments(byId("layers"), "layer",
    Object.keys(LAYERS).map((layer) => [layer, name(layer), there.includes(layer) ? "" : ABSENCES[layer]]),
    chosen, (layer) => { view.layer = layer; showLayer(row, layer, name(layer)); });
  const usable = chosen && page.pictures[layers.original];
  byId("stage").hidden = !usable;
  byId("absent").hidden = Boolean(usable);
  if (usable) showLayer(row, chosen, name(chosen));
  else showAbsence(row);
}

function showLayer(row, layer, name) {
  const under = byId("under"), over = byId("over");
  under.src = page.pictures[row.layers.original];
  under.alt = "The frame as the original draws it";
  over.src = page.pictures[row.layers[layer]];
  over.alt = `The same frame: ${name}`;
  over.className = EXACT.has(layer) ? "exact" : "";
  byId("over-tag").textContent = name;
  byId("legend").replaceChildren(...legendOf(row, layer));
}

function legendOf(row, layer) {
  const entry = (style, ...words) => make("li", {}, make("i", style), ...words);
  if (layer === "hits") {
    return Object.entries(row.outcomes || {}).sort((a, b) => b[1] - a[1]).map(([name, share]) => {
      const [patch, words] = page.legend[name] || ["#888", name];
      return entry({ style: `background:${patch}` }, `${words} ${percent(share, 1)}`);
    });
  }
  if (layer === "age") {
    const [young, aged, old] = page.ages;
    return [
      entry({ class: "ramp", style: `background:linear-gradient(90deg, ${young}, ${aged})` },
        `computed in this frame … ${row.period} frames ago`),
      entry({ style: `background:${old}` }, "older than the period"),
    ];
  }
  if (layer === "difference") {
    return [make("li", {}, `RMSE ${errorText(row.errors.rmse)}, 99 of 100 pixels within `
      + `${errorText(row.errors.p99)}, largest ${errorText(row.errors.max)}`)];
  }
  if (layer === "payload") return [make("li", {}, "What the cache holds, clipped to 0–1")];
  return [];
}

function showAbsence(row) {
  const absent = byId("absent");
  byId("legend").replaceChildren();
  if (!row || row.failure) {
    absent.textContent = "There is no picture: this configuration has no result.";
    return;
  }
  const small = page.pictures[row.thumbnail];
  const text = row.layers
    ? "The store holds no pictures of this configuration."
    : "The pictures of this configuration were left out, so that the page stays below 12 MB. "
      + "Those on the fronts, the peers and the fastest of each value come first.";
  absent.replaceChildren(text, ...(small ? [make("img", { src: small, alt: "The cached frame, small" })] : []));
}

function setUpViewer() {
  const slider = byId("slider"), stage = byId("stage");
  const move = () => {
    stage.style.setProperty("--at", `${slider.value}%`);
    slider.setAttribute("aria-valuetext", `${Math.round(slider.value)} % original`);
  };
  slider.addEventListener("input", move);
  move();
  choice.listeners.row.push(showPictures);
}
