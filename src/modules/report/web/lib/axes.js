// Drawing helpers: tick values, axes, arrows, points.
import {colours} from "naocal/lib/figure.js";
import {number} from "naocal/lib/format.js";
import {quantile} from "naocal/lib/statistics.js";

/** @typedef {CanvasRenderingContext2D} Context */
/** @typedef {{left: number, right: number, top: number, bottom: number}} Box */
/** @typedef {[number, number]} Range */

/** Round tick values from low to high, about `count` of them. @param {number} low @param {number} high @param {number} count */
export function ticks(low, high, count) {
  const rough = (high - low) / Math.max(1, count), power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5, 10].find(factor => factor * power >= 0.7 * rough) ?? 10);
  const result = [];
  for (let i = Math.ceil(low / step); i * step <= high + 1e-9 * step; ++i) result.push(Number((i * step).toPrecision(12)));
  return result;
}

/**
 * Draws grid lines and tick labels around `box`; returns the scales (value to pixel) and the line function. Without xLabel, no ticks on x.
 * @param {Context} context
 * @param {Box} box
 * @param {Range} xRange
 * @param {Range} yRange
 * @param {{title: string, xLabel?: string}} words
 */
export function axes(context, box, [xLow, xHigh], [yLow, yHigh], {title, xLabel}) {
  const x = (/** @type {number} */ value) => box.left + (value - xLow) / (xHigh - xLow) * (box.right - box.left);
  const y = (/** @type {number} */ value) => box.bottom - (value - yLow) / (yHigh - yLow) * (box.bottom - box.top);
  const line = (/** @type {number} */ x0, /** @type {number} */ y0, /** @type {number} */ x1, /** @type {number} */ y1) => {
    context.beginPath();
    context.moveTo(x0, y0);
    context.lineTo(x1, y1);
    context.stroke();
  };
  context.fillStyle = colours.soft;
  context.lineWidth = 1;
  context.textAlign = "right";
  context.textBaseline = "middle";
  for (const value of ticks(yLow, yHigh, (box.bottom - box.top) / 45)) {
    context.strokeStyle = value === 0 ? colours.soft : colours.line;
    line(box.left, y(value), box.right, y(value));
    context.fillText(number(value), box.left - 6, y(value));
  }
  context.strokeStyle = colours.line;
  context.textAlign = "center";
  context.textBaseline = "top";
  if (xLabel) {
    for (const value of ticks(xLow, xHigh, (box.right - box.left) / 70)) {
      line(x(value), box.bottom, x(value), box.bottom + 4);
      const text = number(value), within = box.right + 8 - context.measureText(text).width / 2; // keeps the label inside the figure
      context.fillText(text, Math.min(x(value), within), box.bottom + 6);
    }
    context.fillText(xLabel, (box.left + box.right) / 2, box.bottom + 22);
  }
  context.textAlign = "left";
  context.fillText(title, box.left - 40, box.top - 20);
  return {x, y, line};
}

const factors = [1, 10, 100, 1000, 10000].flatMap(power => [2, 5, 10].map(digit => digit * power)).reverse();
/** Enlargement factor, at most `most`, that keeps 90 % of the errors shorter than `longest`. @param {number[]} lengths @param {number} longest */
export const enlargement = (lengths, longest, most = 200) =>
  factors.find(factor => factor <= most && factor * quantile(lengths, 0.9) <= longest) || 1;
/** @param {number} factor */
export const enlargedWords = factor => factor === 1 ? "not enlarged" : "enlarged " + factor + " times";

/**
 * @param {Context} context
 * @param {string} colour
 * @param {number} thick
 * @param {number} x
 * @param {number} y
 * @param {number} dx
 * @param {number} dy
 */
export function arrow(context, colour, thick, x, y, dx, dy) {
  const length = Math.hypot(dx, dy), head = Math.min(5 + thick, 0.5 * length), angle = Math.atan2(dy, dx);
  context.strokeStyle = colour;
  context.lineWidth = thick;
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(x + dx, y + dy);
  for (const side of [-2.6, 2.6]) {
    context.moveTo(x + dx, y + dy);
    context.lineTo(x + dx + head * Math.cos(angle + side), y + dy + head * Math.sin(angle + side));
  }
  context.stroke();
}

/** A point; a triangle pointing outwards if the value lies beyond the axis (`beyond` -1: up, 1: down). @param {Context} context @param {{x: number, y: number, beyond?: number}} point */
export function dot(context, {x, y, beyond}) {
  context.beginPath();
  if (beyond) {
    context.moveTo(x - 4, y - 2 * beyond);
    context.lineTo(x + 4, y - 2 * beyond);
    context.lineTo(x, y + 5 * beyond);
  } else {
    context.arc(x, y, 2.5, 0, 7);
  }
  context.fill();
}

/** Place of a point among those of equal value, in [-1, 1): spreads any number of them evenly. @param {number} i */
export const placeBeside = i => (i * 0.618034 % 1 - 0.5) * 2;

/** Truncates a text to `room` pixels, with an ellipsis. @param {Context} context @param {string} text @param {number} room */
export function fitting(context, text, room) {
  if (context.measureText(text).width <= room) return text;
  let end = text.length;
  while (end > 1 && context.measureText(text.slice(0, end) + "…").width > room) --end;
  return text.slice(0, end) + "…";
}

/** Extends a range by `share` of its width at both ends. @param {Range} range @param {number} share @returns {Range} */
export function widened([low, high], share) {
  const margin = share * (high - low || 1);
  return [low - margin, high + margin];
}
