// Floor plan: feet, detected boards, and the field of view of each camera.
import {colours, figure} from "naocal/lib/figure.js";

const ahead = 1.9, behind = 0.3, aside = 1.1; // extent of the plan, from the robot [m]

export const floorFigure = of => figure({height: width => Math.min(400, width * (ahead + behind) / (2 * aside)), label: "plan of the floor", className: "floor",
  draw: (context, width, height) => draw(context, width, height, of())});

function draw(context, width, height, scene) {
  const scale = Math.min(height / (ahead + behind), width / (2 * aside)), originX = width / 2, originY = height - behind * scale;
  const place = ([x, y]) => [originX - scale * y, originY - scale * x]; // robot frame: x up, y to the left
  const outline = points => {
    context.beginPath();
    points.forEach((point, i) => i ? context.lineTo(...place(point)) : context.moveTo(...place(point)));
    context.closePath();
  };
  drawGrid(context, width, place);
  if (!scene) return [];
  context.save();
  context.beginPath();
  context.rect(0, 0, width, height);
  context.clip();
  drawViews(context, scene.views, outline);
  const targets = scene.boards.map(board => drawBoard(context, board, place, outline));
  drawFeet(context, scene.feet, outline);
  targets.push(drawCentre(context, scene, place));
  context.restore();
  return targets;
}

/** A line every half metre ahead. */
function drawGrid(context, width, place) {
  context.strokeStyle = colours.line;
  context.fillStyle = colours.soft;
  context.lineWidth = 1;
  context.textBaseline = "bottom";
  context.textAlign = "left";
  for (let metres = 0; metres <= ahead; metres += 0.5) {
    const height = place([metres, 0])[1];
    context.beginPath();
    context.moveTo(0, height);
    context.lineTo(width, height);
    context.stroke();
    context.fillText(metres + " m", 4, height - 2);
  }
}

function drawViews(context, views, outline) {
  for (const [camera, colour] of [["top", colours.blue], ["bottom", colours.orange]]) {
    if (!views[camera]) continue;
    outline(views[camera]);
    context.strokeStyle = context.fillStyle = colour;
    context.globalAlpha = 0.08;
    context.fill();
    context.globalAlpha = 1;
    context.lineWidth = 1.5;
    context.setLineDash(camera === "top" ? [] : [5, 4]);
    context.stroke();
    context.setLineDash([]);
  }
}

function drawFeet(context, feet, outline) {
  context.fillStyle = context.strokeStyle = colours.soft;
  for (const foot of Object.values(feet)) {
    outline(foot);
    context.globalAlpha = 0.6;
    context.fill();
    context.globalAlpha = 1;
  }
}

function drawCentre(context, {centre, carries}, place) {
  const [x, y] = place(centre);
  context.strokeStyle = colours.pink;
  context.lineWidth = 2;
  context.beginPath();
  context.arc(x, y, 4, 0, 7);
  context.stroke();
  return {x, y, tip: () => "its centre of mass, above " + (carries === "both" ? "both feet" : "the " + carries + " foot")};
}

function drawBoard(context, {id, columns, rows, square, x, y, yaw}, place, outline) {
  const on = (a, b) => [x + Math.cos(yaw) * a * square + Math.sin(yaw) * b * square, y + Math.sin(yaw) * a * square - Math.cos(yaw) * b * square];
  const cell = (a, b) => outline([on(a, b), on(a + 1, b), on(a + 1, b + 1), on(a, b + 1)]);
  outline([on(0, 0), on(columns, 0), on(columns, rows), on(0, rows)]);
  context.fillStyle = "#fff";
  context.fill();
  context.fillStyle = "#222";
  for (let a = 0; a < columns; ++a) for (let b = 0; b < rows; ++b) if ((a + b) % 2 === 0) { cell(a, b); context.fill(); }
  context.strokeStyle = "#222";
  context.lineWidth = 1;
  outline([on(0, 0), on(columns, 0), on(columns, rows), on(0, rows)]);
  context.stroke();
  const [left, top] = place(on(columns / 2, rows / 2));
  context.font = "bold 13px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.lineWidth = 4;
  context.strokeStyle = "#fff";
  context.strokeText(id, left, top);
  context.fillStyle = "#0072b2";
  context.fillText(id, left, top);
  return {x: left, y: top, tip: () => "board " + id + "\n" + x.toFixed(2) + " m ahead, " + Math.abs(y).toFixed(2) + " m to the " + (y < 0 ? "right" : "left")};
}
