// Entry point of the evaluation page: success rate over tolerance, and histograms of each joint's error before and after calibration.
import {at, bold, choosing, element} from "naocal/lib/dom.js";
import {colours, figure} from "naocal/lib/figure.js";
import {axes} from "naocal/lib/axes.js";
import {tenths} from "naocal/lib/format.js";
import {readData, showContents, showHead} from "naocal/pages/head.js";
import {residualMap} from "naocal/plots/residual-map.js";

const data = readData();

/** @type {Record<string, string>} */
const solverColour = {ours: "blue", lm: "orange", "lm-random-starts": "pink", "lm-program": "good", "lm-program-starts": "good"};
/** @type {Record<string, string>} */
const solverWords = {ours: "ours", lm: "plain Levenberg-Marquardt", "lm-random-starts": "from random starts",
  "lm-program": "the thesis's program", "lm-program-starts": "the thesis's program, from random starts"};
const percent = (/** @type {number} */ share) => (100 * share).toFixed(1) + " %";

/** @import {Target} from "naocal/lib/types.js" */

/**
 * @param {CanvasRenderingContext2D} context
 * @param {number} width
 * @param {number} height
 * @param {{solvers: any[], thesis: number | null, thesisTolerance: number}} cell
 */
function drawSuccess(context, width, height, {solvers, thesis, thesisTolerance}) {
  const box = {left: 40, right: width - 8, top: 26, bottom: height - 42};
  const last = data.tolerances[data.tolerances.length - 1];
  const {x, y} = axes(context, box, [0, last], [0, 100], {title: "success [%]", xLabel: "tolerance of every offset [°]"});
  /** @type {Target[]} */
  const targets = [];
  const curve = (/** @type {number[]} */ shares, /** @type {string} */ words) => {
    context.beginPath();
    shares.forEach((share, i) => {
      const [a, b] = [x(data.tolerances[i]), y(100 * share)];
      if (i) context.lineTo(a, b); else context.moveTo(a, b);
      targets.push({x: a, y: b, tip: () => words + ": " + percent(share) + " within " + data.tolerances[i] + "°"});
    });
    context.stroke();
  };
  for (const {solver, success, limit} of solvers.filter(each => solverColour[each.solver])) {
    context.strokeStyle = colours[solverColour[solver]];
    context.lineWidth = 2;
    curve(success, solverWords[solver]);
    if (solver === "ours") {
      context.strokeStyle = colours.soft;
      context.lineWidth = 1.5;
      context.setLineDash([5, 4]);
      curve(limit, "the limit");
      context.setLineDash([]);
    }
  }
  if (thesis !== null) {
    context.fillStyle = getComputedStyle(document.body).color;
    const point = {x: x(thesisTolerance), y: y(100 * thesis)};
    context.beginPath();
    context.arc(point.x, point.y, 4, 0, 7);
    context.fill();
    targets.push({...point, tip: () => "the thesis: " + percent(thesis)});
  }
  return targets;
}

/** @typedef {{counts: number[], first: number, width: number}} Histogram */

// Histogram outlines, each normalised to its maximum: errors after calibration are hundreds of times narrower than before.
/** @param {CanvasRenderingContext2D} context @param {number} width @param {number} height @param {{before: Histogram, solvers: (Histogram & {solver: string})[]}} joint */
function drawErrors(context, width, height, {before, solvers}) {
  const box = {left: 46, right: width - 8, top: 26, bottom: height - 42};
  const {x, y} = axes(context, box, [-7, 7], [0, 1.05], {title: "of the highest bar", xLabel: "[°]"});
  /** @type {Target[]} */
  const targets = [];
  const outline = (/** @type {Histogram} */ histogram, /** @type {string} */ colour, /** @type {string} */ words, /** @type {boolean} */ filled) => {
    const {counts, first, width: wide} = histogram;
    const all = counts.reduce((a, b) => a + b, 0), shares = counts.map(count => count / (Math.max(...counts) || 1));
    context.fillStyle = context.strokeStyle = colour;
    context.lineWidth = 1.5;
    context.beginPath();
    context.moveTo(x(first), y(0));
    shares.forEach((share, i) => {
      context.lineTo(x(first + i * wide), y(share));
      context.lineTo(x(first + (i + 1) * wide), y(share));
      if (share > 0) targets.push({x: x(first + (i + 0.5) * wide), y: y(share), tip: () => words + ", " +
        tenths(first + i * wide) + "° to " + tenths(first + (i + 1) * wide) + "°: " + percent(counts[i] / all)});
    });
    context.lineTo(x(first + shares.length * wide), y(0));
    if (filled) {
      context.globalAlpha = 0.25;
      context.fill();
      context.globalAlpha = 1;
    } else {
      context.stroke();
    }
  };
  outline(before, colours.soft, "before", true);
  for (const each of solvers) outline(each, colours[solverColour[each.solver]], "after, " + solverWords[each.solver], false);
  return targets;
}

/**
 * A select of figure lists; the last one, the hardest, is shown first.
 * @param {string} id
 * @param {string} label
 * @param {{name: string}[]} offered
 * @param {(chosen: any) => {name: string}[]} figuresOf
 * @param {number} height
 * @param {(context: CanvasRenderingContext2D, width: number, height: number, each: any) => Target[]} draw
 */
const offer = (id, label, offered, figuresOf, height, draw) => choosing(id, label, offered.map(({name}, i) => ({value: String(i), text: name})),
  i => element("div", {class: "grid"}, ...figuresOf(offered[Number(i)]).map(each => element("figure", {},
    figure({height, label: each.name, draw: (context, width, tall) => draw(context, width, tall, each)}),
    element("figcaption", {}, bold(each.name))))), String(offered.length - 1));

/** Maps of one setting, with one scale of colours. @param {{solvers: {solver: string, squares: any[]}[], square: number, fieldsOfView: any[]}} setting */
function mapsOf({solvers, square, fieldsOfView}) {
  const largest = Math.max(1e-3, ...solvers.flatMap(({squares}) => squares.map(each => each[3])));
  return element("div", {class: "grid"}, ...solvers.map(({solver, squares}) => element("figure", {},
    residualMap({squares, square, fieldsOfView, largest}, "residuals on the floor, " + solverWords[solver]),
    element("figcaption", {}, bold(solverWords[solver])))));
}

showHead({...data, verdict: "good"});
at("success").append(offer("table", "Table", data.tables, table => table.cells, 250, drawSuccess));
at("errors").append(offer("setting", "Setting", data.settings, setting => setting.joints, 230, drawErrors));
if (data.residualMaps.length) {
  at("floor").hidden = false;
  at("residuals").append(choosing("map", "Setting", data.residualMaps.map((/** @type {{name: string}} */ {name}, /** @type {number} */ i) =>
    ({value: String(i), text: name})), i => mapsOf(data.residualMaps[Number(i)])));
}
if (data.restartedFailures) {
  const {failures, reached, ranOut, interval: [low, high]} = data.restartedFailures;
  at("minima").hidden = false;
  at("restarted").append(bold("They are none: "), "of " + failures + " noiseless failures here, " + reached + " reach the true offsets (" +
    percent(reached / failures) + ", 95 % interval " + percent(low) + " to " + percent(high) +
    ") when Levenberg-Marquardt with exact derivatives starts from the wrong answer. " + ranOut + " of the failures had run out of evaluations.");
}
showContents();
