// Residuals over anything that was recorded: every corner a point, squares for the means over stretches.
import {figure, axes, colours} from "./canvas.js";
import {withUnit, withError, short, quantile, pictureName} from "./words.js";
import {cornersOf, cornerTip} from "./pictures.js";
import {state} from "./state.js";

// What can stand below: of the corner, then what was recorded with the picture.
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
  const points = vertical.joint ? readings(fit, horizontal, vertical, camera) : corners(fit, horizontal, vertical, camera);
  const what = vertical.joint ? "error of " + vertical.joint : "error " + vertical.text;
  return figure({
    height: 340, label: what + " over " + horizontal.text, className: "scatter",
    draw: (context, width, height) => draw(context, width, height, {points, horizontal, vertical, choose}),
  });
}

function corners(fit, horizontal, vertical, camera) {
  const points = [];
  for (const picture of fit.pictures) {
    if (camera && picture.camera !== camera) continue;
    for (const corner of cornersOf(picture)) {
      const x = horizontal.of(corner), y = vertical.of(corner);
      if (isFinite(x) && isFinite(y)) points.push({x, y, picture, tip: () => cornerTip(corner)});
    }
  }
  return points;
}

// One of the joint's readings with the pictures that share it.
function readings(fit, horizontal, {joint, points}, camera) {
  const byIndex = new Map(fit.pictures.map(picture => [picture.index, picture])), found = [];
  for (const [indices, y, sigma] of points) {
    const pictures = indices.map(index => byIndex.get(index)).filter(picture => picture && (!camera || picture.camera === camera));
    if (!pictures.length) continue;
    const x = pictures.reduce((sum, picture) => sum + horizontal.of({picture}), 0) / pictures.length;
    if (isFinite(x)) found.push({x, y, sigma, picture: pictures[0], tip: () => joint + " off by " + withError(y, sigma, "°") + "\n" + pictures.map(pictureName).join("\n")});
  }
  return found;
}

const few = 6; // values: then each has its own square, and points of one value stand side by side

function draw(context, width, height, {points, horizontal, vertical, choose}) {
  if (!points.length) return [];
  const xs = points.map(point => point.x), low = xs.reduce((a, b) => Math.min(a, b)), high = xs.reduce((a, b) => Math.max(a, b));
  const means = stretches(points, low, high), aside = new Set(xs).size <= few ? 0.05 * (high - low) : 0;
  const margin = 0.02 * (high - low) + aside || 0.5, {joint} = vertical;
  const reach = 1.15 * Math.max(joint ? 0.02 : 0.3, quantile(points.map(({y}) => Math.abs(y)), 0.995));
  const box = {left: 50, right: width - 10, top: 28, bottom: height - 44};
  const {x, y, line} = axes(context, box, [low - margin, high + margin], [vertical.value === "length" ? 0 : -reach, reach],
    {xLabel: horizontal.axis || horizontal.text, title: joint ? "error of " + joint + " that would explain the misfit [°]" : "predicted − measured, " + vertical.text});
  context.fillStyle = context.strokeStyle = colours.blue;
  context.lineWidth = 1;
  const inside = top => Math.max(box.top, Math.min(box.bottom, top));
  const size = joint ? 5 : points.length > 20000 ? 2 : 3.2;
  const targets = points.map((point, i) => {
    const at = {x: x(point.x + aside * (i * 0.618034 % 1 - 0.5) * 2), y: inside(y(point.y)), point};
    context.globalAlpha = 0.35;
    if (joint) line(at.x, inside(y(point.y - point.sigma)), at.x, inside(y(point.y + point.sigma)));
    context.globalAlpha = joint ? 0.8 : Math.max(0.12, Math.min(0.6, 900 / points.length));
    context.fillRect(at.x - size / 2, at.y - size / 2, size, size);
    return at;
  });
  context.globalAlpha = 1;
  if (state.chosen) {
    context.strokeStyle = colours.pink;
    context.lineWidth = 1.5;
    targets.filter(({point}) => isChosen(point.picture)).forEach(at => {
      context.beginPath();
      context.arc(at.x, at.y, 4.5, 0, 7);
      context.stroke();
    });
  }
  for (const stretch of means) {
    const at = x(stretch.x);
    context.strokeStyle = context.fillStyle = colours.orange;
    context.lineWidth = 2;
    line(at, inside(y(stretch.y - 2 * stretch.error)), at, inside(y(stretch.y + 2 * stretch.error)));
    context.fillRect(at - 4, y(stretch.y) - 4, 8, 8);
  }
  return targets.map(({x: left, y: top, point}) => ({
    x: left, y: top, click: () => choose(point.picture),
    tip: () => point.tip() + "\n" + horizontal.text.replace(/ \[.*/, "") + ": " + unitOf(horizontal, point.x),
  }));
}

const unitOf = ({text}, value) => withUnit(short(value), (text.match(/\[(.*)\]/) || ["", ""])[1]);

export const isChosen = picture => state.chosen && state.chosen.set === picture.set && state.chosen.capture === picture.capture &&
  state.chosen.camera === picture.camera;

// Means of stretches with as many poses each, or of each value where there are few. What points of one pose share is no
// news: they count once wherever the driver is the same.
function stretches(points, low, high) {
  const range = high - low || 1, cells = new Map(); // by pose and place
  for (const {x, y, picture} of points) {
    const key = [picture.set, picture.pose || picture.capture, Math.round(20 * (x - low) / range)].join("\n");
    if (!cells.has(key)) cells.set(key, {x: 0, y: 0, count: 0});
    const sum = cells.get(key);
    sum.x += x; sum.y += y; sum.count += 1;
  }
  const means = [...cells.values()].map(({x, y, count}) => ({x: x / count, y: y / count})).sort((a, b) => a.x - b.x);
  return partsOf(means, range).filter(part => part.length > 1).map(part => {
    const mean = key => part.reduce((sum, one) => sum + one[key], 0) / part.length;
    const y = mean("y"), spread = Math.sqrt(part.reduce((sum, one) => sum + (one.y - y) ** 2, 0) / (part.length - 1));
    return {x: mean("x"), y, error: spread / Math.sqrt(part.length)};
  });
}

function partsOf(means, range) {
  const values = new Map();
  for (const one of means) {
    const key = Math.round(50 * one.x / range);
    values.set(key, [...(values.get(key) || []), one]);
  }
  if (values.size <= few) return [...values.values()];
  const count = Math.max(1, Math.min(10, Math.floor(means.length / 4)));
  return Array.from({length: count}, (_, i) => means.slice(Math.floor(i * means.length / count), Math.floor((i + 1) * means.length / count)));
}
