// Heat map of the first candidates' correlations; indistinguishable candidates are adjacent.
import {element} from "naocal/lib/dom.js";
import {figure, colours} from "naocal/lib/figure.js";
import {fitting} from "naocal/lib/axes.js";

/** @import {Aliases, Target, View} from "naocal/lib/types.js" */

/** @param {Aliases} aliases */
function aliasMatrix(aliases) {
  const order = classesTogether(aliases), top = 42; // space for the column numbers and the buttons above [px]
  const highOf = (/** @type {number} */ width) => Math.max(15, Math.min(30, (width - nameWidth(width)) / order.length));
  return figure({height: width => top + order.length * highOf(width), label: "correlation of the first candidates",
    draw: (context, width) => draw(context, width, {...aliases, order, top, high: highOf(width)})});
}

/** Display order: each candidate, followed by those that the captures cannot distinguish from it. @param {Aliases} aliases */
function classesTogether({candidates, confusable}) {
  const order = new Set();
  candidates.forEach((label, i) => {
    order.add(i);
    confusable.filter(([taken]) => taken === label).forEach(([, other]) => order.add(candidates.indexOf(other)));
  });
  return [...order];
}

/** @param {number} width */
const nameWidth = width => Math.min(230, 0.5 * width);

/**
 * @param {CanvasRenderingContext2D} context
 * @param {number} width
 * @param {Aliases & {order: number[], top: number, high: number}} matrix
 */
function draw(context, width, {candidates, correlations, confusable, order, top, high}) {
  const left = nameWidth(width), wide = Math.min(60, (width - left - 2) / order.length);
  const outlined = (/** @type {number} */ a, /** @type {number} */ b) => confusable.some(([x, y]) =>
    x === candidates[a] && y === candidates[b] || y === candidates[a] && x === candidates[b]);
  /** @type {Target[]} */
  const targets = [];
  context.textBaseline = "middle";
  order.forEach((a, row) => {
    const y = top + row * high;
    context.fillStyle = colours.soft;
    context.textAlign = "right";
    context.fillText(fitting(context, candidates[a], left - 34), left - 28, y + high / 2);
    context.fillText(String(row + 1), left - 8, y + high / 2);
    context.textAlign = "center";
    context.fillText(String(row + 1), left + (row + 0.5) * wide, top - 10);
    order.slice(0, row + 1).forEach((b, column) => {
      const x = left + column * wide, alike = correlations[a][b];
      context.fillStyle = colours.panel;
      context.fillRect(x, y, wide - 1, high - 1);
      context.fillStyle = a === b ? colours.line : colours.blue;
      context.globalAlpha = a === b ? 1 : 0.9 * alike ** 3;
      context.fillRect(x, y, wide - 1, high - 1);
      context.globalAlpha = 1;
      if (a === b) return;
      if (wide > 34) {
        context.fillStyle = alike > 0.85 ? colours.paper : colours.soft;
        context.fillText(alike.toFixed(2), x + wide / 2, y + high / 2);
      }
      if (outlined(a, b)) {
        context.strokeStyle = colours.orange;
        context.lineWidth = 2;
        context.strokeRect(x + 1, y + 1, wide - 3, high - 3);
      }
      targets.push({x: x + wide / 2, y: y + high / 2, tip: () => candidates[a] + "\nand " + candidates[b] +
        "\ncorrelation " + Number(alike.toFixed(3)) + (outlined(a, b) ? ": cannot be told apart here" : "")});
    });
  });
  return targets;
}

/** @type {View} */
export const view = {
  place: 20, title: "What can be told apart", about: "candidates",
  show: ({aliases}) => aliases && aliases.candidates.length > 1 ? [
    element("p", {}, "Correlation of the first candidates in these captures, after all that the model can follow is taken out: the fuller the " +
      "colour, the harder to tell apart; outlined where the captures cannot tell. ", aliases.sentence),
    aliasMatrix(aliases)] : null,
};
