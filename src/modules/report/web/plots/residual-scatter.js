// Scatter plot with binned means: corner errors, or joint errors that would explain them.
import {axes, dot, placeBeside, widened} from "naocal/lib/axes.js";
import {colours, figure} from "naocal/lib/figure.js";
import {extent, quantile} from "naocal/lib/statistics.js";

/** @import {Target} from "naocal/lib/types.js" */

/**
 * @typedef {{x: number, y: number, sigma?: number, picture?: any, tip: () => string}} ScatterPoint
 */

/**
 * @typedef {object} Scatter
 * @property {ScatterPoint[]} points
 * @property {{x: number, y: number, error: number}[]} means
 * @property {string} title
 * @property {string} xLabel
 * @property {number} [least] minimum reach of the y axis
 * @property {boolean} [fromZero] values are never negative
 * @property {(picture: any) => boolean} [isChosen] points to circle
 */

const many = 2000; // points; beyond it, small squares are drawn, which is faster
const fewValues = 6; // distinct x values; up to this, points of equal x are jittered

/**
 * @param {Scatter} scatter
 * @param {{label: string, open?: (picture: any) => void, className?: string, height?: number}} options
 */
export const residualScatter = (scatter, {label, open, className, height = 340}) =>
  figure({height, label, className, open, draw: (context, width, tall) => drawScatter(context, width, tall, scatter)});

/**
 * @param {CanvasRenderingContext2D} context
 * @param {number} width
 * @param {number} height
 * @param {Scatter} scatter
 * @returns {Target[]}
 */
export function drawScatter(context, width, height, {points, means, title, xLabel, least = 1e-3, fromZero, isChosen}) {
  if (!points.length) return [];
  const xs = points.map(({x}) => x), [low, high] = extent(xs), isDense = points.length > many;
  const aside = new Set(xs).size <= fewValues ? 0.05 * (high - low) : 0;
  const reach = 1.15 * Math.max(least, quantile(points.map(({y}) => Math.abs(y)), isDense ? 0.995 : 0.98),
    ...means.map(({y, error}) => Math.abs(y) + 2 * error));
  const box = {left: 54, right: width - 10, top: 30, bottom: height - 44};
  const {x, y, line} = axes(context, box, widened([low - aside, high + aside], 0.025), [fromZero ? 0 : -reach, reach], {title, xLabel});
  const inside = (/** @type {number} */ value) => Math.max(fromZero ? 0 : -reach, Math.min(reach, value));

  context.fillStyle = context.strokeStyle = colours.blue;
  context.lineWidth = 1;
  const size = points.length > 20000 ? 2 : 3.2;
  const targets = points.map(({x: across, y: value, sigma, picture, tip}, i) => {
    const target = {x: x(across + aside * placeBeside(i)), y: y(inside(value)), picture, tip,
      beyond: Math.abs(value) > reach ? -Math.sign(value) : 0};
    if (sigma !== undefined) {
      context.globalAlpha = 0.3;
      line(target.x, y(inside(value - sigma)), target.x, y(inside(value + sigma)));
    }
    context.globalAlpha = sigma !== undefined ? 0.8 : Math.max(0.12, Math.min(0.65, 900 / points.length));
    if (isDense) context.fillRect(target.x - size / 2, target.y - size / 2, size, size);
    else dot(context, target);
    return target;
  });
  context.globalAlpha = 1;
  if (isChosen) {
    context.strokeStyle = colours.pink;
    context.lineWidth = 1.5;
    for (const target of targets.filter(({picture}) => isChosen(picture))) {
      context.beginPath();
      context.arc(target.x, target.y, 4.5, 0, 7);
      context.stroke();
    }
  }
  context.strokeStyle = context.fillStyle = colours.orange;
  context.lineWidth = 2;
  means.forEach((here, i) => {
    line(x(here.x), y(inside(here.y - 2 * here.error)), x(here.x), y(inside(here.y + 2 * here.error)));
    if (i) line(x(means[i - 1].x), y(inside(means[i - 1].y)), x(here.x), y(inside(here.y)));
    context.fillRect(x(here.x) - 3.5, y(inside(here.y)) - 3.5, 7, 7);
  });
  return targets;
}
