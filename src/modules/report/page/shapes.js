// The figures of the boards.

function showShapes(parent) {
  at("overShapes").hidden = !(data.left.asGiven && data.left.asGiven.shapes.length);
  for (const {board} of data.left.asGiven ? data.left.asGiven.shapes : []) {
    const figure = parent.appendChild(element("figure")), caption = element("figcaption");
    canvasFigure(figure, width => width * boardPlan(data, leftModel, board).tall, (context, width, height) =>
      drawShape(context, width, height, boardPlan(data, leftModel, board), caption), "the shape of board " + board);
    figure.append(caption);
  }
}
