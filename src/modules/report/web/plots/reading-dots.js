// Errors of readings along x, y and z over the order of the captures, with the band of their noise.
import {bold, key} from "naocal/lib/dom.js";
import {captioned, colours} from "naocal/lib/figure.js";
import {axes, dot, widened} from "naocal/lib/axes.js";
import {short, withUnit} from "naocal/lib/format.js";
import {extent, quantile} from "naocal/lib/statistics.js";
import {axisNames, groupsOf, rmsOf, targetName, tonesOf} from "naocal/lib/readings.js";

/** @import {Reading, ReadingSeries} from "naocal/lib/types.js" */
/** @import {ReadingTools} from "naocal/lib/readings.js" */

const rowHeight = 165;

/** "x 0.12, y −0.30, z 0.05 mm" @param {Reading} reading @param {ReadingSeries} series @param {ReadingTools} tools */
export const errorWords = (reading, {unit}, {layer}) =>
  axisNames.map((name, axis) => name + " " + short(reading[layer()][axis])).join(", ") + (unit.startsWith("°") ? unit : " " + unit);

/** @param {ReadingSeries} series @param {string} name of the axis */
export const componentTitle = ({isPlace, unit}, name) => "predicted − measured " + (isPlace ? "along " : "about ") + name + " [" + unit + "]";

/** Groups and their colours, for a caption. @param {Map<string, string>} colourOf @returns {(string | Node)[]} */
export const legendOf = colourOf => new Set(colourOf.values()).size < 2 ? [] : [...colourOf].flatMap(([name, colour]) => {
  const mark = key("dot");
  mark.style.background = "var(--" + colour + ")";
  return ["  ", mark, " " + name];
});

/** @param {Reading} reading @param {ReadingSeries} series @param {ReadingTools} tools */
export const readingTip = (reading, series, tools) => targetName(reading) + ", " + tools.nameOf(reading) + "\npredicted off by " +
  errorWords(reading, series, tools) + "\nin all " + withUnit(short(Math.hypot(...reading[tools.layer()])), series.unit);

/** @param {ReadingSeries} series @param {ReadingTools} tools */
export function readingDots(series, tools) {
  const {points, unit, sigma, given, title} = series, {layer, orderOf, pictureOf, open, isChosen} = tools, colourOf = tonesOf(points);
  const groups = groupsOf(points), groupOf = new Map([...groups].flatMap(([name, list]) => list.map(reading => [reading, String(name)])));
  return captioned({height: 3 * rowHeight + 40, label: "errors of " + title, open, draw: (context, width, height, caption) => {
    const across = widened(extent(points.map(orderOf)), 0.02), values = points.flatMap(reading => reading[layer()]);
    const reach = 1.1 * Math.max(2.5 * sigma, quantile(values.map(Math.abs), 0.99));
    caption.replaceChildren(bold(title), ": " + points.length + " readings, " + withUnit(short(rmsOf(points, layer())), unit) + " rms; band: two standard deviations of their noise (" +
      withUnit(short(sigma), unit) + " per axis, " + (given ? "as the set says" : "estimated") + ")",
    ...legendOf(colourOf));
    return axisNames.flatMap((name, axis) => {
      const box = {left: 58, right: width - 10, top: 24 + axis * rowHeight, bottom: (axis + 1) * rowHeight - 4}, last = axis === 2;
      const {x, y} = axes(context, box, across, [-reach, reach], {title: componentTitle(series, name), xLabel: last ? "captures in the order they were taken" : undefined});
      context.fillStyle = colours.soft;
      context.globalAlpha = 0.12;
      context.fillRect(box.left, y(2 * sigma), box.right - box.left, y(-2 * sigma) - y(2 * sigma));
      return points.map(reading => {
        const value = reading[layer()][axis], chosen = isChosen?.(reading);
        const target = {x: x(orderOf(reading)), y: y(Math.max(-reach, Math.min(reach, value))), beyond: Math.abs(value) > reach ? -Math.sign(value) : 0,
          picture: pictureOf?.(reading), tip: () => readingTip(reading, series, tools)};
        context.globalAlpha = 0.7;
        context.fillStyle = colours[colourOf.get(/** @type {string} */ (groupOf.get(reading))) ?? "blue"];
        dot(context, target);
        context.globalAlpha = 1;
        if (chosen) {
          context.strokeStyle = colours.ink;
          context.lineWidth = 1.5;
          context.beginPath();
          context.arc(target.x, target.y, 5, 0, 7);
          context.stroke();
        }
        return target;
      });
    });
  }});
}
