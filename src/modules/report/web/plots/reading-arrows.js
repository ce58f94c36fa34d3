// Where readings lie in the world, and which way their predictions miss them: from above, from the front and from the side.
import {bold} from "naocal/lib/dom.js";
import {captioned, colours, font} from "naocal/lib/figure.js";
import {arrow, enlargement, enlargedWords, ticks} from "naocal/lib/axes.js";
import {number} from "naocal/lib/format.js";
import {extent} from "naocal/lib/statistics.js";
import {axisNames, groupsOf, lengthOfError, tonesOf} from "naocal/lib/readings.js";
import {legendOf, readingTip} from "naocal/plots/reading-dots.js";

/** @import {ReadingSeries, Target} from "naocal/lib/types.js" */
/** @import {ReadingTools} from "naocal/lib/readings.js" */
/** @import {Box, Context, Range} from "naocal/lib/axes.js" */

/** The planes, by the axes to the right and up. */
const planes = [{name: "from above", axes: [0, 1]}, {name: "from the front", axes: [1, 2]}, {name: "from the side", axes: [0, 2]}];

const millimetre = 1e-3, mostEnlarged = 100000, gap = 46, top = 40, bottom = 30, legend = 26; // [px] but for the first two
const margin = 40; // around the readings, for their arrows [px]

/**
 * Places of the planes' pictures: side by side where there is room, else one below the other, at one scale; and the
 * ranges that they show.
 * @param {number} width
 * @param {Range[]} ranges of x, y and z [m]
 */
function layOut(width, ranges) {
  const spans = ranges.map(([low, high]) => Math.max(1e-3, high - low)), isWide = width > 620;
  const across = planes.map(({axes: [axis]}) => spans[axis]), highest = Math.max(...planes.map(({axes: [, up]}) => spans[up]));
  const room = isWide ? (width - 3 * (gap + 2 * margin + 12)) / across.reduce((a, b) => a + b) : (width - gap - 2 * margin - 12) / Math.max(...across);
  const scale = Math.min(room, (isWide ? 380 : 300) / highest); // pixels per metre
  const shown = /** @type {Range[]} */ (ranges.map(([low, high]) => [low - margin / scale, high + margin / scale]));
  const long = (/** @type {number} */ axis) => scale * (shown[axis][1] - shown[axis][0]);
  let x = 0, y = 0;
  const boxes = planes.map(({axes: [axis, up]}) => {
    const box = {left: x + gap, right: x + gap + long(axis), top: y + top, bottom: y + top + long(up)};
    if (isWide) x = box.right + 12;
    else y = box.bottom + bottom;
    return box;
  });
  return {scale, boxes, shown, height: Math.max(...boxes.map(box => box.bottom)) + bottom + legend};
}

/** @param {Context} context @param {Box} box @param {{name: string, axes: number[]}} plane @param {Range[]} ranges */
function drawPlane(context, box, {name, axes: [across, up]}, ranges) {
  const x = (/** @type {number} */ value) => box.left + (value - ranges[across][0]) / (ranges[across][1] - ranges[across][0]) * (box.right - box.left);
  const y = (/** @type {number} */ value) => box.bottom - (value - ranges[up][0]) / (ranges[up][1] - ranges[up][0]) * (box.bottom - box.top);
  context.strokeStyle = colours.line;
  context.fillStyle = colours.soft;
  context.lineWidth = 1;
  context.strokeRect(box.left, box.top, box.right - box.left, box.bottom - box.top);
  context.textAlign = "center";
  context.textBaseline = "top";
  for (const value of ticks(...ranges[across], (box.right - box.left) / 60)) {
    context.fillRect(x(value), box.bottom, 1, 4);
    context.fillText(number(value), x(value), box.bottom + 6);
  }
  context.textAlign = "right";
  context.textBaseline = "middle";
  for (const value of ticks(...ranges[up], (box.bottom - box.top) / 55)) {
    context.fillRect(box.left - 4, y(value), 4, 1);
    context.fillText(number(value), box.left - 6, y(value));
  }
  context.textAlign = "left";
  context.textBaseline = "top";
  context.fillText(name, box.left, box.top - 34); // two lines fit over the narrowest plane
  context.fillText(axisNames[across] + " →, " + axisNames[up] + " ↑ [m]", box.left, box.top - 18);
  return {x, y};
}

/** The length of a round number of millimetres as errors are drawn. @param {Context} context @param {number} y @param {number} pixelsPerUnit @param {string} unit */
function drawScaleBar(context, y, pixelsPerUnit, unit) {
  const size = [1, 0.1, 0.01, 1e-3].flatMap(power => [500, 200, 100].map(digit => digit * power)).find(size => size * pixelsPerUnit <= 100) ?? 0.1;
  context.fillStyle = colours.orange;
  context.fillRect(gap, y - 1.5, size * pixelsPerUnit, 3);
  context.fillStyle = colours.ink;
  context.textAlign = "left";
  context.textBaseline = "middle";
  context.fillText(number(Number(size.toPrecision(3))) + " " + unit + " of error", gap + size * pixelsPerUnit + 8, y);
}

/** @param {ReadingSeries} series whose errors are lengths @param {ReadingTools} tools */
export function readingArrows(series, tools) {
  const {points, title, unit} = series, {layer, pictureOf, open, isChosen, steady = (_, factor) => factor} = tools, colourOf = tonesOf(points);
  const ranges = axisNames.map((_, axis) => extent(points.map(({at}) => at[axis])));
  const groupOf = new Map([...groupsOf(points)].flatMap(([name, list]) => list.map(reading => [reading, String(name)])));
  return captioned({height: width => layOut(width, ranges).height, label: "errors in space: " + title, open, draw: (context, width, height, caption) => {
    context.font = font;
    const {scale, boxes, shown} = layOut(width, ranges), perMillimetre = scale * millimetre;
    const enlarged = steady(title, enlargement(points.map(reading => perMillimetre * lengthOfError(reading, layer())), 0.9 * margin, mostEnlarged));
    caption.replaceChildren(bold(title), ": arrows lead from measured to predicted, " + enlargedWords(enlarged) + "; the orange bar is their scale", ...legendOf(colourOf));
    /** @type {Target[]} */
    const targets = [];
    planes.forEach((plane, i) => {
      const {x, y} = drawPlane(context, boxes[i], plane, shown), [across, up] = plane.axes;
      context.save();
      context.beginPath();
      context.rect(boxes[i].left, boxes[i].top, boxes[i].right - boxes[i].left, boxes[i].bottom - boxes[i].top);
      context.clip();
      for (const reading of points) {
        const start = {x: x(reading.at[across]), y: y(reading.at[up])}, error = reading[layer()], chosen = isChosen?.(reading);
        context.globalAlpha = isChosen && !chosen ? 0.5 : 0.85;
        const colour = colours[colourOf.get(/** @type {string} */ (groupOf.get(reading))) ?? "blue"];
        context.fillStyle = colour;
        context.fillRect(start.x - 1.5, start.y - 1.5, 3, 3);
        arrow(context, colour, chosen ? 3 : 1.2, start.x, start.y, enlarged * perMillimetre * error[across], -enlarged * perMillimetre * error[up]);
        targets.push({...start, picture: pictureOf?.(reading), tip: () => readingTip(reading, series, tools)});
      }
      context.restore();
      context.globalAlpha = 1;
    });
    drawScaleBar(context, height - legend / 2, enlarged * perMillimetre, unit);
    return targets;
  }});
}
