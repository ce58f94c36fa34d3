// Errors over a value of their captures: joint readings or time.
import {element} from "naocal/lib/dom.js";
import {binnedMeans, extent, quantile, trendStrength} from "naocal/lib/statistics.js";
import {residualScatter} from "naocal/plots/residual-scatter.js";

/** @import {ReadCapture} from "naocal/lib/types.js" */

/**
 * An error with its components; `trusted`: without doubtful corners, null if nothing is left.
 * @typedef {{x: number, capture: any, error: number[], trusted: number[] | null, tip: () => string}} TrendPoint
 */

/**
 * A kind of error, and its points over a value of the capture; captures without it are left out.
 * @typedef {object} ErrorKind
 * @property {string} title
 * @property {{name: string, title: string}[]} components
 * @property {ReadCapture[]} captures
 * @property {(valueOf: (capture: any) => number | undefined) => TrendPoint[]} points
 * @property {(capture: any) => void} [open]
 */

/** Binned means of one component. @param {TrendPoint[]} points @param {number} component @param {(capture: any) => string} groupOf */
const meansOf = (points, component, groupOf) => binnedMeans(points.flatMap(({x, capture, trusted}) => trusted ? [{x, y: trusted[component], capture}] : []),
  {groupOf: ({capture}) => groupOf(capture)});

/** One plot per component, side by side. @param {ErrorKind} kind @param {TrendPoint[]} points @param {{label: string, xLabel: string, groupOf: (capture: any) => string}} options */
export function trend({components, open}, points, {label, xLabel, groupOf}) {
  const sides = components.map((one, i) => ({...one, i, means: meansOf(points, i, groupOf)}));
  const least = Math.max(quantile(points.flatMap(({error}) => error.map(Math.abs)), 0.98), // common y axis
    ...sides.flatMap(({means}) => means.map(({y, error}) => Math.abs(y) + 2 * error)));
  return element("div", {class: components.length === 3 ? "grid three" : "grid"}, ...sides.map(({name, title, i, means}) => residualScatter({
    points: points.map(({x, error, capture, tip}) => ({x, y: error[i], picture: open && capture, tip: () => tip() + "\n" + xLabel + ": " + Number(x.toFixed(2))})),
    means, least, xLabel, title,
  }, {label: label + ", " + name, open})));
}

/** Joints that moved by more than 1° or 1 mm, strongest trend first. @param {ErrorKind} kind @param {(capture: any) => string} groupOf */
export function movedJoints({captures, points, components}, groupOf) {
  const names = new Set(captures.flatMap(({angles}) => Object.keys(angles ?? {})));
  return [...names].map(name => ({name, over: points(({angles}) => angles?.[name])})).filter(({over}) => {
    const [low, high] = extent(over.map(({x}) => x));
    return high - low > 1;
  }).map(({name, over}) => ({name, strength: Math.max(...components.map((_, i) => trendStrength(meansOf(over, i, groupOf))))}))
    .sort((a, b) => b.strength - a.strength);
}
