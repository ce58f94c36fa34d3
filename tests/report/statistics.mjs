// Proves binned means and formats on cases calculated by hand. Requires only Node.js.
import assert from "node:assert/strict";
import {binnedMeans, mean, quantile, rms, trendStrength} from "../../src/modules/report/web/lib/statistics.js";
import {capitalized, detectableWords, sizeWords, stateName, withError} from "../../src/modules/report/web/lib/format.js";

const near = (found, expected) => assert.ok(Math.abs(found - expected) < 1e-12, found + " is not " + expected);

near(mean([1, 2, 6]), 3);
near(rms([3, 4]), Math.sqrt(12.5));
assert.equal(quantile([5, 1, 3], 0.5), 3);
assert.equal(quantile([], 0.5), 0);

// Few values of x: each is a bin; error = standard deviation / sqrt(count).
const two = binnedMeans([[0, 1], [0, 3], [1, 5], [1, 5], [1, 8]].map(([x, y], i) => ({x, y, i})), {groupOf: ({i}) => i});
assert.deepEqual(two.map(({x, y}) => [x, y]), [[0, 2], [1, 6]]);
near(two[0].error, Math.SQRT2 / Math.sqrt(2));
near(two[1].error, Math.sqrt(3) / Math.sqrt(3));

// Points of one group are not independent: repeating them ten times changes nothing.
const points = [[0, 1], [0, 3], [0, 5]].map(([x, y], i) => ({x, y, i}));
const repeated = binnedMeans(points.flatMap(point => new Array(10).fill(point)), {groupOf: ({i}) => i});
assert.deepEqual(repeated, binnedMeans(points, {groupOf: ({i}) => i}));

// With `places`, a group counts once per part of the range of x.
const moved = [0, 0, 1, 1].map((x, i) => ({x, y: i, pose: "P"}));
assert.equal(binnedMeans(moved, {groupOf: ({pose}) => pose}).length, 0);
assert.equal(binnedMeans([...moved, ...moved.map(point => ({...point, y: point.y + 1, pose: "Q"}))], {groupOf: ({pose}) => pose, places: 10}).length, 2);

// Sigmas are weights, and the lower limit of the error.
const weighted = binnedMeans([{x: 0, y: 0, sigma: 1, i: 0}, {x: 0, y: 0.3, sigma: 0.5, i: 1}], {groupOf: ({i}) => i});
near(weighted[0].y, 0.24);
near(weighted[0].error, Math.sqrt(1 / 5));

// Many values: `most` bins with equal numbers of groups.
const many = Array.from({length: 200}, (_, i) => ({x: i, y: i % 2, i}));
assert.equal(binnedMeans(many, {groupOf: ({i}) => i, most: 8}).length, 8);
near(trendStrength([{y: 3, error: 1}, {y: 4, error: 1}]), Math.sqrt(12.5));
assert.equal(trendStrength([{y: 3, error: 1}]), 0);

assert.equal(withError(-1.23456, 0.012, "°"), "−1.235 ± 0.012°");
assert.equal(withError(-1.27e-5, 4.8e-6), "−0.0000127 ± 0.0000048");
const size = {name: "k", unit: "°/Nm", value: 0.5, sigma: 0.1, detectable: 0.1294, told: true};
assert.equal(sizeWords(size), "k = 0.50 ± 0.10°/Nm");
assert.equal(sizeWords({...size, told: false}), "k undetermined");
assert.equal(detectableWords(size), "0.13°/Nm");
assert.deepEqual(["present", "aliased", "trivial", "absent", "inconclusive", "absorbed", "no-data"].map(stateName),
  ["needed", "could explain", "too small to matter", "ruled out", "undecided", "not testable here", "no data"]);

// Sentences begin with a capital; names of joints, links and effects stay as they are.
assert.equal(capitalized("it moves"), "It moves");
assert.equal(capitalized("a joint's zero"), "A joint's zero");
for (const name of ["elbow_joint's zero", "HeadYaw", "radialDistortion@wrist is missing", "joint5", ""]) {
  assert.equal(capitalized(name), name);
}
console.log("all held");
