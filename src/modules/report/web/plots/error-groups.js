// Errors by pose, board, marker or place: a dot per member, a dash at the group's rms.
import {axes, dot} from "naocal/lib/axes.js";
import {colours, figure} from "naocal/lib/figure.js";
import {groupBy, quantile, rms} from "naocal/lib/statistics.js";

/** @import {Box, Context} from "naocal/lib/axes.js" */

/** `lengths`: of its error vectors; `picture`: what a click opens. @typedef {{group: string, lengths: () => number[], picture?: any, name: string}} Member */
/** @typedef {ReturnType<typeof axes>} Scale */

/**
 * Groups are ordered by their first member.
 * @param {Member[]} members
 * @param {{title: string, xLabel: string, label: string, noise: number, noiseName: string, words: (error: number) => string, open?: (picture: any) => void}} options
 *   `noise`: rms error of noise alone
 */
export function errorGroups(members, {title, xLabel, label, noise, noiseName, words, open}) {
  const groups = groupBy(members, ({group}) => group);
  return figure({height: 280, label, open, draw: (context, width, height) => {
    const values = members.map(member => rms(member.lengths()));
    const highest = Math.max(1e-3, Math.min(1.08 * quantile(values, 1), 4 * quantile(values, 0.9)));
    const box = {left: 45, right: width - 5, top: 30, bottom: height - 40};
    const scale = axes(context, box, [-0.5, groups.size - 0.5], [0, highest], {title});
    if (noise <= highest) drawNoise(context, box, scale.y(noise), noiseName);
    drawNames(context, [...groups.keys()].map(String), box, scale.x, xLabel);
    return [...groups.entries()].flatMap(([name, list], place) => drawGroup(context, scale, {name: String(name), list, place, highest, words}));
  }});
}

/** @param {Context} context @param {Scale} scale @param {{name: string, list: Member[], place: number, highest: number, words: (error: number) => string}} group */
function drawGroup(context, {x, y, line}, {name, list, place, highest, words}) {
  const half = Math.min(60, 0.35 * (x(1) - x(0))), level = rms(list.flatMap(member => member.lengths()));
  const targets = list.map((member, i) => {
    const value = rms(member.lengths()), across = list.length > 1 ? 1.2 * half * (i / (list.length - 1) - 0.5) : 0;
    return {x: x(place) + across, y: y(Math.min(highest, value)), beyond: value > highest ? -1 : 0, picture: member.picture,
      tip: () => member.name + "\n" + words(value) + " rms; all of " + name + ": " + words(level)};
  });
  context.fillStyle = colours.blue;
  context.globalAlpha = 0.65;
  targets.forEach(target => dot(context, target));
  context.globalAlpha = 1;
  context.strokeStyle = colours.orange;
  context.lineWidth = 3;
  const height = y(Math.min(highest, level)), reach = Math.max(half, 2);
  if (list.length > 1) line(x(place) - reach, height, x(place) + reach, height);
  return targets;
}

/** Reference line: rms error expected from noise alone. @param {Context} context @param {Box} box @param {number} level [px of the drawing] @param {string} name */
function drawNoise(context, box, level, name) {
  context.strokeStyle = context.fillStyle = colours.soft;
  context.lineWidth = 1;
  context.setLineDash([6, 4]);
  context.beginPath();
  context.moveTo(box.left, level);
  context.lineTo(box.right, level);
  const nameStart = box.right - context.measureText(name).width - 8;
  context.moveTo(nameStart - 28, box.top - 13);
  context.lineTo(nameStart, box.top - 13);
  context.stroke();
  context.setLineDash([]);
  context.textAlign = "right";
  context.textBaseline = "middle";
  context.fillText(name, box.right, box.top - 13);
}

/** Group names if they fit, and the axis label. @param {Context} context @param {string[]} names @param {Box} box @param {(value: number) => number} x @param {string} xLabel */
function drawNames(context, names, box, x, xLabel) {
  context.fillStyle = colours.soft;
  context.textAlign = "center";
  context.textBaseline = "top";
  const room = x(1) - x(0), widest = Math.max(...names.map(name => context.measureText(name).width));
  if (widest + 6 < room) names.forEach((name, place) => context.fillText(name, x(place), box.bottom + 6));
  context.fillText(xLabel, (box.left + box.right) / 2, box.bottom + 22);
}
