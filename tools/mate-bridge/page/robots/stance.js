// Posture of a robot, from its right side and the front, with the next pose as an outline.
import {contextOf} from "naocal/lib/dom.js";
import {colours, figure} from "naocal/lib/figure.js";

// `now` and `next`: the bridge's forward kinematics ({hull: [[from, to, radius]], feet, ..}), or null.
export const standingFigure = (of, label, height = 230) => figure({height, label, className: "standing", draw: (context, width, height) => {
  const {now, next} = of();
  const scale = (height - 26) / 0.62, floor = height - (height > 150 ? 20 : 4);
  context.strokeStyle = colours.line;
  context.lineWidth = 1;
  context.beginPath();
  context.moveTo(0, floor + 0.5);
  context.lineTo(width, floor + 0.5);
  context.stroke();
  context.textAlign = "center";
  context.textBaseline = "bottom";
  context.fillStyle = colours.soft;
  for (const {middle, across, words} of [{middle: 0.27 * width, across: 0, words: "right side"}, {middle: 0.76 * width, across: 1, words: "front"}]) {
    if (height > 150) context.fillText(words, middle, height);
    const place = point => [middle + scale * (across ? point[1] : point[0]), floor - scale * point[2]];
    if (now) body(context, now.hull, place, scale, {colour: colours.soft, alpha: 0.5, outlined: false});
    if (now) gaze(context, now, place, colours.soft);
    if (next) body(context, next.hull, place, scale, {colour: colours.blue, alpha: now ? 1 : 0.65, outlined: Boolean(now)});
    if (next) gaze(context, next, place, colours.blue);
  }
  return [];
}});

// Viewing direction of the head.
function gaze(context, {gaze: line}, place, colour) {
  if (!line) return;
  context.strokeStyle = colour;
  context.lineWidth = 2;
  context.beginPath();
  context.moveTo(...place(line[0]));
  context.lineTo(...place(line[1]));
  context.stroke();
}

// Draws capsules as thick strokes on a separate canvas, so that overlaps do not darken; an outline erases the inside.
// SVG has no such canvas.
function body(context, hull, place, scale, {colour, alpha, outlined}) {
  const own = context.isVector ? context : sheetOver(context);
  if (context.isVector) own.globalAlpha = outlined ? 0.4 : alpha;
  own.strokeStyle = colour;
  own.lineCap = "round";
  const strokes = thinner => {
    for (const [from, to, radius] of hull) {
      own.lineWidth = Math.max(0.5, 2 * radius * scale - thinner);
      own.beginPath();
      own.moveTo(...place(from));
      own.lineTo(...place(to).map((value, i) => i ? value : value + 0.01)); // a sphere becomes a short stroke
      own.stroke();
    }
  };
  strokes(0);
  own.globalAlpha = 1;
  if (context.isVector) return;
  if (outlined) {
    own.globalCompositeOperation = "destination-out";
    strokes(4);
  }
  context.save();
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.globalAlpha = alpha;
  context.drawImage(own.canvas, 0, 0);
  context.restore();
}

function sheetOver({canvas}) {
  const sheet = document.createElement("canvas"), ratio = canvas.width / canvas.clientWidth || 1;
  Object.assign(sheet, {width: canvas.width, height: canvas.height});
  const context = contextOf(sheet);
  context.scale(ratio, ratio);
  return context;
}
