// Scatter of residuals over recorded quantities: options of both axes, and the points.
import {orderOfTaking, pictureName} from "naocal/lib/captures.js";
import {axisNames} from "naocal/lib/readings.js";
import {short, withError, withUnit} from "naocal/lib/format.js";
import {binnedMeans, mean} from "naocal/lib/statistics.js";
import {cornerTip} from "naocal/plots/corners.js";
import {componentTitle, readingTip} from "naocal/plots/reading-dots.js";
import {residualScatter} from "naocal/plots/residual-scatter.js";
import {cornersOf, steady} from "./pictures.js";
import {state} from "../core/state.js";

// Options of the x axis: coordinates of the corner or the reading, then quantities recorded with the capture.
export function horizontals(fit, {joint, series}) {
  const captureNumber = {value: "capture", text: "number of the capture", of: (/** @type {any} */ {picture}) => picture.capture};
  const own = series ? [...(series.isPlace ? axisNames.map((name, axis) => ({value: "at" + name, text: name + " in the world [m]", group: "in space", of: (/** @type {any} */ {reading}) => reading.at[axis]})) : []),
    {...captureNumber, group: "in time"}] : [
    {value: "u", text: "column u in the picture [px]", of: corner => corner.u},
    {value: "v", text: "row v in the picture [px]", of: corner => corner.v},
    {value: "radius", text: "distance from the picture's centre [px]",
      of: ({u, v, picture}) => Math.hypot(u - picture.width / 2, v - picture.height / 2)},
  ].filter(() => !joint).concat(captureNumber).map(one => ({...one, group: fit.pictures.length ? "in the picture" : "in time"}));
  const group = name => name === "t" ? "time" : name.startsWith("tau_") ? "torques" : ["approach", "T", "qd"].includes(name) ? "motion and warmth" : "angles";
  return own.concat(fit.drivers.map((driver, i) => ({
    value: "driver" + i, text: driver.what + (driver.unit ? " [" + driver.unit + "]" : ""), group: group(driver.name),
    of: ({picture}) => driver.values[picture.index],
  })));
}

export const verticals = ({pictures, readings}) => [...(pictures.length ? [
  {value: "du", text: "to the right [px]", of: ({du}) => du, group: "of corners"},
  {value: "dv", text: "down [px]", of: ({dv}) => dv, group: "of corners"},
  {value: "length", text: "length [px]", of: ({du, dv}) => Math.hypot(du, dv), group: "of corners"},
] : []),
  ...readings.flatMap((series, i) => [...axisNames.map((name, axis) => ({value: "reading" + i + name, text: (series.isPlace ? "along " : "about ") + name + " [" + series.unit + "]",
    title: componentTitle(series, name), group: "of " + series.title, series, of: ({error}) => error[axis]})),
  {value: "reading" + i + "length", text: "length [" + series.unit + "]", title: "length of the error [" + series.unit + "]", group: "of " + series.title, series, isLength: true, of: ({error}) => Math.hypot(...error)}]),
  ...((state.diagnosis ?? state.earlier)?.left.asGiven?.whatIf ?? []).filter(({points}) => points.length).map(({joint, unit, points}) =>
    ({value: joint, text: joint + " [" + unit + "]", joint, unit, points, group: "of a joint that would explain the misfit"})),
];

export function scatterFigure({fit, horizontal, vertical, camera, choose}) {
  const {joint, series} = vertical;
  /** @type {import("naocal/plots/residual-scatter.js").ScatterPoint[]} */
  const points = joint ? jointErrors(fit, horizontal, vertical, camera) : series ? readings(fit, horizontal, vertical) : corners(fit, horizontal, vertical, camera);
  const over = horizontal.text.replace(/ \[.*/, "");
  // Points of one pose share its errors, so they count once per twentieth of the driver's range.
  const means = binnedMeans(points.map(({x, y, picture}) => ({x, y, picture})), {places: 20, groupOf: ({picture}) => picture.set + "\n" + (picture.pose || picture.capture)});
  return residualScatter({
    points: points.map(point => ({...point, tip: () => point.tip() + "\n" + over + ": " + unitOf(horizontal, point.x)})), means,
    least: joint ? 0.02 : series ? 2 * series.sigma : 0.3, fromZero: vertical.value === "length" || vertical.isLength, isChosen: state.chosen ? isChosen : undefined,
    title: joint ? "error of " + joint + " that would explain the misfit [" + vertical.unit + "]" : vertical.title ?? "predicted − measured, " + vertical.text, xLabel: horizontal.text,
  }, {label: (joint ? "error of " + joint : "error " + vertical.text) + " over " + horizontal.text, className: "scatter", open: choose});
}

function corners(fit, horizontal, vertical, camera) {
  return fit.pictures.filter(picture => !camera || picture.camera === camera).flatMap(picture => cornersOf(picture).map(corner =>
    ({x: horizontal.of(corner), y: vertical.of(corner), picture, tip: () => cornerTip(corner, pictureName)}))).filter(({x, y}) => isFinite(x) && isFinite(y));
}

/** Names and tips of readings; the captures of a click. */
export function readingTools(fit) {
  const places = orderOfTaking(fit.captures);
  return {layer: () => state.layer, nameOf: ({of}) => pictureName(fit.captures[of]), orderOf: ({of}) => places[of],
    pictureOf: ({of}) => fit.captures[of], isChosen: state.chosen ? ({of}) => isChosen(fit.captures[of]) : undefined, steady};
}

function readings(fit, horizontal, {series, of}) {
  const tools = readingTools(fit);
  return series.points.map(reading => ({x: horizontal.of({reading, picture: fit.captures[reading.of]}), y: of({error: reading[state.layer]}),
    picture: fit.captures[reading.of], tip: () => readingTip(reading, series, tools)})).filter(({x, y}) => isFinite(x) && isFinite(y));
}

// Estimates of the joint's error, each with the captures that share it.
function jointErrors(fit, horizontal, {joint, unit, points}, camera) {
  const byIndex = new Map([...fit.captures, ...fit.pictures].map(picture => [picture.index, picture]));
  return points.flatMap(([indices, y, sigma]) => {
    const pictures = indices.map(index => byIndex.get(index)).filter(picture => picture && (!camera || picture.camera === camera));
    return pictures.length ? [{x: mean(pictures.map(picture => horizontal.of({picture}))), y, sigma, picture: pictures[0],
      tip: () => joint + " off by " + withError(y, sigma, unit) + "\n" + pictures.map(pictureName).join("\n")}] : [];
  }).filter(({x}) => isFinite(x));
}

const unitOf = ({text}, value) => withUnit(short(value), (text.match(/\[(.*)\]/) || ["", ""])[1]);

export const isChosen = ({set, capture, camera}) => state.chosen !== null && state.chosen.set === set && state.chosen.capture === capture && state.chosen.camera === camera;
