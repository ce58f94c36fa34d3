// One picture with its corners: ring = measured, cross = predicted, joined by a line.
import {bold} from "naocal/lib/dom.js";
import {captioned, colours, inProportion} from "naocal/lib/figure.js";
import {enlargement, enlargedWords} from "naocal/lib/axes.js";
import {direction, percent, px} from "naocal/lib/format.js";
import {cornersOf, lengthOf, pictureError} from "naocal/lib/captures.js";

/** @import {Corner, Layer, Picture} from "naocal/lib/types.js" */

export const doubtfulBelow = 0.5; // weight; corners below are drawn as doubtful

/**
 * Draws a corner: ring = measured, cross = predicted, if it is. `halo`: a wide pale underlay, for contrast with the
 * photograph.
 * @param {CanvasRenderingContext2D} context
 * @param {{x: number, y: number, endX?: number, endY?: number, doubtful?: boolean}} corner
 * @param {boolean} halo
 */
export function drawCorner(context, {x, y, endX, endY, doubtful}, halo) {
  const stroke = (/** @type {string} */ name, /** @type {() => void} */ path) => {
    context.strokeStyle = halo ? "rgba(255, 255, 255, 0.6)" : colours[name];
    context.lineWidth = halo ? 3.5 : 1.5;
    context.beginPath();
    path();
    context.stroke();
  };
  if (endX !== undefined && endY !== undefined) stroke("orange", () => {
    context.moveTo(x, y); context.lineTo(endX, endY);
    context.moveTo(endX - 3, endY - 3); context.lineTo(endX + 3, endY + 3);
    context.moveTo(endX - 3, endY + 3); context.lineTo(endX + 3, endY - 3);
  });
  stroke("blue", () => context.arc(x, y, 3.5, 0, 7));
  if (doubtful) stroke("pink", () => context.rect(x - 8, y - 8, 16, 16));
}

/**
 * Targets of corners in drawing coordinates, with their errors enlarged.
 * @param {Corner[]} corners
 * @param {number} scale
 * @param {number} enlarged
 * @param {(picture: Picture) => string} nameOf
 */
export const cornerTargets = (corners, scale, enlarged, nameOf) => corners.map(corner => {
  const x = scale * (corner.u + 0.5), y = scale * (corner.v + 0.5);
  return {x, y, endX: x + scale * enlarged * corner.du, endY: y + scale * enlarged * corner.dv,
    doubtful: corner.weight < doubtfulBelow, picture: corner.picture, tip: () => cornerTip(corner, nameOf)};
});

/** @param {Corner} corner @param {(picture: Picture) => string} nameOf */
export function cornerTip(corner, nameOf) {
  const {board, id, u, v, du, dv, weight, picture} = corner;
  return "board " + board + ", corner " + id + " at (" + u.toFixed(1) + ", " + v.toFixed(1) + ")\n" + nameOf(picture) + "\npredicted " +
    px(lengthOf(corner)) + " off: " + direction(du, dv) +
    (weight < 1 ? "\n" + (weight < doubtfulBelow ? "doubtful: " : "") + "counts " + percent(weight) : "");
}

/**
 * @param {Picture} picture
 * @param {object} options
 * @param {() => Layer} options.layer residuals to draw
 * @param {(picture: Picture) => string} options.nameOf
 * @param {(picture: Picture, loaded: () => void) => HTMLImageElement | null} options.photograph background image; null until loaded
 * @param {(name: string, factor: number) => number} [options.steady] the factor by which errors were enlarged before
 */
export function cornersFigure(picture, {layer, nameOf, photograph, steady = (_, factor) => factor}) {
  const drawn = captioned({
    height: inProportion(picture), label: "measured and predicted corners of " + nameOf(picture),
    draw: (context, width, height, caption) => {
      const scale = width / picture.width, corners = cornersOf(picture, layer());
      const behind = photograph(picture, () => /** @type {any} */ (drawn.firstChild).redraw());
      context.fillStyle = colours.panel;
      context.fillRect(0, 0, width, height);
      if (behind) context.drawImage(behind, 0, 0, width, height);
      context.strokeStyle = colours.line;
      context.strokeRect(0.5, 0.5, width - 1, height - 1);
      const enlarged = steady(nameOf(picture), enlargement(corners.map(corner => scale * lengthOf(corner)), 0.06 * width));
      const targets = cornerTargets(corners, scale, enlarged, nameOf);
      if (behind) targets.forEach(target => drawCorner(context, target, true));
      targets.forEach(target => drawCorner(context, target, false));
      caption.replaceChildren(bold(px(pictureError(picture, layer())) + " rms"), ", " + enlargedWords(enlarged) + ": " + nameOf(picture) +
        ", " + (picture.boards.length === 1 ? "board " : "boards ") + picture.boards.map(({board}) => board).join(", "));
      return targets.map(({picture: _, ...target}) => target); // the picture is already shown
    },
  });
  /** @type {HTMLElement} */ (drawn.firstChild).style.aspectRatio = picture.width + "/" + picture.height; // reserves the space before the first drawing
  return drawn;
}
