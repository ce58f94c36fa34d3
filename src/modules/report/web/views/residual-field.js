// Error fields over a camera's image: of all corners, and of the residuals after removing each picture's rigid motion.
import {bold, element, key} from "naocal/lib/dom.js";
import {captioned, colours, inProportion} from "naocal/lib/figure.js";
import {arrow, axes, dot, enlargement, enlargedWords, widened} from "naocal/lib/axes.js";
import {direction, px, short} from "naocal/lib/format.js";
import {extent, groupBy, mean, quantile} from "naocal/lib/statistics.js";
import {captureNames, cornersOf, errorOf, lengthOf} from "naocal/lib/captures.js";
import {cornerTargets} from "naocal/plots/corners.js";
import {modelChoice} from "naocal/views/model-choice.js";

/** @import {Diagnosis, Layer, Left, Picture, View} from "naocal/lib/types.js" */

/**
 * Errors of all corners over the image of one camera, and the mean per grid cell.
 * @param {Picture[]} pictures of that camera
 * @param {{layer: () => Layer, nameOf: (picture: Picture) => string, open?: (picture: Picture) => void}} options
 */
export function residualField(pictures, {layer, nameOf, open}) {
  const {camera} = pictures[0];
  return captioned({
    height: inProportion(pictures[0]), label: "errors over the image of the " + camera + " camera", open,
    draw: (context, width, height, caption) => {
      const corners = pictures.flatMap(picture => cornersOf(picture, layer()));
      const enlarged = enlargement(corners.map(corner => lengthOf(corner) * width / corner.picture.width), 0.05 * width);
      caption.replaceChildren(bold(camera + " camera"), ": " + corners.length + " corners, " + px(errorOf(corners)) + " rms, " + enlargedWords(enlarged));
      context.fillStyle = colours.panel;
      context.fillRect(0, 0, width, height);
      const targets = corners.flatMap(corner => cornerTargets([corner], width / corner.picture.width, enlarged, nameOf));
      context.strokeStyle = colours.blue;
      context.globalAlpha = corners.length > 2000 ? 0.35 : 0.6;
      context.lineWidth = 1;
      context.beginPath();
      for (const {x, y, endX, endY} of targets) { context.moveTo(x, y); context.lineTo(endX, endY); }
      context.stroke();
      context.globalAlpha = 1;
      for (const cell of cellMeans(targets, width, height)) drawMean(context, cell);
      return targets;
    },
  });
}

/** @typedef {{x: number, y: number, endX: number, endY: number, doubtful?: boolean}} Shift */

/** Mean position and error per grid cell with at least five corners. @param {Shift[]} targets @param {number} width @param {number} height @returns {Shift[]} */
function cellMeans(targets, width, height) {
  const columns = 8, rows = 6, fewest = 5;
  const cells = groupBy(targets.filter(({doubtful}) => !doubtful),
    ({x, y}) => Math.floor(x / width * columns) + columns * Math.floor(y / height * rows));
  return [...cells.values()].filter(list => list.length >= fewest).map(list => ({
    x: mean(list.map(({x}) => x)), y: mean(list.map(({y}) => y)),
    endX: mean(list.map(({endX}) => endX)), endY: mean(list.map(({endY}) => endY)),
  }));
}

/** @param {CanvasRenderingContext2D} context @param {Shift} shift */
function drawMean(context, {x, y, endX, endY}) {
  context.strokeStyle = context.fillStyle = colours.orange;
  context.lineWidth = 3;
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(endX, endY);
  context.stroke();
  context.beginPath();
  context.arc(x, y, 3, 0, 7);
  context.fill();
}

/** Mean residual per part of a camera's image, without rigid motion. @param {Diagnosis} data @param {Left} left @param {string} camera @param {(picture: number) => void} [open] */
function withinPictures(data, left, camera, open) {
  const cells = left.within.cells.filter(cell => cell.camera === camera), {captureName} = captureNames(data);
  return captioned({height: inProportion(data.cameras[camera]), label: "what is left in the " + camera + " camera", open, draw: (context, width, height, caption) => {
    const scale = width / data.cameras[camera].width;
    context.fillStyle = colours.panel;
    context.fillRect(0, 0, width, height);
    const enlarged = enlargement(cells.map(({du, dv}) => scale * Math.hypot(du, dv)), 0.05 * width);
    const sure = cells.filter(({du, dv, sigma}) => Math.hypot(du, dv) > 3 * sigma);
    caption.replaceChildren(bold(camera + " camera"), ": " + sure.length + " of " + cells.length +
      " places are off by more than 3 standard errors (by chance 1 in 100); " + enlargedWords(enlarged));
    return cells.map(cell => {
      const x = scale * (cell.u + 0.5), y = scale * (cell.v + 0.5), certain = sure.includes(cell);
      arrow(context, certain ? colours.orange : colours.soft, certain ? 2.5 : 1, x, y, scale * enlarged * cell.du, scale * enlarged * cell.dv);
      return {x, y, picture: cell.worst, tip: () => cell.corners + " corners, mean prediction " + direction(cell.du, cell.dv) + " (± " +
        px(cell.sigma) + ")\nlargest: " + captureName(cell.worst)};
    });
  }});
}

const tones = ["blue", "orange", "pink", "soft"]; // colours of boards

/** RMS residual of each board and picture over its distance from the camera. @param {Diagnosis} data @param {Left} left @param {(picture: number) => void} [open] */
function byDistance(data, left, open) {
  const {boards: seen, noise} = left.within, {captureName} = captureNames(data), boards = [...new Set(seen.map(({board}) => board))].sort();
  const tone = (/** @type {string} */ board) => tones[boards.indexOf(board) % tones.length];
  return captioned({height: 300, label: "what is left over the distance of boards", open, draw: (context, width, height, caption) => {
    const highest = 1.08 * Math.max(2 * noise, quantile(seen.map(({rms}) => rms), 0.98));
    const box = {left: 46, right: width - 8, top: 30, bottom: height - 42};
    const {x, y, line} = axes(context, box, widened(extent(seen.map(({distance}) => distance)), 0.03), [0, highest],
      {title: "rms error per axis [px]", xLabel: "distance of the board from the camera [m]"});
    context.setLineDash([6, 4]);
    context.strokeStyle = colours.soft;
    line(box.left, y(noise), box.right, y(noise));
    context.setLineDash([]);
    caption.replaceChildren("Each dot is a board in a picture:", ...boards.flatMap(board => {
      const mark = key("dot");
      mark.style.background = "var(--" + tone(board) + ")";
      return ["  ", mark, " " + board];
    }), "; dashed: the corner noise of the diagnosis (" + short(noise) + " px).");
    return seen.map(({picture, board, distance, rms}) => {
      const target = {x: x(distance), y: y(Math.min(rms, highest)), beyond: rms > highest ? -1 : 0};
      context.fillStyle = colours[tone(board)];
      context.globalAlpha = 0.75;
      dot(context, target);
      context.globalAlpha = 1;
      return {...target, picture, tip: () => "board " + board + " in " + captureName(picture) + "\n" + px(rms) + " per axis at " +
        distance.toFixed(2) + " m"};
    });
  }});
}

/** @type {View} */
export const view = {
  place: 70, title: "Within the pictures", about: "misfit",
  show: (data, {open}) => data.left.asGiven?.within.cells.length ? [
    element("p", {}, "What is left when every picture may move as a whole. No joint, link or mount causes it; lens, boards and corner " +
      "detection can. Arrows point from measured to predicted corners, averaged over a part of the picture, thick where that is beyond chance. " +
      "Good: short thin arrows in all directions, and dots near the noise at any distance."),
    modelChoice("withinBy", data, left => element("div", {}, element("div", {class: "grid"},
      ...Object.keys(data.cameras).map(camera => withinPictures(data, left, camera, open))), byDistance(data, left, open)))] : null,
};
