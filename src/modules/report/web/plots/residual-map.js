// Heat map of mean residuals on the floor after many calibrations, with the field of view of every pose.
import {axes} from "naocal/lib/axes.js";
import {colours, figure} from "naocal/lib/figure.js";
import {number} from "naocal/lib/format.js";

/** @import {Target} from "naocal/lib/types.js" */

/**
 * A square of the floor: indices along x and y, number of residuals, their mean length [px].
 * @typedef {[number, number, number, number]} Square
 */

/**
 * @typedef {object} ResidualMap
 * @property {Square[]} squares
 * @property {number} square width of a square [m]
 * @property {[number, number][][]} fieldsOfView corners on the floor, per pose [m]
 * @property {number} largest mean residual at which the colour is full [px]
 */

/** Colour of a residual: logarithmic from a thousandth of the largest one. @param {number} value @param {number} largest */
const strength = (value, largest) => Math.max(0.04, Math.min(1, 1 + Math.log10(Math.max(value, 1e-12) / largest) / 3));

/** @param {number} value */
const metres = value => number(Number(value.toFixed(2)));

/** @param {ResidualMap} map @param {string} label */
export const residualMap = (map, label) => figure({height: width => Math.min(440, width), label,
  draw: (context, width, height) => drawMap(context, width, height, map)});

/**
 * Seen from above, the robot at the origin, x upwards, y to the left; metres have equal lengths in both directions.
 * @param {CanvasRenderingContext2D} context
 * @param {number} width
 * @param {number} height
 * @param {ResidualMap} map
 * @returns {Target[]}
 */
function drawMap(context, width, height, {squares, square, fieldsOfView, largest}) {
  const points = [...fieldsOfView.flat(), ...squares.map(([i, j]) => [i * square, j * square])];
  const low = Math.min(-0.3, ...points.map(([x]) => x)) - 0.1, high = Math.max(0.5, ...points.map(([x]) => x)) + 0.1;
  const box = {left: 46, right: width - 8, top: 26, bottom: height - 64};
  const aside = (high - low) / 2 * (box.right - box.left) / (box.bottom - box.top);
  const {x: across, y: up} = axes(context, box, [-aside, aside], [low, high], {title: "ahead [m]", xLabel: "to the right [m]"});
  const size = (box.bottom - box.top) / (high - low) * square;
  context.save();
  context.beginPath();
  context.rect(box.left, box.top, box.right - box.left, box.bottom - box.top);
  context.clip();
  context.fillStyle = colours.orange;
  const targets = squares.map(([i, j, count, mean]) => {
    const here = {x: across(-j * square), y: up(i * square)};
    context.globalAlpha = strength(mean, largest);
    context.fillRect(here.x - size / 2, here.y - size / 2, size, size);
    return {...here, tip: () => metres(i * square) + " m ahead, " + metres(j * square) + " m left: " + mean.toPrecision(3) +
      " px, mean of " + count};
  });
  context.globalAlpha = 0.8;
  context.strokeStyle = colours.blue;
  context.lineWidth = 1.2;
  for (const view of fieldsOfView) {
    context.beginPath();
    for (const [x, y] of view) context.lineTo(across(-y), up(x));
    context.closePath();
    context.stroke();
  }
  context.globalAlpha = 1;
  context.fillStyle = colours.ink;
  context.fillRect(across(-0.045), up(0.1), across(0.045) - across(-0.045), up(-0.06) - up(0.1)); // the foot
  context.restore();
  drawScale(context, {left: box.left, width: Math.min(220, (box.right - box.left) / 2), top: height - 16}, largest);
  return targets;
}

/**
 * The colours' scale.
 * @param {CanvasRenderingContext2D} context
 * @param {{left: number, width: number, top: number}} place
 * @param {number} largest
 */
function drawScale(context, {left, width, top}, largest) {
  const steps = 40;
  context.fillStyle = colours.orange;
  for (let i = 0; i < steps; ++i) {
    context.globalAlpha = strength(largest * 10 ** (3 * (i / (steps - 1) - 1)), largest);
    context.fillRect(left + i * width / steps, top, width / steps + 0.5, 8);
  }
  context.globalAlpha = 1;
  context.fillStyle = colours.soft;
  context.textAlign = "left";
  context.textBaseline = "middle";
  context.fillText(Number((largest / 1000).toPrecision(2)) + " to " + Number(largest.toPrecision(2)) + " px, logarithmic", left + width + 8, top + 4);
}
