// Scatter of residuals over recorded quantities: options of both axes, and the points.
import {pictureName} from "naocal/lib/captures.js";
import {short, withError, withUnit} from "naocal/lib/format.js";
import {binnedMeans, mean} from "naocal/lib/statistics.js";
import {cornerTip} from "naocal/plots/corners.js";
import {residualScatter} from "naocal/plots/residual-scatter.js";
import {cornersOf} from "./pictures.js";
import {state} from "../core/state.js";

// Options of the x axis: coordinates of the corner, then quantities recorded with the picture.
export function horizontals(fit, {joint}) {
  const own = [
    {value: "u", text: "column u in the picture [px]", of: corner => corner.u},
    {value: "v", text: "row v in the picture [px]", of: corner => corner.v},
    {value: "radius", text: "distance from the picture's centre [px]",
      of: ({u, v, picture}) => Math.hypot(u - picture.width / 2, v - picture.height / 2)},
  ].filter(() => !joint).concat({value: "capture", text: "number of the capture", of: ({picture}) => picture.capture}).map(one => ({...one, group: "in the picture"}));
  const group = name => name === "t" ? "time" : name.startsWith("tau_") ? "torques" : ["approach", "T", "qd"].includes(name) ? "motion and warmth" : "angles";
  return own.concat(fit.drivers.map((driver, i) => ({
    value: "driver" + i, text: driver.what + (driver.unit ? " [" + driver.unit + "]" : ""), group: group(driver.name),
    axis: driver.name === "approach" ? driver.what + " (−1: from above, 1: from below)" : null,
    of: ({picture}) => driver.values[picture.index],
  })));
}

export const verticals = ({telling}) => [
  {value: "du", text: "to the right [px]", of: ({du}) => du, group: "of corners"},
  {value: "dv", text: "down [px]", of: ({dv}) => dv, group: "of corners"},
  {value: "length", text: "length [px]", of: ({du, dv}) => Math.hypot(du, dv), group: "of corners"},
  ...telling.joints.filter(({points}) => points.length).map(({joint, points}) =>
    ({value: joint, text: joint + " [°]", joint, points, group: "of a joint that would explain the misfit"})),
];

export function scatterFigure({fit, horizontal, vertical, camera, choose}) {
  const {joint} = vertical;
  /** @type {import("naocal/plots/residual-scatter.js").ScatterPoint[]} */
  const points = joint ? readings(fit, horizontal, vertical, camera) : corners(fit, horizontal, vertical, camera);
  const over = horizontal.text.replace(/ \[.*/, "");
  // Points of one pose share its errors, so they count once per twentieth of the driver's range.
  const means = binnedMeans(points.map(({x, y, picture}) => ({x, y, picture})), {places: 20, groupOf: ({picture}) => picture.set + "\n" + (picture.pose || picture.capture)});
  return residualScatter({
    points: points.map(point => ({...point, tip: () => point.tip() + "\n" + over + ": " + unitOf(horizontal, point.x)})), means,
    least: joint ? 0.02 : 0.3, fromZero: vertical.value === "length", isChosen: state.chosen ? isChosen : undefined,
    title: joint ? "error of " + joint + " that would explain the misfit [°]" : "predicted − measured, " + vertical.text, xLabel: horizontal.axis || horizontal.text,
  }, {label: (joint ? "error of " + joint : "error " + vertical.text) + " over " + horizontal.text, className: "scatter", open: choose});
}

function corners(fit, horizontal, vertical, camera) {
  return fit.pictures.filter(picture => !camera || picture.camera === camera).flatMap(picture => cornersOf(picture).map(corner =>
    ({x: horizontal.of(corner), y: vertical.of(corner), picture, tip: () => cornerTip(corner, pictureName)}))).filter(({x, y}) => isFinite(x) && isFinite(y));
}

// Estimates of the joint's error, each with the pictures that share it.
function readings(fit, horizontal, {joint, points}, camera) {
  const byIndex = new Map(fit.pictures.map(picture => [picture.index, picture]));
  return points.flatMap(([indices, y, sigma]) => {
    const pictures = indices.map(index => byIndex.get(index)).filter(picture => picture && (!camera || picture.camera === camera));
    return pictures.length ? [{x: mean(pictures.map(picture => horizontal.of({picture}))), y, sigma, picture: pictures[0],
      tip: () => joint + " off by " + withError(y, sigma, "°") + "\n" + pictures.map(pictureName).join("\n")}] : [];
  }).filter(({x}) => isFinite(x));
}

const unitOf = ({text}, value) => withUnit(short(value), (text.match(/\[(.*)\]/) || ["", ""])[1]);

export const isChosen = ({set, capture, camera}) => state.chosen !== null && state.chosen.set === set && state.chosen.capture === capture && state.chosen.camera === camera;
