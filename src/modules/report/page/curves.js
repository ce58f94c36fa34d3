// Joints' deflections as curves over what they vary with, and the expression that follows each.

function showCurves(parent) {
  at("overCurves").hidden = !data.curves.length;
  const telling = data.curves.filter(curve => curve.evidence > 0);
  at("curveWords").textContent = telling.length
    ? "Below a curve stands an expression that follows it, as a model file: save it as model.json, then " +
      "naocal solve SET --model model.json -o result.json adds it as an effect of your own."
    : "Their evidence is below 0: nothing is left that a curve would explain. They are drawn so that you can see that.";
  for (const curve of data.curves) {
    const figure = parent.appendChild(element("figure"));
    canvasFigure(figure, 250, (context, width, height) => drawCurve(context, width, height, curve),
      curve.joint + " over " + curve.what);
    const caption = figure.appendChild(element("figcaption"));
    caption.append(element("b", "", curve.joint + " over " + curve.what),
      ": ± " + withUnit(short(curve.amplitude), curve.valueUnit) + ", evidence " + tenths(curve.evidence));
    if (curve.evidence > 0 && curve.model) {
      figure.append(copyBox("like " + curve.expression, modelText(curve.model)));
    }
  }
}

// The model file, each unknown on one line.
const modelText = model =>
  JSON.stringify(model, null, 1).replace(/\{\s+("sigma": [^,]+),\s+("unit": "[^"]+")\s+\}/g, "{$1, $2}");
