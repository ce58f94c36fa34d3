// The figures of what is left within the pictures.

function showWithin(fields, ranges) {
  const shown = data.left.asGiven && data.left.asGiven.within.cells.length;
  at("overWithin").hidden = !shown;
  if (!shown) return;
  for (const [camera, {width: full, height: tall}] of Object.entries(data.cameras)) {
    const figure = fields.appendChild(element("figure")), caption = element("figcaption");
    canvasFigure(figure, width => width * tall / full, (context, width, height) =>
      drawWithin(context, width, height, {data, model: leftModel, camera, caption}), "what is left in the " + camera + " camera");
    figure.append(caption);
  }
  const caption = element("figcaption");
  canvasFigure(ranges, 300, (context, width, height) => drawRanges(context, width, height, {data, model: leftModel, caption}),
    "what is left over the distance of boards");
  ranges.append(caption);
}
