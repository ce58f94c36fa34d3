// The joint by driver map, the best of its curves, and what else shows where something is left over.
import {make, button, empty} from "./elements.js";
import {figure, bestOf, mapHeight, drawMap, drawCurve} from "./canvas.js";
import {tenths, driverWords, short, waitingWords, withUnit} from "./words.js";
import {state} from "./state.js";
import {ownFrom} from "./own.js";
import {leftSections} from "./left.js";

export function showMap(parent, go) {
  const {questions} = state;
  if (!questions) {
    parent.replaceChildren(make("h1", {}, "What each joint's error depends on"), empty(waitingWords(state.fit), "How well would a curve of each joint explain the misfit?"));
    return;
  }
  const cells = questions.map;
  if (!cells.length) {
    parent.replaceChildren(make("h1", {}, "What each joint's error depends on"), empty("There is no map", "No joint of these captures moved enough for a curve."),
      ...leftSections(questions, go));
    return;
  }
  const best = bestOf(cells);
  const map = figure({
    height: mapHeight(cells), label: "evidence by joint and driver",
    draw: (context, width, height) => drawMap(context, width, height, cells),
  });
  parent.replaceChildren(
    make("h1", {}, "What each joint's error depends on"),
    make("p", {class: "soft"}, "How well a smooth curve of each joint (rows) over each thing that it may vary with (columns) " +
      "would explain what the model leaves over: the fuller its colour, the better. This looks beyond the known effects. ",
      make("b", {}, best.evidence > 0 ? "Best: " + best.joint + " over " + driverWords(best.driver) + " (evidence " + tenths(best.evidence) + ")."
        : "Here it is empty: nothing is left.")),
    map, make("h2", {}, "Curves"),
    make("p", {class: "soft"}, questions.curves.some(({evidence}) => evidence > 0)
      ? "The best curves with a band of two standard errors. Take one over as an effect of your own and see what it explains."
      : "Their evidence is below 0: nothing is left that a curve would explain. They are drawn so that you can see that."),
    make("div", {class: "grid"}, ...questions.curves.map(curve => curveFigure(curve, go))),
    ...leftSections(questions, go));
}

function curveFigure(curve, go) {
  const {joint, what} = curve;
  const drawn = figure({height: 250, label: joint + " over " + what,
    draw: (context, width, height) => drawCurve(context, width, height, curve)});
  return make("figure", {}, drawn, make("figcaption", {}, make("b", {}, joint + " over " + what), ": ± " +
    withUnit(short(curve.amplitude), curve.valueUnit) + ", evidence " + tenths(curve.evidence)),
    curve.evidence > 0 && curve.model ? button("Take over as an own effect", () => { ownFrom(curve.model.define[0]); go("own"); }, {class: "small"}) : null);
}
