// Signature of an effect in otherwise error-free captures: residuals before and after refitting.
import {bold, button, choosing, element, key} from "naocal/lib/dom.js";
import {captioned, colours, inProportion} from "naocal/lib/figure.js";
import {arrow, enlargement, enlargedWords} from "naocal/lib/axes.js";
import {direction, percent, px, short, withUnit} from "naocal/lib/format.js";
import {rms} from "naocal/lib/statistics.js";
import {captureNames} from "naocal/lib/captures.js";

/** @import {Candidate, Diagnosis, Signature, SignaturePicture, View} from "naocal/lib/types.js" */

/** All cameras side by side, pages with the largest shifts first. @param {Candidate} candidate @param {Diagnosis} data */
function effectSignature({label, imprint}, data) {
  const signature = /** @type {Signature} */ (imprint), pages = Object.keys(data.cameras).map(camera => ({camera, pages: pagesOf(signature, camera, data)}));
  const count = Math.max(1, ...pages.map(({pages}) => pages.length)), grid = element("div", {class: "grid"}), rank = element("span");
  let shown = 0;
  const turn = (/** @type {number} */ step) => {
    shown = Math.max(0, Math.min(count - 1, shown + step));
    rank.textContent = shown + 1 + " of " + count;
    larger.disabled = shown === 0;
    smaller.disabled = shown === count - 1;
    grid.replaceChildren(...pages.filter(({pages}) => pages[shown]).map(({camera, pages}) => signatureFigure(pages[shown], camera, data)));
  };
  const larger = button("‹ larger", () => turn(-1)), smaller = button("smaller ›", () => turn(1));
  turn(0);
  return element("div", {}, element("p", {}, bold(label), summary(signature)),
    count > 1 ? element("p", {class: "controls"}, larger, rank, smaller) : null, grid);
}

/** Pages of a camera's pictures: one each, or several with at most 12 corners in total. @param {Signature} signature @param {string} camera @param {Diagnosis} data */
function pagesOf(signature, camera, data) {
  /** @type {SignaturePicture[][]} */
  const pages = [], few = 12;
  for (const seen of signature.pictures.filter(({picture}) => data.pictures[picture].camera === camera)) {
    const last = pages[pages.length - 1];
    if (last && last.reduce((sum, {corners}) => sum + corners.length, 0) + seen.corners.length <= few) last.push(seen);
    else pages.push([seen]);
  }
  return pages;
}

/** @param {Signature} signature */
function summary({found, sizes, before, after, imitator}) {
  const size = sizes.map(({name, value, unit}) => withUnit(name + " = " + short(value), unit)).join(", ");
  const swallowed = before > 0 ? 1 - Math.min(1, after / before) : 0;
  return (found ? " at the size found (" : " at a plausible size (") + size + "): " + px(before) +
    " rms before, " + px(after) + " after refitting: other parameters absorb " + percent(swallowed) + " of it, " + imitator + " most.";
}

/** @param {SignaturePicture[]} seen @param {string} camera @param {Diagnosis} data */
function signatureFigure(seen, camera, data) {
  const {captureName} = captureNames(data), corners = seen.flatMap(one => one.corners.map(corner => ({picture: one.picture, corner})));
  const over = (/** @type {(one: SignaturePicture) => number} */ value) => px(rms(seen.map(value)));
  return captioned({height: inProportion(data.cameras[camera]), label: "shifts of corners in the " + camera + " camera", draw: (context, width, height, caption) => {
    const scale = width / data.cameras[camera].width;
    const enlarged = enlargement(corners.map(({corner: [, , du, dv]}) => scale * Math.hypot(du, dv)), 0.1 * width);
    context.fillStyle = colours.panel;
    context.fillRect(0, 0, width, height);
    caption.replaceChildren(bold(camera + " camera"), ", " + (seen.length > 1 ? seen.length + " captures" : captureName(seen[0].picture)) + ": " +
      over(({before}) => before) + " rms, " + over(({after}) => after) + " after refitting; " + enlargedWords(enlarged));
    return corners.map(({picture, corner: [u, v, du, dv, left, down]}) => {
      const x = scale * (u + 0.5), y = scale * (v + 0.5);
      arrow(context, colours.orange, 5, x, y, scale * enlarged * du, scale * enlarged * dv);
      arrow(context, colours.blue, 1.5, x, y, scale * enlarged * left, scale * enlarged * down);
      return {x, y, tip: () => captureName(picture) + "\nshifted by " + direction(du, dv) + "\nafter refitting " + direction(left, down)};
    });
  }});
}

/** @type {View} */
export const view = {
  place: 30, title: "What it would look like", about: "candidates",
  show: data => {
    const shown = data.candidates.filter(({imprint}) => imprint);
    if (!shown.length) return null;
    return [element("p", {}, "Your captures, perfect but for one effect. ", key("before"), " Shift of the corners; ", key("after"),
      " what remains once the model without the effect is refitted: only this can reveal it. Where these arrows are short, the effect hides in these poses."),
    choosing("imprintOf", "Effect", shown.map(({label}) => ({value: label, text: label})),
      label => effectSignature(shown.find(one => one.label === label) ?? shown[0], data))];
  },
  ofCandidate: (candidate, data) => candidate.imprint && [element("p", {class: "soft"}, key("before"), " shift of the corners; ", key("after"),
    " what remains after refitting: only this can reveal it."), effectSignature(candidate, data)],
};
