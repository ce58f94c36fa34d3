// The joint by driver map, and the best of its curves.
import {make, button, empty} from "./elements.js";
import {figure, axes, colours} from "./canvas.js";
import {tenths, chance, driverWords, withUnit, withError, short} from "./words.js";
import {state} from "./state.js";
import {ownFrom} from "./own.js";

export function showMap(parent, go) {
  const {questions} = state;
  if (!questions) {
    parent.replaceChildren(make("h1", {}, "Joint by driver"), empty("The map is being drawn", "This takes a second or two."));
    return;
  }
  const cells = questions.map;
  if (!cells.length) {
    parent.replaceChildren(make("h1", {}, "Joint by driver"), empty("There is no map", "No joint of these captures moved enough for a curve."));
    return;
  }
  const best = cells.reduce((a, b) => a.evidence > b.evidence ? a : b);
  const joints = [...new Set(cells.map(({joint}) => joint))];
  const map = figure({
    height: width => 118 + joints.length * Math.max(15, Math.min(26, width / 36)), label: "evidence by joint and driver",
    draw: (context, width, height) => draw(context, width, height, cells, joints, best),
  });
  parent.replaceChildren(
    make("h1", {}, "Joint by driver"),
    make("p", {class: "soft"}, "How well a smooth curve of each joint (rows) over each thing that it may vary with (columns) " +
      "would explain what the model leaves over: the darker, the better. This looks beyond the known effects. ",
      make("b", {}, best.evidence > 0 ? "Best: " + best.joint + " over " + driverWords(best.driver) + " (evidence " + tenths(best.evidence) + ")."
        : "Here it is empty: nothing is left.")),
    make("div", {class: "controls"}, button("PNG", () => map.save("map.png"), {class: "small"})),
    map, make("h2", {}, "Curves"),
    make("p", {class: "soft"}, questions.curves.some(({evidence}) => evidence > 0)
      ? "The best curves with a band of two standard errors. Take one over as an effect of your own and see what it explains."
      : "Their evidence is below 0: nothing is left that a curve would explain. They are drawn so that you can see that."),
    make("div", {class: "grid"}, ...questions.curves.map(curve => curveFigure(curve, go))));
}

function draw(context, width, height, cells, joints, best) {
  const rank = name => joints.includes(name) ? 0 : name.startsWith("tau_") ? 1 : 2;
  const drivers = [...new Set(cells.map(({driver}) => driver))].sort((a, b) => rank(a) - rank(b));
  context.font = "11px system-ui, sans-serif";
  const left = 100, top = 116, wide = (width - left - 2) / drivers.length, high = (height - top - 2) / joints.length;
  const most = Math.max(6, best.evidence); // below it nothing deserves the darkest
  context.textBaseline = "middle";
  context.textAlign = "right";
  context.fillStyle = colours.soft;
  joints.forEach((joint, row) => context.fillText(joint, left - 6, top + (row + 0.5) * high));
  const every = Math.ceil(12 / wide);
  context.textAlign = "left";
  drivers.forEach((driver, column) => {
    if (column % every) return;
    context.save();
    context.translate(left + (column + 0.5) * wide, top - 5);
    context.rotate(-Math.PI / 2);
    context.fillText(driver, 0, 0);
    context.restore();
  });
  return cells.map(cell => {
    const x = left + drivers.indexOf(cell.driver) * wide, y = top + joints.indexOf(cell.joint) * high;
    context.fillStyle = colours.panel;
    context.fillRect(x, y, wide - 1, high - 1);
    context.fillStyle = colours.blue;
    context.globalAlpha = Math.sqrt(Math.max(0, cell.evidence) / most);
    context.fillRect(x, y, wide - 1, high - 1);
    context.globalAlpha = 1;
    if (cell === best && cell.evidence > 0) {
      context.strokeStyle = colours.orange;
      context.lineWidth = 2;
      context.strokeRect(x, y, wide - 1, high - 1);
    }
    return {x: x + wide / 2, y: y + high / 2, tip: () => cell.joint + " over " + driverWords(cell.driver) + "\nevidence " +
      tenths(cell.evidence) + ", alone " + chance(cell.pValue)};
  });
}

function curveFigure(curve, go) {
  const {joint, driver, what, unit, points} = curve;
  const drawn = figure({height: 250, label: joint + " over " + what, draw: (context, width, height) => {
    const box = {left: 52, right: width - 8, top: 28, bottom: height - 42};
    const reach = 1.05 * Math.max(1e-3, ...points.map(([, y, error]) => Math.abs(y) + 2 * error));
    const xs = points.map(([x]) => x), name = driver === "q" ? joint : driver === "tau" ? "tau_" + joint : driver;
    const {x, y} = axes(context, box, [Math.min(...xs), Math.max(...xs)], [-reach, reach],
      {yLabel: curve.title + " [°]", xLabel: name + (unit ? " [" + unit + "]" : "")});
    const path = list => {
      context.beginPath();
      list.forEach(([a, b], i) => i ? context.lineTo(x(a), y(b)) : context.moveTo(x(a), y(b)));
    };
    context.fillStyle = context.strokeStyle = colours.blue;
    context.globalAlpha = 0.2;
    path([...points.map(([a, b, error]) => [a, b + 2 * error]), ...points.map(([a, b, error]) => [a, b - 2 * error]).reverse()]);
    context.fill();
    context.globalAlpha = 1;
    context.lineWidth = 2.5;
    path(points);
    context.stroke();
    return points.map(([a, b, error]) => ({x: x(a), y: y(b), tip: () => name + " = " + withUnit(short(a), unit) + "\n" + curve.title +
      ": " + withError(b, error, "°")}));
  }});
  return make("figure", {}, drawn, make("figcaption", {}, make("b", {}, joint + " over " + what), ": ± " + short(curve.amplitude) +
    "°, evidence " + tenths(curve.evidence)),
    curve.evidence > 0 && curve.model ? button("Take over as an own effect", () => { ownFrom(curve.model.define[0]); go("own"); }, {class: "small"}) : null);
}
