// A robot as it stands: from its left and from the front; another pose as an outline over it.
import {figure, colours} from "./canvas.js";

// `now` and `next`: what the bridge works out of angles ({hull: [[from, to, radius]], feet, ..}), or null.
export const standingFigure = (of, label) => figure({height: 230, label, className: "standing", draw: (context, width, height) => {
  const {now, next} = of();
  const scale = (height - 26) / 0.62, floor = height - 14;
  context.strokeStyle = colours.line;
  context.lineWidth = 1;
  context.beginPath();
  context.moveTo(0, floor + 0.5);
  context.lineTo(width, floor + 0.5);
  context.stroke();
  context.textAlign = "center";
  context.textBaseline = "top";
  context.fillStyle = colours.soft;
  for (const [middle, across, words] of [[0.27 * width, 0, "from its right"], [0.76 * width, 1, "from the front"]]) {
    context.fillText(words, middle, 2);
    const place = point => [middle + scale * (across ? point[1] : point[0]), floor - scale * point[2]];
    if (now) body(context, now.hull, place, scale, colours.soft, 0.55);
    if (next) body(context, next.hull, place, scale, colours.blue, 0.5);
  }
  return [];
}});

// Parts as strokes as broad as they are, on a sheet of their own so that overlapping ones do not darken each other.
function body(context, hull, place, scale, colour, alpha) {
  const own = context.isVector ? context : sheetOver(context);
  if (context.isVector) own.globalAlpha = alpha;
  own.strokeStyle = colour;
  own.lineCap = "round";
  for (const [from, to, radius] of hull) {
    own.lineWidth = 2 * radius * scale;
    own.beginPath();
    own.moveTo(...place(from));
    own.lineTo(...place(to).map((value, i) => i ? value : value + 0.01)); // a ball is a short stroke
    own.stroke();
  }
  own.globalAlpha = 1;
  if (context.isVector) return;
  context.save();
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.globalAlpha = alpha;
  context.drawImage(own.canvas, 0, 0);
  context.restore();
}

function sheetOver({canvas}) {
  const sheet = document.createElement("canvas"), ratio = canvas.width / canvas.clientWidth || 1;
  Object.assign(sheet, {width: canvas.width, height: canvas.height});
  const context = sheet.getContext("2d");
  context.scale(ratio, ratio);
  return context;
}
