"use strict";
// The original and a layer over it, divided by a slider.

const LAYERS = {
  cached: "cached", difference: "difference × 10", hits: "hit map", age: "age", payload: "payload",
};
// Of these single pixels are what they show.
const EXACT = new Set(["difference", "hits", "age"]);
// `absences`: the layers that the page may have, each with why a shot lacks it.
const view = { layer: "cached", absences: {} };

// Shows a shot: names of pictures by layer, what became of its pixels, its errors. `names` are
// other words for its layers; `absence`: what stands there if it has no pictures.
function showShot(shot, names, absence) {
  const layers = (shot && shot.layers) || {}, known = Object.keys(view.absences);
  const there = known.filter((layer) => page.pictures[layers[layer]]);
  const chosen = there.includes(view.layer) ? view.layer : there[0];
  const name = (layer) => names[layer] || LAYERS[layer];
  segments(byId("layers"), "layer",
    known.map((layer) => [layer, name(layer), there.includes(layer) ? "" : view.absences[layer]]),
    chosen, (layer) => { view.layer = layer; showLayer(shot, layer, name(layer)); });
  const usable = chosen && page.pictures[layers.original];
  byId("stage").hidden = !usable;
  byId("absent").hidden = Boolean(usable);
  if (usable) return showLayer(shot, chosen, name(chosen));
  byId("legend").replaceChildren();
  byId("absent").replaceChildren(...absence);
}

function showLayer(shot, layer, name) {
  const under = byId("under"), over = byId("over");
  under.src = page.pictures[shot.layers.original];
  under.alt = "The frame as the original draws it";
  over.src = page.pictures[shot.layers[layer]];
  over.alt = `The same frame: ${name}`;
  over.className = EXACT.has(layer) ? "exact" : "";
  byId("over-tag").textContent = name;
  byId("legend").replaceChildren(...legendOf(shot, layer));
}

function legendOf(shot, layer) {
  const entry = (style, ...words) => make("li", {}, make("i", style), ...words);
  if (layer === "hits") {
    return Object.entries(shot.outcomes || {}).sort((a, b) => b[1] - a[1]).map(([name, share]) => {
      const [patch, words] = page.legend[name] || ["#888", name];
      return entry({ style: `background:${patch}` }, `${words} ${percent(share, 1)}`);
    });
  }
  if (layer === "age") {
    const [young, aged, old] = page.ages;
    return [
      entry({ class: "ramp", style: `background:linear-gradient(90deg, ${young}, ${aged})` },
        `computed in this frame … ${shot.period} frames ago`),
      entry({ style: `background:${old}` }, "older than the period"),
    ];
  }
  if (layer === "difference") {
    return [make("li", {}, `RMSE ${errorText(shot.errors.rmse)}, 99 of 100 pixels within `
      + `${errorText(shot.errors.p99)}, largest ${errorText(shot.errors.max)}`)];
  }
  if (layer === "payload") return [make("li", {}, "What the cache holds, clipped to 0–1")];
  return [];
}

function setUpViewer(absences) {
  view.absences = absences;
  const slider = byId("slider"), stage = byId("stage");
  const move = () => {
    stage.style.setProperty("--at", `${slider.value}%`);
    slider.setAttribute("aria-valuetext", `${Math.round(slider.value)} % original`);
  };
  slider.addEventListener("input", move);
  move();
}
