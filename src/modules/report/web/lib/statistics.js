// Statistics of lists of numbers, and means of points over bins.

/** @param {number[]} values */
export const mean = values => values.reduce((a, b) => a + b, 0) / values.length;

/** The root of the mean square; 0 of no values. @param {number[]} values */
export const rms = values => Math.sqrt(values.reduce((sum, value) => sum + value * value, 0) / Math.max(1, values.length));

/**
 * The value that a share of the values does not exceed; 0 when there are none.
 * @param {number[]} values
 * @param {number} share
 */
export function quantile(values, share) {
  const sorted = Float64Array.from(values).sort();
  return sorted.length ? sorted[Math.floor(share * (sorted.length - 1))] : 0;
}

/** Smallest and largest value, however many there are. @param {number[]} values @returns {[number, number]} */
export const extent = values => [values.reduce((a, b) => Math.min(a, b), Infinity), values.reduce((a, b) => Math.max(a, b), -Infinity)];

/**
 * Lists of members by a key.
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

const fewValues = 6; // of x: then each is a bin of its own

/**
 * Means of points over bins of x with as many groups each, or one for each value of x where there are few. Points with
 * sigmas weigh by them. Points of one group count once, for they are not independent; with `places` once in each of so
 * many parts of the range of x. The standard error comes from how the groups of a bin differ; where points have sigmas
 * it is never below what these say.
 * @template {Point} P
 * @param {P[]} points
 * @param {{groupOf: (point: P) => string | number, places?: number, most?: number}} grouping most: number of bins
 * @returns {{x: number, y: number, error: number}[]}
 */
export function binnedMeans(points, {groupOf, places = 0, most = 10}) {
  const [low, high] = extent(points.map(({x}) => x)), range = high - low || 1;
  const groups = groupBy(points, point => groupOf(point) + (places ? "\n" + Math.round(places * (point.x - low) / range) : ""));
  const members = [...groups.values()].map(weightedMean).sort((a, b) => a.x - b.x);
  return bins(members, range, most).filter(bin => bin.length > 1).map(bin => ({...weightedMean(bin), error: standardError(bin)}))
    .filter(({error}) => error > 0);
}

/** How many standard errors means lie from zero, as root mean square; 0 of fewer than two. @param {{y: number, error: number}[]} means */
export const trendStrength = means => means.length > 1 ? rms(means.map(({y, error}) => y / error)) : 0;

/** @param {Point[]} list @returns {Point} */
function weightedMean(list) {
  const weights = list.map(({sigma}) => sigma === undefined ? 1 : sigma ** -2), sum = weights.reduce((a, b) => a + b, 0);
  const over = (/** @type {"x" | "y"} */ key) => list.reduce((all, point, i) => all + weights[i] * point[key], 0) / sum;
  return {x: over("x"), y: over("y"), ...(list[0].sigma !== undefined && {sigma: sum ** -0.5})};
}

/** Of the mean of a bin. @param {Point[]} bin */
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
