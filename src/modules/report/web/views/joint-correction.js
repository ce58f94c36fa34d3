// Joint error that would explain the misfit alone, over any recorded quantity.
import {bold, choosing, element} from "naocal/lib/dom.js";
import {captioned} from "naocal/lib/figure.js";
import {short, withError, withUnit} from "naocal/lib/format.js";
import {binnedMeans, mean, trendStrength} from "naocal/lib/statistics.js";
import {captureNames, orderOfTaking} from "naocal/lib/captures.js";
import {modelChoice} from "naocal/views/model-choice.js";
import {drawScatter} from "naocal/plots/residual-scatter.js";

/** @import {Diagnosis, Driver, Left, View} from "naocal/lib/types.js" */

/** Pose order as a driver, to show drifts. @param {Diagnosis} data @returns {Driver} */
function poseOrder({poses, pictures}) {
  const places = orderOfTaking(poses.map(pose => ({set: pose.set, capture: Math.min(...pose.pictures.map(picture => pictures[picture].capture))})));
  return {what: "the order of the poses", unit: "", joint: "", values: pictures.map(({pose}) => places[pose])};
}

/** A joint's points over a driver, and their binned means. @param {Diagnosis} data @param {Left} left @param {string} joint @param {Driver} driver */
function pointsOf(data, left, joint, driver) {
  const readings = left.whatIf.find(one => one.joint === joint)?.points ?? [];
  const points = readings.map(([pictures, y, sigma]) => ({x: mean(pictures.map(picture => driver.values[picture])), y, sigma, pictures}));
  return {points, means: binnedMeans(points, {groupOf: ({pictures}) => data.pictures[pictures[0]].pose, places: 10, most: 8})};
}

/** Joints with points, each with its drivers; strongest trends first. @param {Diagnosis} data @param {Left} left */
function jointsByTrend(data, left) {
  const drivers = [...data.drivers, poseOrder(data)];
  const offered = (/** @type {string} */ joint) => drivers.filter(driver => !driver.joint || driver.joint === joint)
    .map(driver => ({driver, strength: trendStrength(pointsOf(data, left, joint, driver).means)})).sort((a, b) => b.strength - a.strength);
  return left.whatIf.filter(({points}) => points.length).map(({joint}) => ({joint, offered: offered(joint)}))
    .sort((a, b) => b.offered[0].strength - a.offered[0].strength);
}

/** @param {Diagnosis} data @param {Left} left @param {string} joint @param {Driver} driver @param {(picture: number) => void} [open] */
function jointCorrection(data, left, joint, driver, open) {
  const {points, means} = pointsOf(data, left, joint, driver), {unit, what} = driver, {poseName} = captureNames(data);
  const strength = trendStrength(means), jointUnit = left.whatIf.find(one => one.joint === joint)?.unit ?? "°";
  return captioned({height: 340, label: "error of " + joint + " over " + what, open, draw: (context, width, height, caption) => {
    caption.replaceChildren(bold(joint + " over " + what), strength > 2
      ? ": a trend, its means lie " + strength.toFixed(1) + " standard errors from zero."
      : ": no trend, its means lie about as far from zero as by chance (" + strength.toFixed(1) + " standard errors).");
    return drawScatter(context, width, height, {
      points: points.map(({x, y, sigma, pictures}) => ({x, y, sigma, picture: pictures[0], tip: () =>
        poseName(data.pictures[pictures[0]].pose) + "\ncaptures " + pictures.map(picture => data.pictures[picture].capture).join(", ") +
        "\n" + what + ": " + withUnit(short(x), unit) + "\n" + joint + " off by " + withError(y, sigma, jointUnit)})),
      means, title: "error of " + joint + " that would explain the misfit [" + jointUnit + "]", xLabel: what + (unit ? " [" + unit + "]" : ""),
    });
  }});
}

/** @type {View} */
export const view = {
  place: 60, title: "Joint error that would explain the misfit", about: "misfit",
  show: (data, {open}) => {
    const {asGiven} = data.left, ranked = asGiven ? jointsByTrend(data, asGiven) : [];
    if (!ranked.length) return null;
    // Opens on the cause that the diagnosis found, or the best candidate's joint: several joints can have similar trends.
    const cause = data.causes.find(({error}) => ranked.some(({joint}) => joint === error));
    const best = cause?.error ?? (data.candidates.length ? data.candidates[0].label.split("@")[1] : "");
    const first = ranked.some(({joint}) => joint === best) ? best : ranked[0].joint;
    const driverOf = (/** @type {Left} */ left, /** @type {{joint: string, offered: {driver: Driver}[]}} */ {joint, offered}) =>
      choosing("bentOver", "over", offered.map(({driver: {what}}) => ({value: what, text: what})),
        what => jointCorrection(data, left, joint, offered.map(({driver}) => driver).find(one => one.what === what) ?? offered[0].driver, open),
        joint === cause?.error && offered.some(({driver}) => driver.what === cause.over) ? cause.over : offered[0].driver.what);
    return [element("p", {}, "Error of one joint that alone would explain the misfit, one point for each encoder reading of a pose with one " +
      "standard error, over anything that was recorded. Squares: means over bins, with two standard errors. Good: squares stay at zero. " +
      "Suspicious: a slope, a bend or a step. It opens on the cause that was found; both lists begin with the strongest trend."),
    modelChoice("bentBy", data, left => choosing("bent", "Joint", ranked.map(({joint}) => ({value: joint, text: joint})),
      joint => driverOf(left, ranked.find(one => one.joint === joint) ?? ranked[0]), first))];
  },
};
