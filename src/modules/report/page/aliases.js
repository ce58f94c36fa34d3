// How much alike the first candidates are, as a heat map; those that cannot be told from one another stand together.

function showAliases(parent) {
  at("overAliases").hidden = !data.aliases || data.aliases.candidates.length < 2;
  if (at("overAliases").hidden) return;
  at("aliasWords").textContent = data.aliases.sentence;
  const order = classesTogether(data.aliases);
  canvasFigure(parent, width => aliasSides(width, order.length).top + order.length * aliasSides(width, order.length).high,
    (context, width) => drawAliases(context, width, order), "correlation of the first candidates");
}

// Candidates' places: behind each that was added those that the captures cannot tell from it.
function classesTogether({candidates, confusable}) {
  const order = new Set();
  candidates.forEach((label, i) => {
    order.add(i);
    confusable.filter(([taken]) => taken === label).forEach(([, other]) => order.add(candidates.indexOf(other)));
  });
  return [...order];
}

const aliasSides = (width, count) => ({
  left: Math.min(230, 0.5 * width), top: 20,
  high: Math.max(15, Math.min(30, (width - Math.min(230, 0.5 * width)) / count)),
});

function drawAliases(context, width, order) {
  const {candidates, correlations, confusable} = data.aliases;
  const {left, top, high} = aliasSides(width, order.length), wide = Math.min(60, (width - left - 2) / order.length);
  const outlined = (a, b) => confusable.some(([x, y]) => x === candidates[a] && y === candidates[b] ||
    y === candidates[a] && x === candidates[b]);
  const targets = [];
  context.textBaseline = "middle";
  order.forEach((a, row) => {
    const y = top + row * high;
    context.fillStyle = colours.soft;
    context.textAlign = "right";
    context.fillText(fitting(context, candidates[a], left - 34), left - 28, y + high / 2);
    context.fillText(row + 1, left - 8, y + high / 2);
    context.textAlign = "center";
    context.fillText(row + 1, left + (row + 0.5) * wide, top / 2);
    order.slice(0, row + 1).forEach((b, column) => {
      const x = left + column * wide, alike = correlations[a][b];
      context.fillStyle = colours.panel;
      context.fillRect(x, y, wide - 1, high - 1);
      context.fillStyle = a === b ? colours.line : colours.blue;
      context.globalAlpha = a === b ? 1 : 0.9 * alike ** 3;
      context.fillRect(x, y, wide - 1, high - 1);
      context.globalAlpha = 1;
      if (a === b) return;
      if (wide > 34) {
        context.fillStyle = alike > 0.85 ? colours.paper : colours.soft;
        context.fillText(alike.toFixed(2), x + wide / 2, y + high / 2);
      }
      if (outlined(a, b)) {
        context.strokeStyle = colours.orange;
        context.lineWidth = 2;
        context.strokeRect(x + 1, y + 1, wide - 3, high - 3);
      }
      targets.push({x: x + wide / 2, y: y + high / 2, tip: () => candidates[a] + "\nand " + candidates[b] +
        "\ncorrelation " + Number(alike.toFixed(3)) + (outlined(a, b) ? ": cannot be told apart here" : "")});
    });
  });
  return targets;
}

// As much of a text's start as has room.
function fitting(context, text, room) {
  if (context.measureText(text).width <= room) return text;
  let end = text.length;
  while (end > 1 && context.measureText(text.slice(0, end) + "…").width > room) --end;
  return text.slice(0, end) + "…";
}
