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
    const count = Math.max(1, ...cameras.map(camera => pagesOf(camera).length));
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

// The pictures of a camera, a page after the other: one on each, or several where they show few corners.
function pagesOf(camera) {
  const pages = [], few = 12;
  for (const seen of imprint.pictures.filter(({picture}) => data.pictures[picture].camera === camera)) {
    const last = pages[pages.length - 1];
    if (last && last.reduce((sum, {corners}) => sum + corners.length, 0) + seen.corners.length <= few) last.push(seen);
    else pages.push([seen]);
  }
  return pages;
}

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
    const seen = imprint && pagesOf(camera)[imprintRank];
    figure.hidden = !seen;
    return seen ? drawImprint(context, width, height, {seen, scale: width / full, caption, camera}) : [];
  }, "shifts of corners in the " + camera + " camera");
  figure.append(caption);
  return () => { figure.hidden = false; redraw(); };
}

function drawImprint(context, width, height, {seen, scale, caption, camera}) {
  context.fillStyle = colours.panel;
  context.fillRect(0, 0, width, height);
  const corners = seen.flatMap(one => one.corners.map(corner => ({picture: one.picture, corner})));
  const enlarged = enlargement(corners.map(({corner: [, , du, dv]}) => scale * Math.hypot(du, dv)), 0.1 * width);
  const over = value => px(Math.sqrt(mean(seen.map(one => value(one) ** 2))));
  caption.replaceChildren(element("b", "", camera + " camera"), ", " + (seen.length > 1 ? seen.length + " captures"
    : captureName(seen[0].picture)) + ": " + over(({before}) => before) + " rms, " + over(({after}) => after) +
    " after refitting; " + enlargedWords(enlarged));
  return corners.map(({picture, corner}) => {
    const [, , du, dv, left, down] = corner;
    return {...drawShift(context, scale, enlarged, corner), tip: () => captureName(picture) + "\nshifted by " +
      direction(du, dv) + "\nafter refitting " + direction(left, down)};
  });
}
