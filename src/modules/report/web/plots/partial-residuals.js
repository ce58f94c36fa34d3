// Partial residuals of a cause: the error without the effect and with it, side by side on the same axes.
import {axes, dot, fitting, placeBeside, widened} from "naocal/lib/axes.js";
import {bold, element} from "naocal/lib/dom.js";
import {colours, figure} from "naocal/lib/figure.js";
import {short, withError, withUnit} from "naocal/lib/format.js";
import {extent} from "naocal/lib/statistics.js";

/** @import {Cause, Target} from "naocal/lib/types.js" */

/** @typedef {{nameOf: (pictures: number[]) => string, open?: (picture: number) => void}} PartialTools names the captures of a point; shows the first of them */

const fewValues = 6; // distinct values of the driver; up to this, points of equal value are drawn beside each other

/** @param {Cause} cause @param {PartialTools} tools */
export const partialResiduals = (cause, {nameOf, open}) => element("div", {class: "partial"},
  ...[false, true].map(isIn => element("figure", {},
    figure({height: 250, label: "error " + (isIn ? "with " : "without ") + cause.label, open,
      draw: (context, width, height) => draw(context, {width, height}, {...cause, isIn}, nameOf)}),
    element("figcaption", {}, bold((isIn ? "With " : "Without ") + cause.label), ": " + withUnit(short(isIn ? cause.after : cause.before), cause.unit) + " rms"))));

/** What the dots, the line and the bars are. */
export const partialWords = "Each dot is a pose, or one approach to it; its bar is one standard error. Orange: the part of the effect.";

/**
 * @param {CanvasRenderingContext2D} context
 * @param {{width: number, height: number}} size
 * @param {Cause & {isIn: boolean}} shown
 * @param {(pictures: number[]) => string} nameOf
 * @returns {Target[]}
 */
function draw(context, {width, height}, {error, over, unit, overUnit, points, isIn}, nameOf) {
  const xs = points.map(point => point.over), [low, high] = extent(xs), isFew = new Set(xs.map(value => value.toPrecision(6))).size <= fewValues;
  const aside = isFew ? 0.06 * (high - low || 1) : 0;
  const reach = extent([0, ...points.flatMap(({own, left, sigma}) => [own, own + left - sigma, own + left + sigma, left - sigma, left + sigma])]);
  const box = {left: 54, right: width - 10, top: 30, bottom: height - 44};
  const {x, y, line} = axes(context, box, widened([low - aside, high + aside], 0.04), widened(reach, 0.06), {
    title: error ? "error of " + error + " [" + unit + "]" : "displacement along the effect [" + unit + "]",
    xLabel: fitting(context, (over || "displacement by the effect") + (overUnit ? " [" + overUnit + "]" : ""), box.right - box.left)});
  const placed = points.map((point, i) => ({...point, at: x(point.over + aside * placeBeside(i))}));
  drawPart(context, placed, {y, line, isIn, isFew});
  context.fillStyle = context.strokeStyle = colours.blue;
  context.lineWidth = 1;
  return placed.map(({at, over: driver, own, left, sigma, pictures}) => {
    const value = isIn ? left : own + left, target = {x: at, y: y(value)};
    context.globalAlpha = 0.45;
    line(at, y(value - sigma), at, y(value + sigma));
    context.globalAlpha = 0.85;
    dot(context, target);
    context.globalAlpha = 1;
    return {...target, picture: pictures[0], tip: () => nameOf(pictures) + "\n" + withError(value, sigma, unit) + (error ? " at " + withUnit(short(driver), overUnit) : "") +
      (isIn ? "" : ", of it by the effect " + withUnit(short(own), unit))};
  });
}

/**
 * The effect's own part: a line where it follows the driver alone, else a dash at every point; zero once it is in.
 * @param {CanvasRenderingContext2D} context
 * @param {{over: number, own: number, at: number}[]} placed
 * @param {{y: (value: number) => number, line: (x0: number, y0: number, x1: number, y1: number) => void, isIn: boolean, isFew: boolean}} options
 */
function drawPart(context, placed, {y, line, isIn, isFew}) {
  const sorted = [...placed].sort((a, b) => a.over - b.over), owns = sorted.map(({own}) => own), [least, most] = extent(owns);
  const variation = owns.slice(1).reduce((sum, own, i) => sum + Math.abs(own - owns[i]), 0);
  const isLine = isIn || (!isFew && variation <= 4 * (most - least)); // a sine over a turn varies by four times its amplitude
  context.strokeStyle = colours.orange;
  context.lineWidth = 2;
  sorted.forEach(({at, own}, i) => {
    const here = y(isIn ? 0 : own);
    if (!isLine) line(at - 5, here, at + 5, here);
    else if (i) line(sorted[i - 1].at, y(isIn ? 0 : owns[i - 1]), at, here);
  });
}
