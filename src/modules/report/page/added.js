// Added-variable plots: for each of the first candidates a point per pose, whose slope is the candidate's size.

const plotsFirst = 4, plotsMost = 10;
const twoDigits = value => short(Number(value.toPrecision(2)));

function showAdded(parent) {
  const plotted = data.candidates.filter(candidate => candidate.added).slice(0, plotsMost);
  at("overAdded").hidden = !plotted.length;
  const show = count => parent.replaceChildren(...plotted.slice(0, count).map(addedFigure));
  const more = at("moreAdded");
  let all = false;
  const turn = () => {
    show(all ? plotted.length : plotsFirst);
    more.textContent = all ? "show fewer" : "show all " + plotted.length;
  };
  more.hidden = plotted.length <= plotsFirst;
  more.addEventListener("click", () => { all = !all; turn(); });
  turn();
}

function addedFigure(candidate) {
  const figure = element("figure");
  canvasFigure(figure, () => 280, (context, width, height) => drawAdded(context, width, height, candidate),
    "what each pose says about " + candidate.label);
  figure.appendChild(element("figcaption")).append(element("b", "", candidate.label), ": " + addedWords(candidate.added));
  return figure;
}

const slopeWords = ({of, unit}, slope, sigma) =>
  withUnit(of + " = " + withError(slope, sigma, "").trim(), unit || (of === "size" ? "times what was found" : ""));

// The size, and how far it rests on one pose.
function addedWords(added) {
  const {slope, sigma, points} = added, strength = Math.abs(slope) / sigma;
  const without = points.map(([pose, x, y]) => {
    const squares = sigma ** -2 - x * x;
    return {pose, y: y - slope * x, slope: (slope / sigma ** 2 - x * y) / squares, sigma: squares > 0 ? squares ** -0.5 : Infinity};
  }).filter(({pose}) => pose !== null);
  const weakest = without.reduce((a, b) => Math.abs(a.slope) / a.sigma < Math.abs(b.slope) / b.sigma ? a : b);
  const left = Math.abs(weakest.slope) / weakest.sigma;
  const stray = Math.sqrt(mean(without.map(({y}) => y * y)));
  const words = slopeWords(added, slope, sigma) + ", " + twoDigits(strength) + " sigma from none; poses stray from the line by " +
    twoDigits(stray) + " sigma";
  if (strength < 2) return words + ": it lies flat.";
  return words + (left < strength / 2 ? "; " + poseName(weakest.pose) + " alone carries most of it: " : "; without " +
    poseName(weakest.pose) + ", which counts most, ") + twoDigits(left) + " sigma" + (left < strength / 2 ? " without it." : ".");
}

function drawAdded(context, width, height, {label, added}) {
  const {of, unit, slope, sigma, points, like} = added;
  const xs = [0, ...points.map(([, x]) => x)], ys = [0, ...points.map(([, , y]) => y)];
  const box = {left: 46, right: width - 8, top: 30, bottom: height - 42};
  const spread = (values, least) => {
    const low = Math.min(...values), high = Math.max(...values), margin = 0.06 * (high - low) + least;
    return [low - margin, high + margin];
  };
  const [left, right] = spread(xs, 1e-9), [bottom, top] = spread(ys, 1);
  const {x, y, line} = axes(context, box, [left, right], [bottom, top], {title: "measured that way [sigma]",
    xLabel: "what " + (of === "size" ? "the size found" : withUnit(of + " = 1", unit)) + " would do to the pose [sigma]"});
  context.save();
  context.beginPath();
  context.rect(box.left, box.top, box.right - box.left, box.bottom - box.top);
  context.clip();
  context.strokeStyle = context.fillStyle = colours.orange;
  for (const end of [left, right]) {
    context.globalAlpha = 0.2;
    context.beginPath();
    context.moveTo(x(0), y(0));
    context.lineTo(x(end), y(end * (slope - 2 * sigma)));
    context.lineTo(x(end), y(end * (slope + 2 * sigma)));
    context.fill();
    context.globalAlpha = 1;
  }
  context.lineWidth = 2;
  line(x(left), y(left * slope), x(right), y(right * slope));
  context.restore();
  context.strokeStyle = context.fillStyle = colours.blue;
  context.lineWidth = 1;
  return points.filter(([pose]) => pose !== null).map(([pose, a, b]) => {
    context.globalAlpha = 0.45;
    line(x(a), y(b - 1), x(a), y(b + 1));
    context.globalAlpha = 1;
    const target = {x: x(a), y: y(b)};
    dot(context, target);
    return {...target, tip: () => poseTip(pose) + "\n" + label + " from this pose alone: " +
      slopeWords(added, b / a, 1 / Math.abs(a)) + "\nit moves the pose " + (a < 0 ? "against" : "in") + " the sense of " + like};
  });
}
