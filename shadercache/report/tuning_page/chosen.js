"use strict";
// The chosen plan: its numbers, its pictures, its places in the sources, what is emitted for it.

// Which part of a plan of several groups is shown in the source.
const shownPart = { at: 0 };

function partOf(plan) {
  return plan && plan.parts[Math.min(shownPart.at, plan.parts.length - 1)];
}

function showChosen() {
  const { plan } = choice, place = byId("details");
  if (!plan) return place.replaceChildren(make("p", { class: "big" }, "leave it alone"), ...reasons());
  const [{ median, low, high } = {}] = [plan.proven ? plan.proven.speedup : plan.finalist && plan.finalist.drawn.speedup];
  place.replaceChildren(
    make("p", { class: "big" }, timesText(plan.share),
      make("small", {}, median ? `as fast, 95 % interval ${low.toFixed(2)}–${high.toFixed(2)}` : "as fast, by the models")),
    make("p", { class: "evidence" }, chip(plan.evidence)),
    ...reasons(), ...plan.parts.flatMap(partWords),
    ...(plan.without.length ? [make("p", { class: "what" }, leftWords(plan))] : []), numbers(plan), ...commands(plan));
}

// What is to be said of how the plan was come by.
function reasons() {
  const { plan, asked, bound, pinned } = choice, expected = pickWithin(bound), found = [];
  if (asked !== null && !plan) found.push(make("p", { class: "what" }, `${page.verdicts[asked].text}`));
  else if (!plan) found.push(make("p", { class: "what" }, "Nothing that is faster than the original is within this bound."));
  if (pinned && plan && expected && expected.key !== plan.key && expected.share < plan.share) {
    found.push(make("p", { class: "what" }, `You chose it; within the same bound ${timesText(expected.share)} is expected of another.`));
  }
  if (asked !== null && !pinned && expected && (!plan || expected.key !== plan.key) && (!plan || expected.share < plan.share)) {
    const button = make("button", { type: "button", class: "copy" }, `look at what is expected: ${timesText(expected.share)}`);
    button.addEventListener("click", () => choice.expect());
    found.push(make("p", { class: "what" }, plan
      ? "This is what was proven for the bound. Others are expected to be faster within it and were not proven: "
      : "The models expect something faster within the bound, which was not proven: ", button));
  }
  return found;
}

const leftWords = ({ without }) => `drawn by the original all the same: ${without.join(", ")}`;

function partWords([number, period]) {
  const value = valueOf(number), facts = make("dl", { class: "facts" });
  const { refresh } = tuning.families[number].configuration;
  const [line] = value.places, { fragment } = groupOf(number);
  definitions(facts, [
    ["where", line ? `${fragment}:${line[0]}:${line[1]}` : fragment],
    ["how", page.families[number].way],
    ["refreshed", `${periodWords(period)}, in blocks of ${refresh.block} × ${refresh.block}`],
    ["changes with", value.changes.length ? value.changes.join(", ") : "nothing: it is only resampled"],
    ...(tuning.groups.length > 1 ? [["draws", short(groupOf(number).objects.join(", "), 120)]] : []),
  ]);
  return [make("p", { class: "expression" }, make("code", {}, value.text)), facts];
}

// Predicted beside measured, a line for each number, by the frames it is of.
function numbers(plan) {
  const { predicted, proven: sure, finalist } = plan, seen = finalist && finalist.drawn;
  const passages = sure ? sure.passages : [], fast = passages.find(({ step }) => step > 1);
  const errors = (one) => one && `${errorTold(one.mean)}, worst ${errorTold(one.worst)}`;
  const speed = (one) => ["times as fast", timesText(predicted.share), one && ratioText(one.speedup)];
  const frame = ({ speedup: { median } }) => ms((1e3 * tuning.original) / median);
  return make("table", { class: "beside" },
    make("thead", {}, make("tr", {}, ...["", "predicted", "measured"].map((head) => make("th", { scope: "col" }, head)))),
    besideBody("frames that it was chosen by", [
      speed(seen), ["a frame", ms(1e3 * tuning.original * predicted.share), seen && frame(seen)],
      ["error", errorTold(predicted.error), errors(seen)],
    ]),
    ...passages.filter(({ step }) => step === 1).map((one) => besideBody(one.name, [
      speed(one), ["error", errorTold(predicted.error), errors(one)],
    ])),
    besideBody("twice as fast", [speed(fast), ["error", errorTold(predicted.hasty), errors(fast)]]),
    ...(shots.has(plan.key) ? [besideBody("the frame in the picture", shownRows(plan, shots.get(plan.key)))] : []));
}

// One frame proves nothing, but it is of every plan that has pictures.
function shownRows({ parts: [[number, period]], predicted }, shot) {
  const { mu } = tuning.families[number].time;
  const rows = [["hit rate", percent(hitRate(mu, period)), percent(shot.outcomes.hit || 0)]];
  if (["rmse", "psnr"].includes(tuning.metric)) rows.push(["error", errorTold(predicted.error), errorTold(shot.errors.rmse)]);
  return rows;
}

function besideBody(title, rows) {
  return make("tbody", {}, make("tr", {}, make("th", { class: "head", colspan: 3, scope: "rowgroup" }, title)),
    ...rows.map(([name, told, measured]) => make("tr", {},
      make("th", { scope: "row" }, name), make("td", {}, told),
      make("td", { class: measured ? null : "none" }, measured || "not measured"))));
}

function commands(plan) {
  return [make("h3", {}, "Write these shaders"), ...plan.parts.flatMap(([number, period]) => {
    const { block } = tuning.families[number].configuration.refresh;
    if (!page.families[number].command) return [make("p", { class: "note" }, "There are none: the original draws it.")];
    return [...commandParts(page.families[number].command),
      make("p", { class: "note" }, `Then run them with a period of ${period} and a block of ${block}: both are uniforms.`)];
  })];
}

const PICTURES_ABSENT = {
  cached: "only plans that were drawn have it", difference: "only plans that were drawn have it",
  hits: "only plans that were drawn have it", payload: "there is no such picture",
};

function originalAlone() {
  const { original } = page.pictures;
  return ["Nothing is cached: the picture is the original’s.",
    ...(original ? [make("img", { src: original, alt: "The frame as the original draws it" })] : [])];
}

// The shot of a plan, or of the same families with the periods that are nearest to its.
function shotFor(plan) {
  const own = shots.get(plan.key);
  if (own) return [own, []];
  const period = new Map(plan.parts), apart = ({ plan: parts }) =>
    parts.reduce((sum, [number, other]) => sum + Math.abs(Math.log(other / period.get(number))), 0);
  const alike = [...shots.values()].filter(({ plan: parts, without }) => keyOf([], without) === keyOf([], plan.without)
    && parts.length === plan.parts.length && parts.every(([number]) => period.has(number)));
  if (!alike.length) return [null, []];
  const shot = alike.reduce((one, other) => (apart(other) < apart(one) ? other : one));
  return [shot, shot.plan.map(([, other]) => periodWords(other))];
}

function showPlanPictures() {
  const { plan } = choice, note = byId("undrawn"), part = partOf(plan);
  const [shot, others] = plan ? shotFor(plan) : [null, []];
  const payload = part && page.payloads[`${tuning.families[part[0]].group}-${tuning.families[part[0]].value}`];
  const layers = plan ? { original: "original", ...(shot ? shot.layers : {}), ...(payload ? { payload } : {}) } : {};
  const refreshed = others.join("; ");
  showShot({ ...shot, layers }, others.length ? { cached: `cached, ${refreshed}` } : {},
    plan ? ["There are no pictures of this plan."] : originalAlone());
  note.hidden = !plan || Boolean(shot && !others.length);
  note.textContent = others.length
    ? `This plan was not drawn. The pictures are of the same with a refresh ${refreshed}.`
    : "This plan was not drawn: it is only predicted. The payload shows the same value.";
}

async function showPlanSource() {
  const { plan } = choice;
  if (texts === null) await unpackTexts();
  if (plan !== choice.plan) return; // another was chosen while the texts were unpacked
  const parts = plan ? plan.parts : [], own = byId("source-name");
  const names = parts.length ? parts.map(([number]) => groupOf(number).fragment) : [tuning.groups[0].fragment];
  const show = (name) => {
    shownPart.at = Math.max(0, names.indexOf(name));
    showSourceOf(partOf(plan));
  };
  showTabs(own, names, names[Math.min(shownPart.at, names.length - 1)], show);
}

function showSourceOf(part) {
  const group = part ? tuning.families[part[0]].group : 0, files = page.sources[group];
  const fragment = Object.keys(files)[0];
  showCode(byId("source"), files[fragment], (text) => spansOf(text, part ? valueOf(part[0]).places : []));
  showPlanPictures();
  const emitted = part ? { ...page.families[part[0]].files } : {};
  for (const [name, hash] of Object.entries(files)) if (name !== fragment) emitted[name] = hash;
  const shown = Object.keys(emitted), pane = byId("emitted");
  const kept = byId("emitted-tabs").querySelector("[aria-selected=true]");
  showTabs(byId("emitted-tabs"), shown, kept && shown.includes(kept.textContent) ? kept.textContent : shown[0],
    (name) => showCode(pane, emitted[name], () => []));
  if (!shown.length) pane.replaceChildren(make("span", { class: "line" }, "There are no files: nothing is emitted."));
}

function setUpChosen() {
  setUpViewer(PICTURES_ABSENT);
  choice.listeners.plan.push(() => soon(showPlanSource));
  choice.listeners.bound.push(() => soon(showChosen));
}
