// What an effect would do to these captures were they perfect otherwise: arrows before and after refitting.

let imprint, imprintRank = 0;

function showImprint(parent) {
  const shown = data.candidates.filter(candidate => candidate.imprint);
  at("overImprint").hidden = !shown.length;
  if (!shown.length) return;
  shown.forEach(({label}) => at("imprintOf").append(element("option", "", label)));
  const cameras = Object.keys(data.cameras);
  const redrawn = cameras.map(camera => imprintFigure(parent, camera));
  const turn = step => {
    const own = shown[at("imprintOf").selectedIndex];
    imprint = own.imprint;
    const count = Math.max(1, ...cameras.map(camera => seenBy(camera).length));
    imprintRank = Math.max(0, Math.min(count - 1, imprintRank + step));
    at("imprintWords").textContent = imprintWords(own);
    at("imprintRank").textContent = imprintRank + 1 + " of " + count;
    at("larger").disabled = imprintRank === 0;
    at("smaller").disabled = imprintRank === count - 1;
    redrawn.forEach(redraw => redraw());
  };
  at("imprintOf").addEventListener("change", () => { imprintRank = 0; turn(0); });
  at("larger").addEventListener("click", () => turn(-1));
  at("smaller").addEventListener("click", () => turn(1));
  turn(0);
}

const seenBy = camera => imprint.pictures.filter(({picture}) => data.pictures[picture].camera === camera);

function imprintWords({label, imprint: {found, sizes, before, after, imitator}}) {
  const size = sizes.map(({name, value, unit}) => withUnit(name + " = " + short(value), unit)).join(", ");
  const swallowed = before > 0 ? Math.round(100 * (1 - Math.min(1, after / before))) : 0;
  return label + (found ? " as large as found (" : " as large as plausible (") + size + "): " + px(before) +
    " rms before, " + px(after) + " after refitting: the model would swallow " + swallowed + " % of it, " + imitator +
    " first.";
}

function imprintFigure(parent, camera) {
  const {width: full, height: tall} = data.cameras[camera], figure = parent.appendChild(element("figure"));
  const caption = element("figcaption");
  const redraw = canvasFigure(figure, width => width * tall / full, (context, width, height) => {
    const seen = imprint && seenBy(camera)[imprintRank];
    figure.hidden = !seen;
    return seen ? drawImprint(context, width, height, {seen, scale: width / full, caption, camera}) : [];
  }, "shifts of corners in the " + camera + " camera");
  figure.append(caption);
  return () => { figure.hidden = false; redraw(); };
}

function drawImprint(context, width, height, {seen, scale, caption, camera}) {
  context.fillStyle = colours.panel;
  context.fillRect(0, 0, width, height);
  const lengths = seen.corners.map(([, , du, dv]) => scale * Math.hypot(du, dv));
  const enlarged = enlargement(lengths, 0.1 * width);
  caption.replaceChildren(element("b", "", camera + " camera"), ", " + captureName(seen.picture) + ": " + px(seen.before) +
    " rms, " + px(seen.after) + " after refitting; " + enlargedWords(enlarged));
  return seen.corners.map(([u, v, du, dv, left, down]) => {
    const x = scale * (u + 0.5), y = scale * (v + 0.5);
    arrow(context, colours.orange, 3, x, y, scale * enlarged * du, scale * enlarged * dv);
    arrow(context, colours.blue, 1.5, x, y, scale * enlarged * left, scale * enlarged * down);
    return {x, y, tip: () => captureName(seen.picture) + "\nshifted by " + direction([du, dv]) + "\nafter refitting " +
      direction([left, down])};
  });
}
