// Mean errors against something that was recorded: to the right and down, side by side or one above the other.

// valueOf(picture) is the number on the x axis, or undefined.
function showTrend(parent, valueOf, xLabel, label) {
  return canvasFigure(parent, width => width > 700 ? 320 : 560, (context, width, height) => {
    const points = boardViews.filter(view => valueOf(view.picture) !== undefined)
      .map(view => ({view, x: valueOf(view.picture), error: meanError(view.corners)}));
    if (!points.length) return [];
    const boxes = width > 700
      ? [{left: 45, right: width / 2 - 15, top: 30, bottom: height - 45}, {left: width / 2 + 45, right: width - 5, top: 30, bottom: height - 45}]
      : [{left: 45, right: width - 5, top: 30, bottom: height / 2 - 45}, {left: 45, right: width - 5, top: height / 2 + 30, bottom: height - 45}];
    const highest = 1.15 * Math.max(quantile(points.flatMap(point => point.error.map(Math.abs)), 0.98), 1e-3);
    return boxes.flatMap((box, side) => drawTrend(context, box, points, side, highest, xLabel()));
  }, label);
}

function drawTrend(context, box, points, side, highest, xLabel) {
  const all = points.map(point => point.x), low = Math.min(...all), high = Math.max(...all), margin = 0.03 * (high - low || 1);
  const {x, y, line} = axes(context, box, [low - margin, high + margin], [-highest, highest],
    {title: side === 0 ? "predicted too far to the right [px]" : "predicted too far down [px]", xLabel});
  context.fillStyle = colours.measured;
  context.globalAlpha = points.length > 1000 ? 0.4 : 0.65;
  const targets = points.map(point => {
    const value = point.error[side], beyond = Math.abs(value) > highest;
    const at = {x: x(point.x), y: y(Math.max(-highest, Math.min(highest, value))), picture: point.view.picture,
      tip: () => pictureName(point.view.picture) + "\nboard " + point.view.board + ": predicted " +
        direction(point.error) + " on average" + (xLabel ? "\n" + xLabel + ": " + Number(point.x.toFixed(2)) : "")};
    context.beginPath();
    if (beyond) triangle(context, at, Math.sign(value)); else context.arc(at.x, at.y, 2.5, 0, 7);
    context.fill();
    return at;
  });
  context.globalAlpha = 1;
  context.strokeStyle = context.fillStyle = colours.predicted;
  context.lineWidth = 2;
  const stretches = binned(points, side, low, high);
  stretches.forEach((bin, i) => {
    line(x(bin.x), y(bin.y - 2 * bin.error), x(bin.x), y(bin.y + 2 * bin.error));
    if (i) line(x(stretches[i - 1].x), y(stretches[i - 1].y), x(bin.x), y(bin.y));
    context.fillRect(x(bin.x) - 3, y(bin.y) - 3, 6, 6);
  });
  return targets;
}

// A point beyond the axis lies at its end and points outwards.
function triangle(context, {x, y}, sign) {
  context.moveTo(x - 4, y + 2 * sign);
  context.lineTo(x + 4, y + 2 * sign);
  context.lineTo(x, y - 5 * sign);
}

// Means over stretches of x and their standard errors, doubtful corners left out.
function binned(points, side, low, high) {
  const count = 10, bins = Array.from({length: count}, () => []);
  for (const point of points) {
    const trusted = point.view.corners.filter(corner => corner.weight >= doubtfulBelow);
    if (!trusted.length) continue;
    const bin = Math.min(count - 1, Math.floor(count * (point.x - low) / (high - low || 1)));
    bins[bin].push({x: point.x, y: meanError(trusted)[side]});
  }
  return bins.filter(bin => bin.length >= 4).map(bin => {
    const y = mean(bin.map(point => point.y));
    const variance = mean(bin.map(point => (point.y - y) ** 2)) * bin.length / (bin.length - 1);
    return {x: mean(bin.map(point => point.x)), y, error: Math.sqrt(variance / bin.length)};
  });
}
