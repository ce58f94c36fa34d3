// Pictures with measured and predicted corners, a page at a time.

const picturesPerPage = 6;
const slots = []; // {show(picture)}
let firstShown = 0;

const orderedPictures = () => document.getElementById("order").value === "time"
  ? byTime : [...data.pictures].sort((a, b) => rms(b.corners) - rms(a.corners));

// A picture's place on the page: it keeps its canvas while other pictures are shown in it.
function pictureSlot(parent) {
  const figure = parent.appendChild(element("figure"));
  let picture, photograph;
  const redraw = canvasFigure(figure, width => picture ? width * picture.height / picture.width : 0,
    (context, width) => picture ? drawPicture(context, width) : [], "a picture with measured and predicted corners");
  const caption = figure.appendChild(element("figcaption"));

  function drawPicture(context, width) {
    const scale = width / picture.width, height = scale * picture.height;
    context.fillStyle = colours.panel;
    context.fillRect(0, 0, width, height);
    if (photograph && photograph.complete) context.drawImage(photograph, 0, 0, width, height);
    context.strokeStyle = colours.line;
    context.strokeRect(0.5, 0.5, width - 1, height - 1);
    const lengths = picture.corners.map(corner => scale * lengthOf(corner[layer]));
    const enlarged = enlargement(lengths, 0.06 * width);
    const targets = picture.corners.map(corner => cornerTarget(corner, scale, enlarged));
    if (photograph) targets.forEach(target => drawCorner(context, target, true));
    targets.forEach(target => drawCorner(context, target, false));
    caption.replaceChildren(element("b", "", px(rms(picture.corners)) + " rms"), ", " + enlargedWords(enlarged) + ": " +
      pictureName(picture) + ", " + (picture.boards.length === 1 ? "board " : "boards ") +
      picture.boards.map(view => view.board).join(", "));
    return targets;
  }
  return {
    figure,
    show(next) {
      picture = next;
      figure.hidden = !picture;
      photograph = undefined;
      if (picture && picture.photograph) {
        photograph = new Image();
        photograph.onload = redraw;
        photograph.src = picture.photograph;
      }
      redraw();
    },
  };
}

function cornerTarget(corner, scale, enlarged) {
  const [du, dv] = corner[layer], x = scale * (corner.u + 0.5), y = scale * (corner.v + 0.5);
  return {
    x, y, endX: x + scale * enlarged * du, endY: y + scale * enlarged * dv,
    doubtful: corner.weight < doubtfulBelow, click: () => showPicture(corner.picture), tip: () => cornerTip(corner),
  };
}

function cornerTip(corner) {
  const weight = corner.weight < doubtfulBelow ? "\ndoubtful: counts " + Math.round(100 * corner.weight) + " %"
    : corner.weight < 1 ? "\ncounts " + Math.round(100 * corner.weight) + " %" : "";
  return "board " + corner.board + ", corner " + corner.id + " at (" + corner.u.toFixed(1) + ", " + corner.v.toFixed(1) +
    ")\n" + pictureName(corner.picture) + "\npredicted " + px(lengthOf(corner[layer])) + " off: " +
    direction(...corner[layer]) + weight;
}

function showPage() {
  const ordered = orderedPictures();
  firstShown = Math.max(0, Math.min(firstShown, ordered.length - 1));
  slots.forEach((slot, i) => slot.show(ordered[firstShown + i]));
  const last = Math.min(firstShown + picturesPerPage, ordered.length);
  document.getElementById("page").textContent = (firstShown + 1) + "–" + last + " of " + ordered.length;
  document.getElementById("previous").disabled = firstShown === 0;
  document.getElementById("next").disabled = last === ordered.length;
}

function turnPage(pages) {
  firstShown += pages * picturesPerPage;
  showPage();
}

// Brings one picture into view, wherever it was pointed at.
function showPicture(picture) {
  const place = orderedPictures().indexOf(picture);
  firstShown = place - place % picturesPerPage;
  showPage();
  slots[place % picturesPerPage].figure.scrollIntoView({block: "center"});
}
