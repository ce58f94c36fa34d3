// Estimates with error bars, one axis per effect and unit.
import {element} from "naocal/lib/dom.js";
import {colours} from "naocal/lib/figure.js";
import {ticks} from "naocal/lib/axes.js";
import {capitalized, number, percent, withError} from "naocal/lib/format.js";
import {extent} from "naocal/lib/statistics.js";

/** @import {EstimateGroup} from "naocal/lib/types.js" */

/** The group's axis: position of a value, 0 to 1, and tick values. @param {EstimateGroup} group */
function axisOf({rows}) {
  const [low, high] = extent(rows.flatMap(row => [row.low, row.high, 0])), margin = 0.04 * (high - low || 1);
  return {share: (/** @type {number} */ value) => (value - low + margin) / (high - low + 2 * margin), marks: ticks(low - margin, high + margin, 6)};
}

/** Title of a group: "Joint offset [°]". @param {EstimateGroup} group */
export const titleOf = ({title, unit}) => capitalized(title) + (unit ? " [" + unit + "]" : "");

/** One row per estimate, then the axis. @param {EstimateGroup} group */
export function estimates(group) {
  const {share, marks} = axisOf(group), place = (/** @type {number} */ value) => 100 * share(value) + "%";
  const scale = element("div", {class: "ticks"}, ...marks.map(mark => placed(element("span", {}, number(mark)), place(mark))));
  return element("div", {class: "estimates"}, ...group.rows.map(({name, value, sigma, low, high, learned}) => {
    const bar = placed(element("span", {class: "bar"}), place(low)), known = Math.max(0, learned);
    bar.style.right = "calc(100% - " + place(high) + ")";
    const told = element("span", {class: "learned number" + (learned < 0.5 ? " little" : ""), title: "learned from these captures"}, element("span", {}, percent(known)));
    told.style.setProperty("--share", percent(known).replace(" ", ""));
    return element("div", {class: "estimate"}, element("span", {}, name),
      element("div", {class: "axis"}, ...marks.map(mark => placed(element("i", {class: mark === 0 ? "zero" : ""}), place(mark))), bar,
        placed(element("span", {class: "dot"}), place(value))),
      element("span", {class: "number"}, withError(value, sigma, group.unit)), told);
  }), element("div", {class: "estimate"}, element("span"), scale));
}

/** @template {HTMLElement} E @param {E} part @param {string} left */
function placed(part, left) {
  part.style.left = left;
  return part;
}

const rowHeight = 24, wide = 900, left = 190, right = wide - 250; // dimensions of the saved drawing and its axis [px]

/** Size of a group's drawing [px]. @param {EstimateGroup} group */
export const drawingSize = ({rows}) => ({width: wide, height: 68 + rowHeight * rows.length});

/** The same on a canvas, for saving. @param {CanvasRenderingContext2D} context @param {number} width @param {number} height @param {EstimateGroup} group */
export function drawEstimates(context, width, height, group) {
  const {share, marks} = axisOf(group), place = (/** @type {number} */ value) => left + share(value) * (right - left);
  context.fillStyle = colours.paper;
  context.fillRect(0, 0, width, height);
  context.textBaseline = "middle";
  context.textAlign = "center";
  for (const mark of marks) {
    context.fillStyle = mark === 0 ? colours.soft : colours.line;
    context.fillRect(place(mark), 30, 1, height - 56);
    context.fillStyle = colours.soft;
    context.fillText(number(mark), place(mark), height - 14);
  }
  context.textAlign = "left";
  context.fillStyle = colours.ink;
  context.fillText(titleOf(group), 8, 14);
  context.fillText("± one standard error", right + 20, 14);
  context.fillText("learned", wide - 60, 14);
  group.rows.forEach((row, i) => {
    const y = 42 + rowHeight * i;
    context.fillStyle = colours.blue;
    context.globalAlpha = 0.5;
    context.fillRect(place(row.low), y - 3, Math.max(2, place(row.high) - place(row.low)), 6);
    context.globalAlpha = 1;
    context.beginPath();
    context.arc(place(row.value), y, 4, 0, 7);
    context.fill();
    context.fillStyle = colours.ink;
    context.fillText(row.name, 8, y);
    context.fillText(withError(row.value, row.sigma, group.unit), right + 20, y);
    context.fillText(percent(Math.max(0, row.learned)), wide - 60, y);
  });
}
