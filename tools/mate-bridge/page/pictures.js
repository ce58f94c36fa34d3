// One picture with its corners: a ring where measured, a line to the cross where predicted.
import {on} from "./connection.js";
import {make} from "./elements.js";
import {figure, colours, enlargement, enlargedWords, drawCorner, doubtfulBelow} from "./canvas.js";
import {px, direction, pictureName, rms} from "./words.js";
import {state} from "./state.js";

// The corners of a picture in the layer shown: {u, v, du, dv, id, board, weight, picture}. Made once: there may be many.
const made = new WeakMap(); // by picture: corners and their rms, by layer
function lookedUp(picture) {
  if (!made.has(picture)) made.set(picture, {});
  const known = made.get(picture), layer = state.layer;
  if (!known[layer]) {
    const corners = picture.boards.flatMap(board => board.ids.map((id, i) => ({
      id, board: board.board, picture, u: board.measured[2 * i], v: board.measured[2 * i + 1],
      du: board[layer][2 * i], dv: board[layer][2 * i + 1], weight: board.weight ? board.weight[i] : 1,
    })));
    known[layer] = {corners, rms: rms(corners.map(({du, dv}) => Math.hypot(du, dv)))};
  }
  return known[layer];
}
export const cornersOf = picture => lookedUp(picture).corners;
export const pictureRms = picture => lookedUp(picture).rms;

export function cornerTip(corner) {
  return "board " + corner.board + ", corner " + corner.id + "\n" + pictureName(corner.picture) + "\npredicted " +
    px(Math.hypot(corner.du, corner.dv)) + " off: " + direction(corner.du, corner.dv) +
    (corner.weight < 1 ? "\n" + (corner.weight < doubtfulBelow ? "doubtful: " : "") + "counts " + Math.round(100 * corner.weight) + " %" : "");
}

const photographs = new Map(); // by address
let desk = 0; // other captures may have the same names: the address says which are meant
for (const kind of ["opened", "hello"]) on(kind, () => { photographs.clear(); ++desk; });

function photograph(picture, loaded) {
  if (!picture.kept) return null;
  const address = "picture/" + encodeURIComponent(picture.set) + "/" + picture.capture + "?" + desk;
  if (!photographs.has(address)) {
    const image = new Image();
    photographs.set(address, image);
    image.src = address;
    if (photographs.size > 60) photographs.delete(photographs.keys().next().value);
  }
  const image = photographs.get(address);
  if (!image.complete) image.addEventListener("load", loaded, {once: true});
  return image.complete && image.naturalWidth ? image : null;
}

export function pictureFigure(picture) {
  const caption = make("figcaption");
  const drawn = figure({
    height: width => width * picture.height / picture.width, label: "measured and predicted corners of " + pictureName(picture),
    draw: (context, width, height) => draw(context, width, height, picture, caption, () => drawn.redraw()),
  });
  return make("figure", {}, drawn, caption);
}

function draw(context, width, height, picture, caption, redraw) {
  const scale = width / picture.width, corners = cornersOf(picture), behind = photograph(picture, redraw);
  context.fillStyle = colours.panel;
  context.fillRect(0, 0, width, height);
  if (behind) context.drawImage(behind, 0, 0, width, height);
  context.strokeStyle = colours.line;
  context.strokeRect(0.5, 0.5, width - 1, height - 1);
  const enlarged = enlargement(corners.map(({du, dv}) => scale * Math.hypot(du, dv)), 0.06 * width);
  const targets = corners.map(corner => {
    const x = scale * (corner.u + 0.5), y = scale * (corner.v + 0.5);
    return {x, y, endX: x + scale * enlarged * corner.du, endY: y + scale * enlarged * corner.dv,
      doubtful: corner.weight < doubtfulBelow, tip: () => cornerTip(corner)};
  });
  if (behind) targets.forEach(target => drawCorner(context, target, true));
  targets.forEach(target => drawCorner(context, target, false));
  caption.replaceChildren(make("b", {}, px(pictureRms(picture)) + " rms"), ", " + enlargedWords(enlarged) + ": " +
    pictureName(picture) + ", " + (picture.boards.length === 1 ? "board " : "boards ") + picture.boards.map(({board}) => board).join(", "));
  return targets;
}
