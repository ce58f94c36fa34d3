// Puts the page about an evaluation together: success over the tolerance, and each joint's errors before and after.

const solverColour = {ours: "blue", lm: "orange", "lm-random-starts": "pink"};
const solverWords = {ours: "ours", lm: "plain Levenberg-Marquardt", "lm-random-starts": "from random starts"};
const percent = share => (100 * share).toFixed(1) + " %";

function drawSuccess(context, width, height, {solvers, thesis}) {
  const box = {left: 40, right: width - 8, top: 26, bottom: height - 42};
  const last = data.tolerances[data.tolerances.length - 1];
  const {x, y} = axes(context, box, [0, last], [0, 100], {title: "success [%]", xLabel: "tolerance of every offset [°]"});
  const targets = [];
  const curve = (shares, words) => {
    context.beginPath();
    shares.forEach((share, i) => {
      const [a, b] = [x(data.tolerances[i]), y(100 * share)];
      if (i) context.lineTo(a, b); else context.moveTo(a, b);
      targets.push({x: a, y: b, tip: () => words + ": " + percent(share) + " within " + data.tolerances[i] + "°"});
    });
    context.stroke();
  };
  for (const {solver, success, limit} of solvers.filter(each => solverColour[each.solver])) {
    context.strokeStyle = colours[solverColour[solver]];
    context.lineWidth = 2;
    curve(success, solverWords[solver]);
    if (solver === "ours") {
      context.strokeStyle = colours.soft;
      context.lineWidth = 1.5;
      context.setLineDash([5, 4]);
      curve(limit, "the limit");
      context.setLineDash([]);
    }
  }
  if (thesis !== null) {
    context.fillStyle = getComputedStyle(document.body).color;
    const point = {x: x(data.thesisTolerance), y: y(100 * thesis)};
    context.beginPath();
    context.arc(point.x, point.y, 4, 0, 7);
    context.fill();
    targets.push({...point, tip: () => "the thesis: " + percent(thesis)});
  }
  return targets;
}

// The outlines of histograms, each to its own height: errors after are hundreds of times narrower than before.
function drawErrors(context, width, height, {before, solvers}) {
  const box = {left: 46, right: width - 8, top: 26, bottom: height - 42};
  const {x, y} = axes(context, box, [-7, 7], [0, 1.05], {title: "of the highest bar", xLabel: "[°]"});
  const targets = [];
  const outline = (histogram, colour, words, filled) => {
    const {counts, first, width: wide} = histogram;
    const all = counts.reduce((a, b) => a + b, 0), shares = counts.map(count => count / (Math.max(...counts) || 1));
    context.fillStyle = context.strokeStyle = colour;
    context.lineWidth = 1.5;
    context.beginPath();
    context.moveTo(x(first), y(0));
    shares.forEach((share, i) => {
      context.lineTo(x(first + i * wide), y(share));
      context.lineTo(x(first + (i + 1) * wide), y(share));
      if (share > 0) targets.push({x: x(first + (i + 0.5) * wide), y: y(share), tip: () => words + ", " +
        tenths(first + i * wide) + "° to " + tenths(first + (i + 1) * wide) + "°: " + percent(counts[i] / all)});
    });
    context.lineTo(x(first + shares.length * wide), y(0));
    if (filled) {
      context.globalAlpha = 0.25;
      context.fill();
      context.globalAlpha = 1;
    } else {
      context.stroke();
    }
  };
  outline(before, colours.soft, "before", true);
  for (const each of solvers) outline(each, colours[solverColour[each.solver]], "after, " + solverWords[each.solver], false);
  return targets;
}

function fill(parent, figures, heightOf, draw) {
  parent.replaceChildren();
  for (const each of figures) {
    const figure = parent.appendChild(element("figure"));
    canvasFigure(figure, heightOf, (context, width, height) => draw(context, width, height, each), each.name);
    figure.appendChild(element("figcaption")).append(element("b", "", each.name));
  }
}

function choice(select, names, show) {
  names.forEach((name, i) => select.add(new Option(name, i)));
  select.addEventListener("change", () => show(Number(select.value)));
  select.value = names.length - 1; // what is hardest comes last
  show(names.length - 1);
}

at("verdict").classList.add("good");
showVerdict(data.sentence, data.warnings);
choice(at("table"), data.tables.map(table => table.name),
  i => fill(at("success"), data.tables[i].cells, () => 250, drawSuccess));
choice(at("setting"), data.settings.map(setting => setting.name),
  i => fill(at("errors"), data.settings[i].joints, () => 230, drawErrors));
