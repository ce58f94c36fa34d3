// Heat map of joints by drivers: evidence for a curve of each joint's error over each driver.
import {bold, element} from "naocal/lib/dom.js";
import {figure, font, colours} from "naocal/lib/figure.js";
import {fitting} from "naocal/lib/axes.js";
import {chance, driverWords, tenths} from "naocal/lib/format.js";

/** @import {MapCell, View} from "naocal/lib/types.js" */

/** @param {MapCell[]} cells */
const bestOf = cells => cells.reduce((a, b) => a.evidence > b.evidence ? a : b);
/** @param {MapCell[]} cells */
const jointsOf = cells => [...new Set(cells.map(({joint}) => joint))];
const letter = 6.3, leastTop = 132, mostTop = 200, leastLeft = 104; // of the headings, and the width of a letter [px]
const shortNames = new Map([["t", "time"], ["T", "temperature"], ["qd", "speed"]]);
/** @param {string} name */
const shortName = name => shortNames.get(name) ?? name.replace("tau_", "torque ");

/** Heat map; the colour's strength is the evidence for a curve. @param {MapCell[]} cells */
function driverMap(cells) {
  const joints = jointsOf(cells), best = bestOf(cells), most = Math.max(6, best.evidence); // evidence below 6 never gets the full colour
  const rank = (/** @type {string} */ name) => joints.includes(name) ? 0 : name.startsWith("tau_") ? 1 : 2;
  const drivers = [...new Set(cells.map(({driver}) => driver))].sort((a, b) => rank(a) - rank(b));
  const longest = (/** @type {string[]} */ names) => letter * Math.max(...names.map(({length}) => length));
  const top = Math.max(leastTop, Math.min(mostTop, longest(drivers.map(shortName)))); // height of the columns' headings
  return figure({
    height: width => top + 2 + joints.length * Math.max(14, Math.min(26, width / 36)), label: "evidence by joint and driver",
    draw: (context, width, height) => {
      context.font = font;
      const left = Math.max(leastLeft, Math.min(0.25 * width, longest(joints) + 8)), wide = (width - left - 2) / drivers.length, high = (height - top - 2) / joints.length, gap = wide > 6 ? 1 : 0;
      drawNames(context, joints, drivers.map(shortName), {left, top, wide, high});
      drawScale(context, most);
      return cells.map(cell => {
        const x = left + drivers.indexOf(cell.driver) * wide, y = top + joints.indexOf(cell.joint) * high;
        context.fillStyle = colours.panel;
        context.fillRect(x, y, wide - gap, high - 1);
        context.fillStyle = colours.blue;
        context.globalAlpha = Math.sqrt(Math.max(0, cell.evidence) / most);
        context.fillRect(x, y, wide - gap, high - 1);
        context.globalAlpha = 1;
        if (cell === best && cell.evidence > 0) {
          context.strokeStyle = colours.orange;
          context.lineWidth = 2;
          context.strokeRect(x, y, wide - gap, high - 1);
        }
        return {x: x + wide / 2, y: y + high / 2, tip: () => cell.joint + " over " + driverWords(cell.driver) + "\nevidence " +
          tenths(cell.evidence) + ", alone " + chance(cell.pValue)};
      });
    },
  });
}

/** @param {CanvasRenderingContext2D} context @param {string[]} joints @param {string[]} drivers @param {{left: number, top: number, wide: number, high: number}} sizes */
function drawNames(context, joints, drivers, {left, top, wide, high}) {
  context.textBaseline = "middle";
  context.textAlign = "right";
  context.fillStyle = colours.soft;
  joints.forEach((joint, row) => context.fillText(fitting(context, joint, left - 8), left - 6, top + (row + 0.5) * high));
  const every = Math.ceil(13 / wide);
  context.textAlign = "left";
  drivers.forEach((driver, column) => {
    if (column % every) return;
    context.save();
    context.translate(left + (column + 0.5) * wide, top - 5);
    context.rotate(-Math.PI / 2);
    context.fillText(fitting(context, driver, top - 8), 0, 0);
    context.restore();
  });
}

/** Colour scale, in the corner above the joints' names. @param {CanvasRenderingContext2D} context @param {number} most */
function drawScale(context, most) {
  context.fillStyle = colours.soft;
  context.textBaseline = "alphabetic";
  context.fillText("evidence", 0, 14);
  [0, 0.25, 0.5, 0.75, 1].forEach((share, i) => {
    context.fillStyle = colours.panel;
    context.fillRect(16 * i, 20, 15, 14);
    context.fillStyle = colours.blue;
    context.globalAlpha = Math.sqrt(share);
    context.fillRect(16 * i, 20, 15, 14);
    context.globalAlpha = 1;
  });
  context.fillStyle = colours.soft;
  context.fillText("≤ 0", 0, 49);
  context.textAlign = "right";
  context.fillText(tenths(most), 80, 49);
  context.textAlign = "left";
}

/** @type {View} */
export const view = {
  place: 40, title: "What each joint's error depends on", about: "misfit",
  show: ({map}) => {
    if (!map.length) return null;
    const best = bestOf(map);
    return [element("p", {}, "How well a smooth curve of each joint (rows) over each possible driver (columns) would explain the remaining misfit: the " +
      "fuller the colour, the better; empty where it explains nothing. This looks beyond the known effects. ", bold(best.evidence > 0
      ? "Best: " + best.joint + " over " + driverWords(best.driver) + " (evidence " + tenths(best.evidence) + ")." : "Here it is empty: nothing is left.")),
    driverMap(map)];
  },
};
