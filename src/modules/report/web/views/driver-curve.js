// A joint's deflection over a driver, with the fitted expression.
import {bold, copyBox, element} from "naocal/lib/dom.js";
import {figure, colours} from "naocal/lib/figure.js";
import {axes, dot} from "naocal/lib/axes.js";
import {short, tenths, withError, withUnit} from "naocal/lib/format.js";

/** @import {Curve, View, ViewTools} from "naocal/lib/types.js" */

/** @param {Curve} curve @param {ViewTools} [tools] */
function driverCurve(curve, {ownEffect = modelText} = {}) {
  const {joint, what, amplitude, valueUnit, evidence, model} = curve;
  return element("figure", {},
    figure({height: 250, label: joint + " over " + what, draw: (context, width, height) => draw(context, width, height, curve)}),
    element("figcaption", {}, bold(joint + " over " + what), ": ± " + withUnit(short(amplitude), valueUnit) + ", evidence " + tenths(evidence)),
    evidence > 0 && model ? ownEffect(curve) : null);
}

/** The expression as a model file, one line per unknown. @param {Curve} curve */
const modelText = ({expression, model}) => copyBox("like " + expression,
  JSON.stringify(model, null, 1).replace(/\{\s+("sigma": [^,]+),\s+("unit": "[^"]+")\s+\}/g, "{$1, $2}"));

/**
 * Draws the curve with a band of two standard errors; few points are drawn separately, as nothing is known between them.
 * @param {CanvasRenderingContext2D} context
 * @param {number} width
 * @param {number} height
 * @param {Curve} curve
 */
function draw(context, width, height, {joint, driver, unit, valueUnit = "°", points, title = "deflection of " + joint}) {
  const box = {left: 52, right: width - 8, top: 30, bottom: height - 42};
  const reach = 1.05 * Math.max(1e-3, ...points.map(([, y, error]) => Math.abs(y) + 2 * error));
  const xs = points.map(([x]) => x), name = driver === "q" ? joint : driver === "tau" ? "tau_" + joint : driver;
  const few = points.length < 5, beside = few ? 0.5 : 0;
  const {x, y} = axes(context, box, [Math.min(...xs) - beside, Math.max(...xs) + beside], [-reach, reach],
    {title: title + " [" + valueUnit + "]", xLabel: name + (unit ? " [" + unit + "]" : "")});
  const path = (/** @type {number[][]} */ list) => {
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

/** @type {View} */
export const view = {
  place: 50, title: "Curves", about: "misfit",
  show: ({curves}, tools) => curves.length ? [
    element("p", {}, "The best of these curves, with a band of two standard errors. ", !curves.some(({evidence}) => evidence > 0)
      ? "Their evidence is below 0: no misfit is left for a curve to explain; they are drawn to show this."
      : tools.ownEffect ? "Turn one into a custom effect to see what it explains."
      : "The text below a curve is a model file with an expression that follows it: save it as model.json, then " +
        "naocal solve SET --model model.json -o result.json adds it as a custom effect."),
    element("div", {class: "grid"}, ...curves.map(curve => driverCurve(curve, tools)))] : null,
};
