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
  canvasFigure(figure, 280, (context, width, height) =>
    drawAdded(context, width, height, candidate.added, point => pointTip(point, candidate)), "what each pose says about " + candidate.label);
  figure.appendChild(element("figcaption")).append(element("b", "", candidate.label), ": " + addedWords(candidate.added));
  return figure;
}

const slopeWords = ({of, unit}, slope, sigma) =>
  withUnit(of + " = " + withError(slope, sigma), unit || (of === "size" ? "times what was found" : ""));

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

function pointTip([pose, a, b], {label, added}) {
  return poseTip(pose) + "\n" + label + " from this pose alone: " + slopeWords(added, b / a, 1 / Math.abs(a)) + "\nit moves the pose " +
    (a < 0 ? "against" : "in") + " the sense of " + added.like;
}
