// One joint's offset over time: error bars, falls, jumps.
import {axes, widened} from "naocal/lib/axes.js";
import {colours, figure} from "naocal/lib/figure.js";
import {withError} from "naocal/lib/format.js";
import {extent} from "naocal/lib/statistics.js";

/** @import {JointOffsets, RobotRuns} from "../core/messages.js" */

const day = 86400000, degrees = 180 / Math.PI;
const steps = [1 / 24, 1 / 4, 1, 2, 7, 14, 30, 91, 182, 365, 730, 1825].map(days => days * day); // between ticks [ms]

/** Changes that are jumps. @param {JointOffsets} joint */
export const jumps = ({offsets}) => offsets.filter(({change}) => change && change.jump);

/** @param {string} time */
const milliseconds = time => Date.parse(time);

/** Label of a tick: the day, or the time of day where ticks are closer. @param {number} time @param {number} step */
function tickLabel(time, step) {
  const text = new Date(time).toISOString();
  return step < day ? text.slice(5, 16).replace("T", " ") : text.slice(0, 10);
}

/** @param {CanvasRenderingContext2D} context @param {{left: number, right: number, top: number, bottom: number}} box @param {[number, number]} range @param {(time: number) => number} x */
function drawDates(context, box, [low, high], x) {
  const room = Math.max(1, Math.floor((box.right - box.left) / 95)), step = steps.find(one => (high - low) / one <= room) ?? steps[steps.length - 1];
  context.fillStyle = colours.soft;
  context.strokeStyle = colours.line;
  context.textAlign = "center";
  context.textBaseline = "top";
  for (let time = Math.ceil(low / step) * step; time <= high; time += step) {
    context.beginPath();
    context.moveTo(x(time), box.bottom);
    context.lineTo(x(time), box.bottom + 4);
    context.stroke();
    const label = tickLabel(time, step), half = context.measureText(label).width / 2;
    context.fillText(label, Math.min(Math.max(x(time), box.left + half - 30), box.right + 8 - half), box.bottom + 6);
  }
}

/**
 * @param {JointOffsets} joint
 * @param {RobotRuns} robot
 * @param {(id: string) => void} open
 */
export function offsetPlot({joint, offsets}, {runs, falls}, open) {
  const points = offsets.map(one => ({...one, at: milliseconds(one.time), value: degrees * one.offset, error: degrees * one.sigma, told: runs.find(({id}) => id === one.run)}));
  const times = [...points.map(({at}) => at), ...falls.map(milliseconds)];
  return figure({height: 210, label: "offset of " + joint + " over time", draw: (context, width, height) => {
    const box = {left: 54, right: width - 14, top: 30, bottom: height - 28};
    const [first, last] = extent(times), shown = widened(/** @type {[number, number]} */ (last - first < day ? [first - day / 2, last + day / 2] : [first, last]), 0.05);
    const {x, y} = axes(context, box, shown, widened(/** @type {[number, number]} */ (extent(points.flatMap(({value, error}) => [value - 2 * error, value + 2 * error]))), 0.1), {title: joint + " [°]"});
    drawDates(context, box, shown, x);
    const line = (fromX, fromY, toX, toY) => { context.beginPath(); context.moveTo(fromX, fromY); context.lineTo(toX, toY); context.stroke(); };
    context.strokeStyle = colours.pink;
    context.lineWidth = 1.5;
    context.setLineDash([4, 4]);
    for (const fall of falls) line(x(milliseconds(fall)), box.top, x(milliseconds(fall)), box.bottom);
    context.setLineDash([]);
    for (const point of points) {
      const before = point.change && points.find(({run}) => run === point.change?.since);
      if (!before) continue;
      context.strokeStyle = point.change?.jump ? colours.orange : colours.soft;
      context.lineWidth = point.change?.jump ? 3 : 1;
      line(x(before.at), y(before.value), x(point.at), y(point.value));
    }
    return points.map(point => {
      const place = {x: x(point.at), y: y(point.value)};
      context.strokeStyle = context.fillStyle = point.compared ? colours.blue : colours.soft;
      context.lineWidth = 1.5;
      line(place.x, y(point.value - 2 * point.error), place.x, y(point.value + 2 * point.error));
      context.beginPath();
      context.arc(place.x, place.y, 4, 0, 7);
      if (!point.compared) context.fillStyle = colours.paper;
      context.fill();
      context.stroke();
      return {...place, click: () => open(point.run), tip: () => joint + " " + withError(point.value, point.error, "°") + "\n" + point.time.slice(0, 16).replace("T", " ") + " UTC, " + (point.told?.kind ?? "") + ", " + (point.told?.words ?? "") +
        (point.change ? "\nchange " + point.change.words + (point.change.jump ? ": a jump" : "") + (point.change.afterFall ? ", after a fall" : "") : "")};
    });
  }});
}
