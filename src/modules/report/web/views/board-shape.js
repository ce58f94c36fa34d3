// Estimated corner positions of each board relative to its file, from all its pictures.
import {bold, element, key} from "naocal/lib/dom.js";
import {captioned, colours} from "naocal/lib/figure.js";
import {arrow, enlargedWords} from "naocal/lib/axes.js";
import {chance, withError} from "naocal/lib/format.js";
import {extent} from "naocal/lib/statistics.js";
import {modelChoice} from "naocal/views/model-choice.js";

/** @import {Shape, View} from "naocal/lib/types.js" */

/** Extent of a board's corners [m], with a margin; `tall`: height over width. @param {Shape} shape */
function planOf({corners}) {
  const [left, right] = extent(corners.map(({place}) => place[0])), [bottom, top] = extent(corners.map(({place}) => place[1]));
  const margin = 0.12 * Math.max(right - left, top - bottom), wide = right - left + 2 * margin;
  return {margin, left: left - margin, top: top + margin, wide, tall: (top - bottom + 2 * margin) / wide};
}

/**
 * Draws the sheet's outline and a scale bar.
 * @param {CanvasRenderingContext2D} context
 * @param {number} width
 * @param {number} height
 * @param {{scale: number, margin: number, enlarged: number, millimetre: number}} sizes
 */
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

/** @param {Shape} shape */
function boardShape(shape) {
  const {board, corners, p} = shape, {left, top, wide, margin, tall} = planOf(shape);
  return captioned({height: width => width * tall, label: "shape of board " + board, draw: (context, width, height, caption) => {
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
      const certain = Math.hypot(dx / sx, dy / sy) > 2.5; // 2.5: two components, at about 95 %
      context.globalAlpha = certain ? 1 : 0.35;
      arrow(context, colours.ink, certain ? 1.5 : 1, x, y, enlarged * millimetre * dx, -enlarged * millimetre * dy);
      context.globalAlpha = 1;
      return {x, y, tip: () => "corner " + id + "\nto the right " + withError(dx, sx, "mm") +
        "\nup the sheet " + withError(dy, sy, "mm") + "\noff the sheet " + withError(dz, sz, "mm")};
    });
  }});
}

/** @type {View} */
export const view = {
  place: 80, title: "On the boards", about: "misfit",
  show: data => data.left.asGiven?.shapes.length ? [
    element("p", {}, "Where each board's corners seem to lie beside where its file has them, by all its pictures together: arrows within " +
      "the sheet, discs off it, ", key("dot orange"), " towards the camera and ", key("dot"), " away from it; pale where that is less than two " +
      "standard errors. A sheet that is bent, was printed crookedly or lies over a cable looks like this. The board's size does not show: " +
      "no picture tells it from the distance."),
    modelChoice("shapesBy", data, ({shapes}) => element("div", {class: "grid"}, ...shapes.map(boardShape)))] : null,
};
