// Where the corners of each board lie beside where its file has them, seen by all its pictures together.
import {colours} from "./figure.js";
import {arrow, enlargedWords} from "./axes.js";
import {bold, chance, withError} from "./words.js";

// The board's corners as a model has them, with the room that they need.
export function boardPlan({left: models}, model, board) {
  const shape = models[model].shapes.find(one => one.board === board);
  const xs = shape.corners.map(({place}) => place[0]), ys = shape.corners.map(({place}) => place[1]);
  const left = Math.min(...xs), top = Math.max(...ys), wide = Math.max(...xs) - left, high = top - Math.min(...ys);
  const margin = 0.12 * Math.max(wide, high);
  return {...shape, margin, left: left - margin, top: top + margin, wide: wide + 2 * margin, tall: (high + 2 * margin) / (wide + 2 * margin)};
}

// The sheet with its outline, and how long a millimetre is drawn.
function drawSheet(context, width, height, {scale, margin, enlarged, millimetre}) {
  const edge = 0.35 * scale * margin;
  context.fillStyle = colours.panel;
  context.fillRect(edge, edge, width - 2 * edge, height - 2 * edge);
  context.strokeStyle = colours.soft;
  context.lineWidth = 1;
  context.strokeRect(edge, edge, width - 2 * edge, height - 2 * edge);
  const long = [10, 5, 2, 1, 0.5, 0.2, 0.1].find(one => one * enlarged * millimetre < 0.2 * width) || 0.1, end = width - edge - 10, y = height - edge - 8;
  context.fillStyle = colours.ink;
  context.fillRect(end - long * enlarged * millimetre, y, long * enlarged * millimetre, 2);
  context.textAlign = "right";
  context.textBaseline = "bottom";
  context.fillText(long + " mm off", end, y - 2);
}

export function drawShape(context, width, height, {board, corners, p, left, top, wide, margin}, caption) {
  const scale = width / wide, millimetre = scale / 1000, shown = 0.05 * width;
  const largest = Math.max(...corners.map(({off: [x, y, z]}) => Math.max(Math.hypot(x, y), Math.abs(z))));
  const enlarged = [500, 200, 100, 50, 20, 10, 5, 2].find(factor => factor * largest * millimetre <= shown) || 1;
  const {off, sigma} = corners.reduce((a, b) => Math.abs(a.off[2]) > Math.abs(b.off[2]) ? a : b);
  caption.replaceChildren(bold("board " + board), ": " + (p < 0.01
    ? "its shape is not as its file has it (" + chance(p) + "); furthest off the sheet: " + withError(off[2], sigma[2], "mm")
    : "no more than noise explains (" + chance(p) + ")"), "; " + enlargedWords(enlarged));
  drawSheet(context, width, height, {scale, margin, enlarged, millimetre});
  return corners.map(({id, place, off: [dx, dy, dz], sigma: [sx, sy, sz]}) => {
    const x = scale * (place[0] - left), y = scale * (top - place[1]);
    context.fillStyle = dz > 0 ? colours.orange : colours.blue;
    context.globalAlpha = Math.abs(dz) > 2 * sz ? 0.6 : 0.2;
    context.beginPath();
    context.arc(x, y, enlarged * millimetre * Math.abs(dz), 0, 7);
    context.fill();
    const certain = Math.hypot(dx / sx, dy / sy) > 2.5; // two numbers beside two standard errors of one
    context.globalAlpha = certain ? 1 : 0.35;
    arrow(context, colours.ink, certain ? 1.5 : 1, x, y, enlarged * millimetre * dx, -enlarged * millimetre * dy);
    context.globalAlpha = 1;
    return {x, y, tip: () => "corner " + id + "\nto the right " + withError(dx, sx, "mm") +
      "\nup the sheet " + withError(dy, sy, "mm") + "\noff the sheet " + withError(dz, sz, "mm")};
  });
}
