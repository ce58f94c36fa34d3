// Mean errors against something that was recorded: to the right and down, side by side or one above the other.

// valueOf(picture) is the number on the x axis, or undefined; pictures of one groupOf(picture) are not independent.
function showTrend(parent, {valueOf, groupOf, xLabel, label}) {
  return canvasFigure(parent, width => width > 700 ? 320 : 560, (context, width, height) => {
    const points = trendPoints(valueOf, groupOf);
    if (!points.length) return [];
    const beside = width > 700, [middleX, middleY] = beside ? [width / 2, 0] : [0, height / 2];
    const boxes = [
      {left: 45, right: beside ? middleX - 15 : width - 5, top: 30, bottom: (middleY || height) - 45},
      {left: middleX + 45, right: width - 5, top: middleY + 30, bottom: height - 45},
    ];
    const highest = 1.15 * Math.max(quantile(points.flatMap(point => point.error.map(Math.abs)), 0.98), 1e-3);
    return boxes.flatMap((box, side) => drawTrend(context, box, points, side, highest, xLabel()));
  }, label);
}

const trendPoints = (valueOf, groupOf) => boardViews.filter(view => valueOf(view.picture) !== undefined)
  .map(view => ({view, x: valueOf(view.picture), group: groupOf(view.picture), error: meanError(view.corners)}));

function drawTrend(context, box, points, side, highest, xLabel) {
  const all = points.map(point => point.x), low = Math.min(...all), high = Math.max(...all);
  const margin = 0.03 * (high - low || 1);
  const {x, y, line} = axes(context, box, [low - margin, high + margin], [-highest, highest],
    {title: side === 0 ? "predicted too far to the right [px]" : "predicted too far down [px]", xLabel});
  context.fillStyle = colours.blue;
  context.globalAlpha = points.length > 1000 ? 0.4 : 0.65;
  const targets = points.map(point => {
    const value = point.error[side];
    return {
      x: x(point.x), y: y(Math.max(-highest, Math.min(highest, value))),
      beyond: Math.abs(value) > highest ? -Math.sign(value) : 0,
      click: () => showPicture(point.view.picture),
      tip: () => pictureName(point.view.picture) + "\nboard " + point.view.board + ": predicted " +
        direction(...point.error) + " on average\n" + xLabel + ": " + Number(point.x.toFixed(2)),
    };
  });
  targets.forEach(target => dot(context, target));
  context.globalAlpha = 1;
  context.strokeStyle = context.fillStyle = colours.orange;
  context.lineWidth = 2;
  const means = stretches(points, side);
  means.forEach((mean, i) => {
    line(x(mean.x), y(mean.y - 2 * mean.error), x(mean.x), y(mean.y + 2 * mean.error));
    if (i) line(x(means[i - 1].x), y(means[i - 1].y), x(mean.x), y(mean.y));
    context.fillRect(x(mean.x) - 3, y(mean.y) - 3, 6, 6);
  });
  return targets;
}

// Means over stretches of x with equally many groups, and their standard errors from the spread between groups.
// Doubtful corners are left out.
function stretches(points, side) {
  const groups = new Map();
  for (const {view, x, group} of points) {
    const trusted = view.corners.filter(corner => corner.weight >= doubtfulBelow);
    if (!trusted.length) continue;
    if (!groups.has(group)) groups.set(group, []);
    groups.get(group).push({x, y: meanError(trusted)[side]});
  }
  const middle = list => ({x: mean(list.map(point => point.x)), y: mean(list.map(point => point.y))});
  const means = [...groups.values()].map(middle).sort((a, b) => a.x - b.x);
  const count = Math.max(1, Math.min(10, Math.floor(means.length / 4))), result = [];
  for (let i = 0; i < count && means.length >= 4; ++i) {
    const part = means.slice(Math.round(i * means.length / count), Math.round((i + 1) * means.length / count));
    const y = mean(part.map(point => point.y));
    const variance = part.reduce((sum, point) => sum + (point.y - y) ** 2, 0) / (part.length - 1);
    result.push({x: mean(part.map(point => point.x)), y, error: Math.sqrt(variance / part.length)});
  }
  return result;
}

// How many standard errors the stretches' means lie from zero, in the mean: what a trend or a step makes large.
function trendStrength(points) {
  const strength = side => {
    const means = stretches(points, side).filter(mean => mean.error > 0);
    return means.length ? mean(means.map(({y, error}) => (y / error) ** 2)) : 0;
  };
  return points.length ? Math.max(strength(0), strength(1)) : 0;
}
