// What is left within the pictures once each may move as a whole: over the picture of each camera, and over range.
import {colours} from "./figure.js";
import {arrow, axes, dot, enlargement, enlargedWords} from "./axes.js";
import {bold, direction, px, quantile} from "./words.js";
import {takenNames} from "./taken.js";

// In the mean over parts of a camera's picture.
export function drawWithin(context, width, height, {data, model, camera, caption}) {
  const scale = width / data.cameras[camera].width, {captureName} = takenNames(data);
  const cells = data.left[model].within.cells.filter(cell => cell.camera === camera);
  context.fillStyle = colours.panel;
  context.fillRect(0, 0, width, height);
  const enlarged = enlargement(cells.map(({du, dv}) => scale * Math.hypot(du, dv)), 0.05 * width);
  const sure = cells.filter(({du, dv, sigma}) => Math.hypot(du, dv) > 3 * sigma);
  caption.replaceChildren(bold(camera + " camera"), ": " + sure.length + " of " + cells.length +
    " places are off by more than 3 standard errors (by chance 1 in 100); " + enlargedWords(enlarged));
  return cells.map(cell => {
    const x = scale * (cell.u + 0.5), y = scale * (cell.v + 0.5), certain = sure.includes(cell);
    arrow(context, certain ? colours.orange : colours.soft, certain ? 2.5 : 1, x, y, scale * enlarged * cell.du,
      scale * enlarged * cell.dv);
    return {x, y, picture: cell.worst, tip: () => cell.corners + " corners, in the mean predicted " + direction(cell.du, cell.dv) + " (± " +
      px(cell.sigma) + ")\nlargest: " + captureName(cell.worst)};
  });
}

// Of each board in each picture, over its distance.
export function drawRanges(context, width, height, {data, model, caption}) {
  const {captureName} = takenNames(data);
  const {boards: seen, noise} = data.left[model].within, tones = ["blue", "orange", "pink", "soft"];
  const boards = [...new Set(seen.map(({board}) => board))].sort();
  const highest = 1.08 * Math.max(2 * noise, quantile(seen.map(({rms}) => rms), 0.98));
  const distances = seen.map(({distance}) => distance), low = Math.min(...distances), high = Math.max(...distances);
  const margin = 0.03 * (high - low || 1), box = {left: 46, right: width - 8, top: 30, bottom: height - 42};
  const {x, y, line} = axes(context, box, [low - margin, high + margin], [0, highest],
    {title: "left of a corner, per axis [px]", xLabel: "distance of the board from the camera [m]"});
  context.setLineDash([6, 4]);
  context.strokeStyle = colours.soft;
  line(box.left, y(noise), box.right, y(noise));
  context.setLineDash([]);
  caption.replaceChildren("Each dot is a board in a picture:", ...boards.flatMap((board, i) => {
    const key = document.createElement("span");
    key.className = "key dot";
    key.style.background = "var(--" + tones[i % tones.length] + ")";
    return ["  ", key, " " + board];
  }), "; dashed: the noise that the diagnosis reckons with (" + px(noise) + ").");
  return seen.map(({picture, board, distance, rms}) => {
    const target = {x: x(distance), y: y(Math.min(rms, highest)), beyond: rms > highest ? -1 : 0};
    context.fillStyle = colours[tones[boards.indexOf(board) % tones.length]];
    context.globalAlpha = 0.75;
    dot(context, target);
    context.globalAlpha = 1;
    return {...target, picture, tip: () => "board " + board + " in " + captureName(picture) + "\n" + px(rms) + " per axis at " +
      distance.toFixed(2) + " m"};
  });
}
