"use strict";
// The bound that is asked for, and the plan that goes with it.

const choice = {
  bound: 1,
  // Which of the bounds that were asked of the tuning it is, or null.
  asked: null,
  // The plan that is looked at; null: leave the shader alone. `pinned`: whoever reads chose it.
  plan: null,
  pinned: false,
  listeners: { bound: [], plan: [] },

  tell(what) {
    for (const listener of this.listeners[what]) listener();
  },

  chooseBound(error) {
    const at = page.verdicts.findIndex((one) => one.error === error);
    this.asked = at < 0 ? null : at;
    this.look(error, this.asked === null ? pickWithin(error) : answerOf(at), false);
  },

  // What is within the bound, whatever was answered to it.
  expect() {
    this.look(this.bound, pickWithin(this.bound), true);
  },

  choosePlan(parts, without) {
    const plan = planOf(parts, without);
    this.asked = null;
    this.look(Math.max(plan.need, 10 ** range[0]), plan, true);
  },

  look(bound, plan, pinned) {
    const same = (plan && plan.key) === (this.plan && this.plan.key) && this.told;
    Object.assign(this, { bound, plan, pinned, told: true });
    if (!same) this.tell("plan");
    this.tell("bound");
  },
};

function answerOf(at) {
  const { proven: number } = tuning.answers[at];
  if (number === null) return null;
  const { plan, without } = tuning.proven[number];
  return planOf(plan, without);
}

// The curve of a family: bound that is needed and speed, at whole periods.
function curveOf(number) {
  const ends = periodsOf(number), first = ends[0], last = ends.at(-1);
  const between = Array.from({ length: last }, (_, at) => at + 1)
    .filter((period) => period >= first && (period <= 12 || period % (period <= 24 ? 2 : 4) === 0));
  return between.map((period) => ({ period, x: hastyError(number, period), y: 1 / familyShare(number, period) }));
}
const curves = fittedFamilies.map((number) => ({ number, points: curveOf(number) }));

// The bounds that the slider goes through, as powers of ten: those asked for, and those of all that
// is faster than the original.
const range = (() => {
  const every = curves.flatMap(({ points }) => points), faster = every.filter(({ y }) => y > 1);
  const needs = [...picks.map(({ need }) => need), ...page.verdicts.map(({ error }) => error),
    ...(faster.length ? faster : every).map(({ x }) => x)];
  const [low, high] = decades(needs), asked = Math.min(...page.verdicts.map(({ error }) => error));
  // No error exceeds 1 by much, and far below what was asked for nothing is of interest.
  return [Math.max(low, Math.log10(asked) - 2), Math.min(high, 0.3)];
})();
const STEPS = 500;
// Bounds that were asked for are met by a slider so near to them.
const NEAR = 5;

const stepOf = (bound) => (STEPS * (Math.log10(bound) - range[0])) / (range[1] - range[0]);

function boundAt(step) {
  const near = page.verdicts.map(({ error }) => [Math.abs(stepOf(error) - step), error]).sort(([a], [b]) => a - b)[0];
  return near && near[0] <= NEAR ? near[1] : 10 ** (range[0] + (step / STEPS) * (range[1] - range[0]));
}

// The bound as it is written: as it was asked for, where it was.
const boundText = () => (choice.asked === null ? errorTold(choice.bound) : page.verdicts[choice.asked].limit);

function showBound() {
  const slider = byId("bound"), { bound, plan } = choice;
  // A slider that is dragged near an asked bound stays where the hand is.
  if (boundAt(Number(slider.value)) !== bound) slider.value = stepOf(bound);
  const words = plan ? `${timesText(plan.share)} as fast` : "leave it alone";
  slider.setAttribute("aria-valuetext", `${metricWords} ${boundText()}: ${words}`);
  byId("readout").replaceChildren(
    make("span", { class: "within" }, "within ", make("b", {}, `${metricWords} ${boundText()}`)),
    make("b", { class: "times" }, plan ? timesText(plan.share) : "leave it alone"),
    ...(plan ? [make("code", {}, short(plan.parts.map(([number]) => valueOf(number).text).join(" + "), 44)),
      make("span", { class: "way" }, plan.parts.map(wayOf).join("; ")), chip(plan.evidence)] : []),
  );
  document.querySelectorAll("#verdicts button, #ticks button").forEach((button) =>
    button.setAttribute("aria-pressed", String(Number(button.dataset.at) === choice.asked)));
}

function setUpBound() {
  const slider = byId("bound");
  slider.max = STEPS;
  slider.addEventListener("input", () => choice.chooseBound(boundAt(Number(slider.value))));
  byId("ticks").replaceChildren(...page.verdicts.map(({ error, limit }, at) => {
    const tick = make("button", { type: "button", "data-at": at, style: `left:${(100 * stepOf(error)) / STEPS}%` }, limit);
    tick.addEventListener("click", () => choice.chooseBound(error));
    return tick;
  }));
  choice.listeners.bound.push(showBound);
}

function setUpVerdicts() {
  byId("verdicts").replaceChildren(...page.verdicts.map((one, at) => {
    const card = make("button", { type: "button", "data-at": at, class: one.small ? "verdict" : "verdict alone" },
      make("span", { class: "bound" }, `within ${metricWords} ${one.limit}`),
      make("span", { class: "big" }, one.large, one.small ? make("small", {}, one.small) : null),
      make("span", { class: "words" }, ...marked(one.text)));
    card.addEventListener("click", () => choice.chooseBound(one.error));
    return card;
  }));
}
