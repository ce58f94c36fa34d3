// What is left within the pictures once each may move as a whole: over the picture of each camera, and over range.

function showWithin(fields, ranges) {
  const shown = data.left.asGiven && data.left.asGiven.within.cells.length;
  at("overWithin").hidden = !shown;
  if (!shown) return;
  for (const [camera, {width: full, height: tall}] of Object.entries(data.cameras)) {
    const figure = fields.appendChild(element("figure")), caption = element("figcaption");
    canvasFigure(figure, width => width * tall / full, (context, width, height) =>
      drawWithin(context, width, height, {camera, scale: width / full, caption}), "what is left in the " + camera + " camera");
    figure.append(caption);
  }
  const caption = element("figcaption");
  canvasFigure(ranges, 300, (context, width, height) => drawRanges(context, width, height, caption),
    "what is left over the distance of boards");
  ranges.append(caption);
}

function drawWithin(context, width, height, {camera, scale, caption}) {
  const cells = data.left[leftModel].within.cells.filter(cell => cell.camera === camera);
  context.fillStyle = colours.panel;
  context.fillRect(0, 0, width, height);
  const enlarged = enlargement(cells.map(({du, dv}) => scale * Math.hypot(du, dv)), 0.05 * width);
  const sure = cells.filter(({du, dv, sigma}) => Math.hypot(du, dv) > 3 * sigma);
  caption.replaceChildren(element("b", "", camera + " camera"), ": " + sure.length + " of " + cells.length +
    " places are off by more than 3 standard errors (by chance 1 in 100); " + enlargedWords(enlarged));
  return cells.map(cell => {
    const x = scale * (cell.u + 0.5), y = scale * (cell.v + 0.5), certain = sure.includes(cell);
    arrow(context, certain ? colours.orange : colours.soft, certain ? 2.5 : 1, x, y, scale * enlarged * cell.du,
      scale * enlarged * cell.dv);
    return {x, y, tip: () => cell.corners + " corners, in the mean predicted " + direction(cell.du, cell.dv) + " (± " +
      px(cell.sigma) + ")\nlargest: " + captureName(cell.worst)};
  });
}

function drawRanges(context, width, height, caption) {
  const {boards: seen, noise} = data.left[leftModel].within, tones = ["blue", "orange", "pink", "soft"];
  const boards = [...new Set(seen.map(({board}) => board))].sort();
  const highest = 1.08 * Math.max(2 * noise, quantile(seen.map(({rms}) => rms), 0.98));
  const distances = seen.map(({distance}) => distance), low = Math.min(...distances), high = Math.max(...distances);
  const margin = 0.03 * (high - low || 1), box = {left: 46, right: width - 8, top: 30, bottom: height - 42};
  const {x, y, line} = axes(context, box, [low - margin, high + margin], [0, highest],
    {title: "left of a corner, per axis [px]", xLabel: "distance of the board from the camera [m]"});
  context.setLineDash([6, 4]);
  context.strokeStyle = colours.soft;
  line(box.left, y(noise), box.right, y(noise));
  context.setLineDash([]);
  caption.replaceChildren("Each dot is a board in a picture:", ...boards.flatMap((board, i) => {
    const key = element("span", "key dot");
    key.style.background = "var(--" + tones[i % tones.length] + ")";
    return ["  ", key, " " + board];
  }), "; dashed: the noise that the diagnosis reckons with (" + px(noise) + ").");
  return seen.map(({picture, board, distance, rms}) => {
    const target = {x: x(distance), y: y(Math.min(rms, highest)), beyond: rms > highest ? -1 : 0};
    context.fillStyle = colours[tones[boards.indexOf(board) % tones.length]];
    context.globalAlpha = 0.75;
    dot(context, target);
    context.globalAlpha = 1;
    return {...target, tip: () => "board " + board + " in " + captureName(picture) + "\n" + px(rms) + " per axis at " +
      distance.toFixed(2) + " m"};
  });
}
