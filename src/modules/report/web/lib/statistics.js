// Statistics of number lists; binned means.

/** @param {number[]} values */
export const mean = values => values.reduce((a, b) => a + b, 0) / values.length;

/** Root mean square; 0 for an empty list. @param {number[]} values */
export const rms = values => Math.sqrt(values.reduce((sum, value) => sum + value * value, 0) / Math.max(1, values.length));

/**
 * Quantile at `share` (lower value, not interpolated); 0 for an empty list.
 * @param {number[]} values
 * @param {number} share
 */
export function quantile(values, share) {
  const sorted = Float64Array.from(values).sort();
  return sorted.length ? sorted[Math.floor(share * (sorted.length - 1))] : 0;
}

/** Minimum and maximum; no spread arguments, so lists of any length work. @param {number[]} values @returns {[number, number]} */
export const extent = values => [values.reduce((a, b) => Math.min(a, b), Infinity), values.reduce((a, b) => Math.max(a, b), -Infinity)];

/**
 * Groups members by key.
 * @template T
 * @param {Iterable<T>} list
 * @param {(member: T) => string | number} keyOf
 * @returns {Map<string | number, T[]>}
 */
export function groupBy(list, keyOf) {
  /** @type {Map<string | number, T[]>} */
  const groups = new Map();
  for (const member of list) {
    const key = keyOf(member), group = groups.get(key);
    if (group) group.push(member);
    else groups.set(key, [member]);
  }
  return groups;
}

/** @typedef {{x: number, y: number, sigma?: number}} Point */

const fewValues = 6; // distinct values of x; up to this, each is its own bin

/**
 * Means over bins of x with equal numbers of groups, or one bin per distinct x if there are few. Points with sigmas are
 * weighted by 1/sigma^2. Points of a group are not independent and count as one: their mean; with `places`, one mean per
 * group and 1/places of the range of x. The standard error is estimated from the scatter between the groups of a bin;
 * with sigmas, it is at least the propagated one. Bins of one group are dropped.
 * @template {Point} P
 * @param {P[]} points
 * @param {{groupOf: (point: P) => string | number, places?: number, most?: number}} grouping most: maximum number of bins
 * @returns {{x: number, y: number, error: number}[]}
 */
export function binnedMeans(points, {groupOf, places = 0, most = 10}) {
  const [low, high] = extent(points.map(({x}) => x)), range = high - low || 1;
  const groups = groupBy(points, point => groupOf(point) + (places ? "\n" + Math.round(places * (point.x - low) / range) : ""));
  const members = [...groups.values()].map(weightedMean).sort((a, b) => a.x - b.x);
  return bins(members, range, most).filter(bin => bin.length > 1).map(bin => ({...weightedMean(bin), error: standardError(bin)}))
    .filter(({error}) => error > 0);
}

/** RMS of the means in units of their standard errors; 0 for fewer than two means. @param {{y: number, error: number}[]} means */
export const trendStrength = means => means.length > 1 ? rms(means.map(({y, error}) => y / error)) : 0;

/** @param {Point[]} list @returns {Point} */
function weightedMean(list) {
  const weights = list.map(({sigma}) => sigma === undefined ? 1 : sigma ** -2), sum = weights.reduce((a, b) => a + b, 0);
  const over = (/** @type {"x" | "y"} */ key) => list.reduce((all, point, i) => all + weights[i] * point[key], 0) / sum;
  return {x: over("x"), y: over("y"), ...(list[0].sigma !== undefined && {sigma: sum ** -0.5})};
}

/** Standard error of a bin's weighted mean. @param {Point[]} bin */
function standardError(bin) {
  const {y: middle, sigma} = weightedMean(bin);
  const spread = Math.sqrt(bin.reduce((sum, {y, sigma: own}) => sum + ((y - middle) / (own ?? 1)) ** 2, 0) / (bin.length - 1));
  return sigma === undefined ? spread / Math.sqrt(bin.length) : sigma * Math.max(1, spread);
}

/** @param {Point[]} members in ascending order @param {number} range @param {number} most */
function bins(members, range, most) {
  const values = groupBy(members, ({x}) => Math.round(50 * x / range));
  if (values.size <= fewValues) return [...values.values()];
  const count = Math.max(1, Math.min(most, Math.floor(members.length / 4)));
  return Array.from({length: count}, (_, i) =>
    members.slice(Math.round(i * members.length / count), Math.round((i + 1) * members.length / count)));
}
