// Residuals over anything that was recorded: every corner a point, squares for the means over stretches.
import {figure, axes, colours} from "./canvas.js";
import {withUnit, short, quantile} from "./words.js";
import {cornersOf, cornerTip} from "./pictures.js";
import {state} from "./state.js";

// What can stand below: of the corner, then what was recorded with the picture.
export function horizontals(fit) {
  const own = [
    {value: "u", text: "column u in the picture [px]", of: corner => corner.u},
    {value: "v", text: "row v in the picture [px]", of: corner => corner.v},
    {value: "radius", text: "distance from the picture's centre [px]",
      of: ({u, v, picture}) => Math.hypot(u - picture.width / 2, v - picture.height / 2)},
    {value: "capture", text: "number of the capture", of: ({picture}) => picture.capture},
  ].map(one => ({...one, group: "in the picture"}));
  const group = name => name === "t" ? "time" : name.startsWith("tau_") ? "torques" : ["approach", "T", "qd"].includes(name) ? "motion and warmth" : "angles";
  return own.concat(fit.drivers.map((driver, i) => ({
    value: "driver" + i, text: driver.what + (driver.unit ? " [" + driver.unit + "]" : ""), group: group(driver.name),
    of: ({picture}) => driver.values[picture.index],
  })));
}

export const verticals = [
  {value: "du", text: "to the right [px]", of: ({du}) => du},
  {value: "dv", text: "down [px]", of: ({dv}) => dv},
  {value: "length", text: "length [px]", of: ({du, dv}) => Math.hypot(du, dv)},
];

export function scatterFigure({fit, horizontal, vertical, camera, choose}) {
  const points = [];
  for (const picture of fit.pictures) {
    if (camera && picture.camera !== camera) continue;
    for (const corner of cornersOf(picture)) {
      const x = horizontal.of(corner), y = vertical.of(corner);
      if (isFinite(x) && isFinite(y)) points.push({x, y, corner});
    }
  }
  return figure({
    height: 340, label: "error " + vertical.text + " over " + horizontal.text, className: "scatter",
    draw: (context, width, height) => draw(context, width, height, {points, horizontal, vertical, choose}),
  });
}

function draw(context, width, height, {points, horizontal, vertical, choose}) {
  if (!points.length) return [];
  const xs = points.map(point => point.x), low = xs.reduce((a, b) => Math.min(a, b)), high = xs.reduce((a, b) => Math.max(a, b));
  const margin = 0.02 * (high - low) || 0.5;
  const reach = 1.15 * Math.max(0.3, quantile(points.map(({y}) => Math.abs(y)), 0.995));
  const box = {left: 50, right: width - 10, top: 28, bottom: height - 44};
  const {x, y, line} = axes(context, box, [low - margin, high + margin], [vertical.value === "length" ? 0 : -reach, reach],
    {xLabel: horizontal.text, title: "predicted − measured, " + vertical.text});
  context.fillStyle = colours.blue;
  context.globalAlpha = Math.max(0.12, Math.min(0.6, 900 / points.length));
  const size = points.length > 20000 ? 2 : 3.2;
  const targets = points.map(point => {
    const at = {x: x(point.x), y: Math.max(box.top, Math.min(box.bottom, y(point.y))), point};
    context.fillRect(at.x - size / 2, at.y - size / 2, size, size);
    return at;
  });
  context.globalAlpha = 1;
  if (state.chosen) {
    context.strokeStyle = colours.pink;
    context.lineWidth = 1.5;
    targets.filter(({point}) => isChosen(point.corner.picture)).forEach(at => {
      context.beginPath();
      context.arc(at.x, at.y, 4.5, 0, 7);
      context.stroke();
    });
  }
  for (const stretch of stretches(points)) {
    const at = x(stretch.x);
    context.strokeStyle = context.fillStyle = colours.orange;
    context.lineWidth = 2;
    line(at, y(stretch.y - 2 * stretch.error), at, y(stretch.y + 2 * stretch.error));
    context.fillRect(at - 4, y(stretch.y) - 4, 8, 8);
  }
  return targets.map(({x: left, y: top, point}) => ({
    x: left, y: top, click: () => choose(point.corner.picture),
    tip: () => cornerTip(point.corner) + "\n" + horizontal.text.replace(/ \[.*/, "") + ": " + unitOf(horizontal, point.x),
  }));
}

const unitOf = ({text}, value) => withUnit(short(value), (text.match(/\[(.*)\]/) || ["", ""])[1]);

export const isChosen = picture => state.chosen && state.chosen.set === picture.set && state.chosen.capture === picture.capture &&
  state.chosen.camera === picture.camera;

// Means of ten stretches with as many pictures each; a picture's corners move together, so pictures count, not corners.
function stretches(points) {
  const byPicture = new Map();
  for (const {x, y, corner} of points) {
    if (!byPicture.has(corner.picture)) byPicture.set(corner.picture, {x: 0, y: 0, count: 0, low: x, high: x});
    const sum = byPicture.get(corner.picture);
    sum.x += x; sum.y += y; sum.count += 1; sum.low = Math.min(sum.low, x); sum.high = Math.max(sum.high, x);
  }
  const varies = [...byPicture.values()].some(({low, high}) => high > low); // within a picture: corners count
  const means = (varies ? points.map(({x, y}) => ({x, y})) : [...byPicture.values()].map(({x, y, count}) => ({x: x / count, y: y / count})))
    .sort((a, b) => a.x - b.x);
  const count = Math.min(10, Math.floor(means.length / 4)), result = [];
  for (let i = 0; i < count; ++i) {
    const part = means.slice(Math.floor(i * means.length / count), Math.floor((i + 1) * means.length / count));
    const mean = key => part.reduce((sum, one) => sum + one[key], 0) / part.length;
    const y = mean("y"), spread = Math.sqrt(part.reduce((sum, one) => sum + (one.y - y) ** 2, 0) / Math.max(1, part.length - 1));
    result.push({x: mean("x"), y, error: spread / Math.sqrt(part.length)});
  }
  return result;
}
