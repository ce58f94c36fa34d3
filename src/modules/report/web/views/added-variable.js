// Added-variable plot: one point per pose; the slope of the line is the candidate's size.
import {bold, button, element, renew} from "naocal/lib/dom.js";
import {figure, colours} from "naocal/lib/figure.js";
import {axes, dot} from "naocal/lib/axes.js";
import {short, withError, withUnit} from "naocal/lib/format.js";
import {rms} from "naocal/lib/statistics.js";
import {captureNames} from "naocal/lib/captures.js";

/** @import {AddedVariable, Candidate, Taken, Target, View} from "naocal/lib/types.js" */

const shownFirst = 4, shownMost = 10;

/** @param {Candidate} candidate @param {Taken} data */
function addedVariable(candidate, data) {
  const {label} = candidate, added = /** @type {AddedVariable} */ (candidate.added), {poseName, poseTip} = captureNames(data);
  const tipOf = (/** @type {[number, number, number]} */ [pose, a, b]) => poseTip(pose) + "\n" + label + " from this pose alone: " +
    slopeWords(added, b / a, 1 / Math.abs(a)) + "\nit moves the pose " + (a < 0 ? "against" : "in") + " the sense of " + added.like;
  return element("figure", {}, figure({height: 280, label: "what each pose says about " + label,
    draw: (context, width, height) => draw(context, width, height, added, tipOf)}),
  element("figcaption", {}, bold(label), ": " + summary(added, poseName)));
}

/** @param {AddedVariable} added @param {number} slope @param {number} sigma */
const slopeWords = ({of, unit}, slope, sigma) =>
  withUnit(of + " = " + withError(slope, sigma), unit || (of === "size" ? "times what was found" : ""));

/** @param {number} value */
const twoDigits = value => short(Number(value.toPrecision(2)));

/** The size, and its significance without the most influential pose. @param {AddedVariable} added @param {(pose: number) => string} poseName */
function summary(added, poseName) {
  const {slope, sigma, points} = added, strength = Math.abs(slope) / sigma;
  const without = points.filter(([pose]) => pose !== null).map(([pose, x, y]) => {
    const squares = sigma ** -2 - x * x;
    return {pose: Number(pose), y: y - slope * x, slope: (slope / sigma ** 2 - x * y) / squares, sigma: squares > 0 ? squares ** -0.5 : Infinity};
  });
  const weakest = without.reduce((a, b) => Math.abs(a.slope) / a.sigma < Math.abs(b.slope) / b.sigma ? a : b);
  const left = Math.abs(weakest.slope) / weakest.sigma;
  const words = slopeWords(added, slope, sigma) + ", " + twoDigits(strength) + " sigma from zero; poses scatter around the line by " +
    twoDigits(rms(without.map(({y}) => y))) + " sigma";
  if (strength < 2) return words + ": the line is flat.";
  return words + (left < strength / 2 ? "; " + poseName(weakest.pose) + " alone carries most of it: " : "; without " +
    poseName(weakest.pose) + ", which counts most, ") + twoDigits(left) + " sigma" + (left < strength / 2 ? " without it." : ".");
}

/**
 * One point per pose, the fitted line, and its band of two standard errors.
 * @param {CanvasRenderingContext2D} context
 * @param {number} width
 * @param {number} height
 * @param {AddedVariable} added
 * @param {(point: [number, number, number]) => string} tipOf
 * @returns {Target[]}
 */
function draw(context, width, height, {of, unit, slope, sigma, points}, tipOf) {
  const box = {left: 46, right: width - 8, top: 30, bottom: height - 42};
  const spread = (/** @type {number[]} */ values, /** @type {number} */ least) => {
    const low = Math.min(0, ...values), high = Math.max(0, ...values), margin = 0.06 * (high - low) + least;
    return [low - margin, high + margin];
  };
  const [left, right] = spread(points.map(([, x]) => x), 1e-9), [bottom, top] = spread(points.map(([, , y]) => y), 1);
  const {x, y, line} = axes(context, box, [left, right], [bottom, top], {title: "measured shift [sigma]",
    xLabel: "expected shift for " + (of === "size" ? "the size found" : withUnit(of + " = 1", unit)) + " [sigma]"});
  context.save();
  context.beginPath();
  context.rect(box.left, box.top, box.right - box.left, box.bottom - box.top);
  context.clip();
  context.strokeStyle = context.fillStyle = colours.orange;
  for (const end of [left, right]) {
    context.globalAlpha = 0.2;
    context.beginPath();
    context.moveTo(x(0), y(0));
    context.lineTo(x(end), y(end * (slope - 2 * sigma)));
    context.lineTo(x(end), y(end * (slope + 2 * sigma)));
    context.fill();
    context.globalAlpha = 1;
  }
  context.lineWidth = 2;
  line(x(left), y(left * slope), x(right), y(right * slope));
  context.restore();
  context.strokeStyle = context.fillStyle = colours.blue;
  context.lineWidth = 1;
  return points.filter(([pose]) => pose !== null).map(point => {
    const [, a, b] = point, target = {x: x(a), y: y(b)};
    context.globalAlpha = 0.45;
    line(x(a), y(b - 1), x(a), y(b + 1));
    context.globalAlpha = 1;
    dot(context, target);
    return {...target, tip: () => tipOf(/** @type {[number, number, number]} */ (point))};
  });
}

const explanation = "Each point is a pose. Across: how far the effect would move what was measured there, in a way that nothing else in the model can follow. Up: how far " +
  "it was measured to have moved in that direction. Both in standard errors of noise. Convincing: many poses along a line that is not flat; " +
  "its slope is the effect's size, with a band of two standard errors. Suspicious: one far point that carries the line alone.";

/** @type {View} */
export const view = {
  place: 10, title: "What each pose says", about: "candidates",
  show: data => {
    const plotted = data.candidates.filter(({added}) => added).slice(0, shownMost), grid = element("div", {class: "grid"});
    if (!plotted.length) return null;
    const show = (/** @type {number} */ count) => renew(grid, ...plotted.slice(0, count).map(candidate => addedVariable(candidate, data)));
    const more = button("show all " + plotted.length, () => { more.hidden = true; show(plotted.length); }, {hidden: plotted.length <= shownFirst});
    show(shownFirst);
    return [element("p", {}, explanation), grid, element("p", {class: "controls"}, more)];
  },
  ofCandidate: (candidate, data) => candidate.added && [element("p", {class: "soft"}, "Convincing: many poses along a line that is not flat."),
    addedVariable(candidate, data)],
};
