// Plots that stand in the report and in the panel alike.
import {colours} from "./figure.js";
import {arrow, axes, dot} from "./axes.js";
import {chance, driverWords, short, tenths, withError, withUnit} from "./words.js";

export const doubtfulBelow = 0.5; // of a corner's weight

// A corner in a picture, {x, y, endX, endY, doubtful}: a ring where measured, a line to a cross where predicted; as a
// halo broad and pale, to make it stand out from a photograph.
export function drawCorner(context, {x, y, endX, endY, doubtful}, halo) {
  const stroke = (name, path) => {
    context.strokeStyle = halo ? "rgba(255, 255, 255, 0.6)" : colours[name];
    context.lineWidth = halo ? 3.5 : 1.5;
    context.beginPath();
    path();
    context.stroke();
  };
  stroke("orange", () => {
    context.moveTo(x, y); context.lineTo(endX, endY);
    context.moveTo(endX - 3, endY - 3); context.lineTo(endX + 3, endY + 3);
    context.moveTo(endX - 3, endY + 3); context.lineTo(endX + 3, endY - 3);
  });
  stroke("blue", () => context.arc(x, y, 3.5, 0, 7));
  if (doubtful) stroke("pink", () => context.rect(x - 8, y - 8, 16, 16));
}

// An effect's imprint on corners [u, v, du, dv, left, down]: shifted, and what is left after refitting.
export function drawShift(context, scale, enlarged, [u, v, du, dv, left, down]) {
  const x = scale * (u + 0.5), y = scale * (v + 0.5);
  arrow(context, colours.orange, 5, x, y, scale * enlarged * du, scale * enlarged * dv);
  arrow(context, colours.blue, 1.5, x, y, scale * enlarged * left, scale * enlarged * down);
  return {x, y};
}

export const bestOf = cells => cells.reduce((a, b) => a.evidence > b.evidence ? a : b);
const jointsOf = cells => [...new Set(cells.map(({joint}) => joint))];
const mapTop = 132; // room for the drivers' names [px]
const shortDriver = name => ({t: "time", T: "temperature", qd: "speed"})[name] || name.replace("tau_", "torque ");

export const mapHeight = cells => width => mapTop + 2 + jointsOf(cells).length * Math.max(14, Math.min(26, width / 36));

// Joints by drivers: the fuller a cell's colour, the better a curve explains what is left over.
export function drawMap(context, width, height, cells) {
  const joints = jointsOf(cells), best = bestOf(cells);
  const rank = name => joints.includes(name) ? 0 : name.startsWith("tau_") ? 1 : 2;
  const drivers = [...new Set(cells.map(({driver}) => driver))].sort((a, b) => rank(a) - rank(b));
  context.font = "12px system-ui, sans-serif";
  const left = 104, wide = (width - left - 2) / drivers.length, high = (height - mapTop - 2) / joints.length;
  const most = Math.max(6, best.evidence); // 6: below it nothing deserves the darkest
  context.textBaseline = "middle";
  context.textAlign = "right";
  context.fillStyle = colours.soft;
  joints.forEach((joint, row) => context.fillText(joint, left - 6, mapTop + (row + 0.5) * high));
  const every = Math.ceil(13 / wide);
  context.textAlign = "left";
  drivers.forEach((driver, column) => {
    if (column % every) return;
    context.save();
    context.translate(left + (column + 0.5) * wide, mapTop - 5);
    context.rotate(-Math.PI / 2);
    context.fillText(shortDriver(driver), 0, 0);
    context.restore();
  });
  const gap = wide > 6 ? 1 : 0;
  drawMapScale(context, most);
  return cells.map(cell => {
    const x = left + drivers.indexOf(cell.driver) * wide, y = mapTop + joints.indexOf(cell.joint) * high;
    context.fillStyle = colours.panel;
    context.fillRect(x, y, wide - gap, high - 1);
    context.fillStyle = colours.blue;
    context.globalAlpha = Math.sqrt(Math.max(0, cell.evidence) / most);
    context.fillRect(x, y, wide - gap, high - 1);
    context.globalAlpha = 1;
    if (cell === best && cell.evidence > 0) {
      context.strokeStyle = colours.orange;
      context.lineWidth = 2;
      context.strokeRect(x, y, wide - gap, high - 1);
    }
    return {x: x + wide / 2, y: y + high / 2, tip: () => cell.joint + " over " + driverWords(cell.driver) + "\nevidence " +
      tenths(cell.evidence) + ", alone " + chance(cell.pValue)};
  });
}

// What a cell's colour stands for, in the corner above the joints' names.
function drawMapScale(context, most) {
  context.fillStyle = colours.soft;
  context.textBaseline = "alphabetic";
  context.fillText("evidence", 0, 14);
  [0, 0.25, 0.5, 0.75, 1].forEach((share, i) => {
    context.fillStyle = colours.panel;
    context.fillRect(16 * i, 20, 15, 14);
    context.fillStyle = colours.blue;
    context.globalAlpha = Math.sqrt(share);
    context.fillRect(16 * i, 20, 15, 14);
    context.globalAlpha = 1;
  });
  context.fillStyle = colours.soft;
  context.fillText("≤ 0", 0, 49);
  context.textAlign = "right";
  context.fillText(tenths(most), 80, 49);
  context.textAlign = "left";
}

// A joint's deflection over what it varies with, with a band of two standard errors; a few points on their own, where
// there is nothing between them.
export function drawCurve(context, width, height, {joint, driver, unit, valueUnit = "°", points, title = "deflection of " + joint}) {
  const box = {left: 52, right: width - 8, top: 30, bottom: height - 42};
  const reach = 1.05 * Math.max(1e-3, ...points.map(([, y, error]) => Math.abs(y) + 2 * error));
  const xs = points.map(([x]) => x), name = driver === "q" ? joint : driver === "tau" ? "tau_" + joint : driver;
  const few = points.length < 5, beside = few ? 0.5 : 0;
  const {x, y} = axes(context, box, [Math.min(...xs) - beside, Math.max(...xs) + beside], [-reach, reach],
    {title: title + " [" + valueUnit + "]", xLabel: name + (unit ? " [" + unit + "]" : "")});
  const path = list => {
    context.beginPath();
    list.forEach(([a, b], i) => i ? context.lineTo(x(a), y(b)) : context.moveTo(x(a), y(b)));
  };
  context.fillStyle = context.strokeStyle = colours.blue;
  context.lineWidth = 2.5;
  if (few) {
    for (const [a, b, error] of points) {
      path([[a, b - 2 * error], [a, b + 2 * error]]);
      context.stroke();
      dot(context, {x: x(a), y: y(b)});
    }
  } else {
    context.globalAlpha = 0.2;
    path([...points.map(([a, b, error]) => [a, b + 2 * error]), ...points.map(([a, b, error]) => [a, b - 2 * error]).reverse()]);
    context.fill();
    context.globalAlpha = 1;
    path(points);
    context.stroke();
  }
  return points.map(([a, b, error]) => ({x: x(a), y: y(b), tip: () => name + " = " + withUnit(short(a), unit) + "\n" + title +
    ": " + withError(b, error, valueUnit)}));
}

// A point for each pose, a line whose slope is the effect's size, and its band of two standard errors.
// tipOf([pose, x, y]) says what a point is.
export function drawAdded(context, width, height, {of, unit, slope, sigma, points}, tipOf) {
  const box = {left: 46, right: width - 8, top: 30, bottom: height - 42};
  const spread = (values, least) => {
    const low = Math.min(0, ...values), high = Math.max(0, ...values), margin = 0.06 * (high - low) + least;
    return [low - margin, high + margin];
  };
  const [left, right] = spread(points.map(([, x]) => x), 1e-9), [bottom, top] = spread(points.map(([, , y]) => y), 1);
  const {x, y, line} = axes(context, box, [left, right], [bottom, top], {title: "measured that way [sigma]",
    xLabel: "what " + (of === "size" ? "the size found" : withUnit(of + " = 1", unit)) + " would do [sigma]"});
  context.save();
  context.beginPath();
  context.rect(box.left, box.top, box.right - box.left, box.bottom - box.top);
  context.clip();
  context.strokeStyle = context.fillStyle = colours.orange;
  for (const end of [left, right]) {
    context.globalAlpha = 0.2;
    context.beginPath();
    context.moveTo(x(0), y(0));
    context.lineTo(x(end), y(end * (slope - 2 * sigma)));
    context.lineTo(x(end), y(end * (slope + 2 * sigma)));
    context.fill();
    context.globalAlpha = 1;
  }
  context.lineWidth = 2;
  line(x(left), y(left * slope), x(right), y(right * slope));
  context.restore();
  context.strokeStyle = context.fillStyle = colours.blue;
  context.lineWidth = 1;
  return points.filter(([pose]) => pose !== null).map(point => {
    const [, a, b] = point, target = {x: x(a), y: y(b)};
    context.globalAlpha = 0.45;
    line(x(a), y(b - 1), x(a), y(b + 1));
    context.globalAlpha = 1;
    dot(context, target);
    return {...target, tip: () => tipOf(point)};
  });
}
