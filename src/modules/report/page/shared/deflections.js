// What each joint alone would have to do to explain what is left over, drawn over anything that was recorded.
import {colours} from "./figure.js";
import {axes, dot} from "./axes.js";
import {bold, mean, quantile, short, withError, withUnit} from "./words.js";
import {takenNames} from "./taken.js";

const fewValues = 6; // of a driver: then each stands for itself

function poseOrder({poses, pictures}) {
  const first = poses.map(pose => Math.min(...pose.pictures.map(picture => pictures[picture].capture)));
  const sorted = [...first].sort((a, b) => a - b);
  return {what: "the order of the poses", unit: "", joint: "", values: pictures.map(({pose}) => 1 + sorted.indexOf(first[pose]))};
}

// The joints that have points, each with the drivers that it can be drawn over, what varies most first.
export function jointsByTrend(data) {
  const drivers = [...data.drivers, poseOrder(data)];
  const offered = joint => drivers.filter(driver => !driver.joint || driver.joint === joint)
    .map(driver => ({driver, strength: trendOf(data, "asGiven", joint, driver).strength})).sort((a, b) => b.strength - a.strength);
  return (data.left.asGiven ? data.left.asGiven.whatIf : []).filter(({points}) => points.length)
    .map(({joint}) => ({joint, offered: offered(joint)})).sort((a, b) => b.offered[0].strength - a.offered[0].strength);
}

// Points of a joint over a driver, the means over stretches of it, and how many standard errors these lie from zero.
export function trendOf({left, pictures: taken}, model, joint, driver) {
  const points = left[model].whatIf.find(one => one.joint === joint).points.map(([pictures, y, sigma]) =>
    ({x: mean(pictures.map(picture => driver.values[picture])), y, sigma, pictures, pose: taken[pictures[0]].pose}));
  const xs = points.map(({x}) => x), range = Math.max(...xs) - Math.min(...xs) || 1;
  const groups = new Map(); // what is not independent: points of one pose, unless the driver changed meanwhile
  for (const point of points) {
    const key = point.pose + "/" + Math.round(10 * (point.x - xs[0]) / range);
    if (!groups.has(key)) groups.set(key, []);
    groups.get(key).push(point);
  }
  const members = [...groups.values()].map(list => weighted(list)).sort((a, b) => a.x - b.x);
  const means = stretchesOf(members, range).map(list => ({...weighted(list), error: spreadOf(list)}))
    .filter(({error}) => error > 0);
  const strength = means.length > 1 ? Math.sqrt(mean(means.map(({y, error}) => (y / error) ** 2))) : 0;
  return {points, means, strength};
}

// The mean of points that weigh by their errors.
function weighted(list) {
  const weights = list.map(({sigma}) => sigma ** -2), sum = weights.reduce((a, b) => a + b, 0);
  const over = value => list.reduce((all, point, i) => all + weights[i] * value(point), 0) / sum;
  return {x: over(({x}) => x), y: over(({y}) => y), sigma: sum ** -0.5};
}

// The standard error of that mean by how the points differ.
function spreadOf(list) {
  const {y: middle, sigma} = weighted(list);
  const chi2 = list.reduce((sum, {y, sigma: own}) => sum + ((y - middle) / own) ** 2, 0);
  return list.length > 1 ? sigma * Math.sqrt(Math.max(1, chi2 / (list.length - 1))) : 0;
}

// Stretches of equally many points, or one for each value where there are only few.
function stretchesOf(members, range) {
  const values = new Map();
  for (const member of members) {
    const key = Math.round(50 * member.x / range);
    if (!values.has(key)) values.set(key, []);
    values.get(key).push(member);
  }
  if (values.size <= fewValues) return [...values.values()];
  const count = Math.max(1, Math.min(8, Math.floor(members.length / 4)));
  return Array.from({length: count}, (_, i) =>
    members.slice(Math.round(i * members.length / count), Math.round((i + 1) * members.length / count)));
}

// What a joint would have to do over a driver; says in `caption` whether that is a trend.
export function drawWhatIf(context, width, height, {data, model, joint, driver, caption}) {
  const {points, means, strength} = trendOf(data, model, joint, driver), {unit, what} = driver, {poseName} = takenNames(data);
  const xs = points.map(({x}) => x), low = Math.min(...xs), high = Math.max(...xs), margin = 0.03 * (high - low || 1);
  const reach = 1.15 * Math.max(quantile(points.map(({y}) => Math.abs(y)), 0.97),
    ...means.map(({y, error}) => Math.abs(y) + 2 * error), 1e-3);
  const box = {left: 56, right: width - 8, top: 30, bottom: height - 42};
  const {x, y, line} = axes(context, box, [low - margin, high + margin], [-reach, reach],
    {title: "deflection of " + joint + " that would explain it [°]", xLabel: what + (unit ? " [" + unit + "]" : "")});
  const inside = value => Math.max(-reach, Math.min(reach, value));
  context.strokeStyle = context.fillStyle = colours.blue;
  context.lineWidth = 1;
  const targets = points.map(point => {
    const {x: a, y: b, sigma, pictures} = point;
    context.globalAlpha = 0.3;
    line(x(a), y(inside(b - sigma)), x(a), y(inside(b + sigma)));
    context.globalAlpha = 0.8;
    const target = {x: x(a), y: y(inside(b)), beyond: Math.abs(b) > reach ? -Math.sign(b) : 0};
    dot(context, target);
    return {...target, picture: pictures[0], tip: () => poseName(point.pose) + "\ncaptures " + pictures.map(picture =>
      data.pictures[picture].capture).join(", ") + "\n" + what + ": " + withUnit(short(a), unit) + "\n" + joint + " off by " +
      withError(b, sigma, "°")};
  });
  context.globalAlpha = 1;
  context.strokeStyle = context.fillStyle = colours.orange;
  context.lineWidth = 2;
  means.forEach((here, i) => {
    line(x(here.x), y(inside(here.y - 2 * here.error)), x(here.x), y(inside(here.y + 2 * here.error)));
    if (i) line(x(means[i - 1].x), y(inside(means[i - 1].y)), x(here.x), y(inside(here.y)));
    context.fillRect(x(here.x) - 3, y(inside(here.y)) - 3, 6, 6);
  });
  caption.replaceChildren(bold(joint + " over " + what), strength > 2
    ? ": a trend, its means lie " + strength.toFixed(1) + " standard errors from zero."
    : ": no trend, its means lie about as far from zero as they would by chance (" + strength.toFixed(1) + " standard errors).");
  return targets;
}
