// Errors over the image, one figure for each camera.

function showFields(parent) {
  for (const camera of [...new Set(data.pictures.map(picture => picture.camera))].sort()) {
    const own = corners.filter(corner => corner.picture.camera === camera);
    const {width: imageWidth, height: imageHeight} = own[0].picture;
    const figure = parent.appendChild(element("figure"));
    const caption = element("figcaption");
    canvasFigure(figure, width => width * imageHeight / imageWidth, (context, width, height) => {
      const lengths = own.map(corner => lengthOf(corner[layer]) * width / corner.picture.width);
      const enlarged = enlargement(lengths, 0.05 * width);
      caption.replaceChildren(element("b", "", camera + " camera"), ": " + own.length + " corners, " + px(rms(own)) +
        " rms, " + enlargedWords(enlarged));
      return drawField(context, width, height, own, enlarged);
    }, "errors over the image of the " + camera + " camera");
    figure.append(caption);
  }
}

function drawField(context, width, height, own, enlarged) {
  context.fillStyle = colours.panel;
  context.fillRect(0, 0, width, height);
  const targets = own.map(corner => cornerTarget(corner, width / corner.picture.width, enlarged));
  context.strokeStyle = colours.blue;
  context.globalAlpha = own.length > 2000 ? 0.35 : 0.6;
  context.lineWidth = 1;
  context.beginPath();
  for (const {x, y, endX, endY} of targets) { context.moveTo(x, y); context.lineTo(endX, endY); }
  context.stroke();
  context.globalAlpha = 1;
  for (const cell of cells(targets, width, height)) drawMean(context, cell);
  return targets;
}

// The middles of a grid's cells and their mean errors, where enough corners lie.
function cells(targets, width, height) {
  const columns = 8, rows = 6, fewest = 5, grid = new Map();
  for (const target of targets) {
    if (target.doubtful) continue;
    const key = Math.floor(target.x / width * columns) + columns * Math.floor(target.y / height * rows);
    if (!grid.has(key)) grid.set(key, []);
    grid.get(key).push(target);
  }
  return [...grid.values()].filter(list => list.length >= fewest).map(list => ({
    x: mean(list.map(target => target.x)), y: mean(list.map(target => target.y)),
    endX: mean(list.map(target => target.endX)), endY: mean(list.map(target => target.endY)),
  }));
}

function drawMean(context, {x, y, endX, endY}) {
  context.strokeStyle = context.fillStyle = colours.orange;
  context.lineWidth = 3;
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(endX, endY);
  context.stroke();
  context.beginPath();
  context.arc(x, y, 3, 0, 7);
  context.fill();
}
