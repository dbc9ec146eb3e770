"use strict";
// Plans: what is cached of each group, with its period; what is known of each, and the front.

// A plan that is only predicted goes before one that is proven where it is expected to take less than
// this share of its time: so much would be tried by the proof, too.
const FASTER = 0.96;

const keyOf = (parts, without = []) =>
  [[...parts].sort(([a], [b]) => a - b).map((part) => part.join(":")).join(" "), ...without].join(" -");
const speedOf = (share) => 1 / share;
// Of several groups together models may promise more than all of the time; nobody can keep that.
const isFaster = (share) => share > 0 && share < 1;
const surely = (speedup) => speedup.low > 1;

const proven = new Map(tuning.proven.map((one) => [keyOf(one.plan, one.without), one]));
const finalists = new Map(tuning.finalists.map((one) => [keyOf(one.plan, one.without), one]));
const shots = new Map(page.shots.map((one) => [keyOf(one.plan, one.without), one]));

// All that is known of a plan of parts [family, period]; objects `without` it are drawn by their
// originals, of which models know nothing. `need`: the bound it needs, since at up to twice the speed no frame
// errs by more; `share` of the original's time; both by the best evidence there is. `pays`: is it
// faster than the original, and surely so where that was measured?
function planOf(parts, without = []) {
  const key = keyOf(parts, without), predicted = predict(parts);
  const found = { parts, without, key, predicted, proven: proven.get(key), finalist: finalists.get(key) };
  if (found.proven) {
    const { worst, speedup, passages } = found.proven;
    return {
      ...found, evidence: "proven", need: worst, share: 1 / speedup.median,
      pays: passages.every((one) => surely(one.speedup)),
    };
  }
  if (found.finalist) {
    const { worst, speedup } = found.finalist.drawn;
    const haste = predicted.error > 0 ? predicted.hasty / predicted.error : 1;
    return { ...found, evidence: "measured", need: haste * worst, share: 1 / speedup.median, pays: surely(speedup) };
  }
  return { ...found, evidence: "predicted", need: predicted.hasty, share: predicted.share, pays: isFaster(predicted.share) };
}

// Of options with error and share those that no other is as near and as fast as, the nearest first.
function best(options) {
  const found = [];
  for (const one of [...options].sort((a, b) => a.hasty - b.hasty || a.share - b.share)) {
    if (!found.length || one.share < found.at(-1).share) found.push(one);
  }
  return found;
}

// The front that the models foretell, as parts, of what is not `known` otherwise. Groups are combined
// where they can share a cache.
function predictedFront(known) {
  const alone = (number) => periodsOf(number).map((period) => [number, period])
    .filter((part) => tuning.groups.length > 1 || !known(keyOf([part])));
  const found = [];
  for (const same of Map.groupBy(fittedFamilies, (number) => page.families[number].kind).values()) {
    let options = [{ parts: [], hasty: 0, share: 1 }];
    for (const own of Map.groupBy(same, (number) => tuning.families[number].group).values()) {
      const added = best(own.flatMap(alone).map((part) => ({ parts: [part], ...predict([part]) })));
      options = best([...options, ...options.flatMap(({ parts }) =>
        added.map((one) => ({ parts: [...parts, ...one.parts], ...predict([...parts, ...one.parts]) })))]);
    }
    found.push(...options);
  }
  return best(found).filter(({ parts, share }) => parts.length && isFaster(share) && !known(keyOf(parts)))
    .map(({ parts }) => parts);
}

// Everything that the slider may pick: what was drawn at full length, and what the models foretell.
const drawn = new Map([...finalists, ...proven].map(([key, { plan, without }]) => [key, planOf(plan, without)]));
const picks = [...drawn.values(), ...predictedFront((key) => drawn.has(key)).map((parts) => planOf(parts))]
  .filter(({ pays }) => pays);

const fastest = (plans) => plans.reduce((one, other) => (other.share < one.share ? other : one));

// The plan for a bound, an error: the fastest within it, or null.
function pickWithin(bound) {
  const fitting = picks.filter(({ need }) => need <= bound);
  if (!fitting.length) return null;
  const first = fastest(fitting), sure = fitting.filter(({ evidence }) => evidence === "proven");
  return sure.length && first.share >= FASTER * fastest(sure).share ? fastest(sure) : first;
}

// Where the pick changes as the bound grows: [bound, plan].
const stops = [];
for (const { need } of [...picks].sort((a, b) => a.need - b.need)) {
  const plan = pickWithin(need);
  if (plan !== (stops.length ? stops.at(-1)[1] : null)) stops.push([need, plan]);
}

// Words.
const metricWords = page.metric;

function errorTold(error) {
  if (error == null) return "–";
  if (tuning.metric !== "psnr") return errorText(error);
  return error > 0 ? `${(-20 * Math.log10(error)).toFixed(1)} dB` : "∞ dB";
}

const timesText = (share) => `${speedOf(share).toFixed(2)}×`;
const ratioText = ({ median, low, high }) => `${median.toFixed(2)}× [${low.toFixed(2)}–${high.toFixed(2)}]`;
const groupOf = (number) => tuning.groups[tuning.families[number].group];
const valueOf = (number) => groupOf(number).values[tuning.families[number].value];
const algorithmOf = (number) => tuning.families[number].configuration.algorithm;
const periodWords = (period) => (period === 1 ? "in every frame" : `every ${period} frames`);
const wayOf = ([number, period]) => `${page.families[number].way}, ${periodWords(period)}`;

const EVIDENCE = {
  proven: "proven on unseen frames", measured: "measured, not proven", predicted: "predicted, not measured",
};

function chip(evidence) {
  return make("span", { class: `chip ${evidence}` }, EVIDENCE[evidence]);
}
