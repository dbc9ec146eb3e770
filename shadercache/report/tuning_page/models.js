"use strict";
// The models of tuning: error and time of a family of configurations over its refresh period, after
// Sitthi-amorn et al. 2008 and Scherzer et al. 2010.

const tuning = page.tuning;

function hitRate(mu, period) {
  return mu * (1 - 1 / period);
}

function modelShare(time, period) {
  const rate = hitRate(time.mu, period);
  return rate * time.hit.value + (1 - rate) * time.miss.value;
}

function modelError(error, period) {
  if (error.follows) return error.alpha.value * -Math.expm1(-error.rate.value * (period - 1));
  // In the logarithm of the period; 0 where all is recomputed.
  const points = error.points[0][0] === 1 ? error.points : [[1, 0], ...error.points];
  const places = points.map(([at]) => Math.log(at)), errors = points.map(([, value]) => value);
  const place = Math.log(period), last = places.length - 1;
  if (place > places[last] && last > 0) { // on along the last piece, but never down
    const slope = (errors[last] - errors[last - 1]) / (places[last] - places[last - 1]);
    return errors[last] + Math.max(0, slope) * (place - places[last]);
  }
  const next = places.findIndex((one) => one >= place);
  if (next < 0) return errors[last];
  if (next === 0) return errors[0];
  const part = (place - places[next - 1]) / (places[next] - places[next - 1]);
  return errors[next - 1] + part * (errors[next] - errors[next - 1]);
}

// Families are known by their numbers.
const familyShare = (number, period) => modelShare(tuning.families[number].time, period);
const familyError = (number, period) =>
  tuning.families[number].scale * modelError(tuning.families[number].error, period);
// The error where the scene is played twice as fast: what is reused has seen the motion of a longer
// period, if its value moves; what is not errs as ever.
function hastyError(number, period) {
  const { group, value, haste } = tuning.families[number];
  const moves = tuning.groups[group].values[value].changes.length > 0;
  const fresh = familyError(number, 1);
  return fresh + haste * (familyError(number, moves ? 2 * period - 1 : period) - fresh);
}

const isFitted = (number) => Boolean(tuning.families[number].time && tuning.families[number].error);
const fittedFamilies = tuning.families.map((_, number) => number).filter(isFitted);

// The periods that may be chosen. What is computed at a fraction of the rate saves something even
// where all is recomputed; of what adapts nothing is known but at the longest period.
function periodsOf(number) {
  const { payload_rate: rate, refresh } = tuning.families[number].configuration;
  const some = rate === "full" ? tuning.periods : [1, ...tuning.periods];
  return refresh.adaptive > 0 ? some.slice(-1) : some;
}

// What is predicted of parts [family, period] together: groups save beside each other, and their
// errors lie in different pixels, so squares add.
function predict(parts) {
  const together = (errors) => Math.sqrt(errors.reduce((sum, error) => sum + error * error, 0));
  return {
    share: 1 - parts.reduce((sum, part) => sum + 1 - familyShare(...part), 0),
    error: together(parts.map((part) => familyError(...part))),
    hasty: together(parts.map((part) => hastyError(...part))),
  };
}
