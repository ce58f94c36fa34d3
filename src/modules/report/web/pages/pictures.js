// Paged gallery of pictures with measured and predicted corners.
import {at, renew} from "naocal/lib/dom.js";
import {pictureError} from "naocal/lib/captures.js";
import {cornersFigure} from "naocal/plots/corners.js";

/** @import {Layer, Picture} from "naocal/lib/types.js" */

const perPage = 6;

/** @type {Map<Picture, HTMLImageElement>} */
const photographs = new Map();

/** @param {Picture} picture @param {() => void} loaded */
function photograph(picture, loaded) {
  if (!picture.photograph) return null;
  let image = photographs.get(picture);
  if (!image) {
    photographs.set(picture, image = new Image());
    image.onload = loaded;
    image.src = picture.photograph;
  }
  return image.complete && image.naturalWidth ? image : null;
}

/**
 * Returns `show`, which redraws the page, and `open`, which turns to a picture's page and scrolls to it.
 * @param {Picture[]} pictures sorted by time
 * @param {{layer: () => Layer, nameOf: (picture: Picture) => string}} options
 */
export function showPictures(pictures, {layer, nameOf}) {
  let first = 0;
  const ordered = () => at("order").value === "time" ? pictures : [...pictures].sort((a, b) => pictureError(b, layer()) - pictureError(a, layer()));
  const show = () => {
    const list = ordered(), last = Math.min(first + perPage, list.length);
    renew(at("pictures"), ...list.slice(first, last).map(picture => cornersFigure(picture, {layer, nameOf, photograph})));
    at("page").textContent = first + 1 + "–" + last + " of " + list.length;
    at("previous").disabled = first === 0;
    at("next").disabled = last === list.length;
  };
  const turn = (/** @type {number} */ place) => { first = Math.max(0, place - place % perPage); show(); };
  at("order").addEventListener("change", () => turn(0));
  at("previous").addEventListener("click", () => turn(first - perPage));
  at("next").addEventListener("click", () => turn(first + perPage));
  show();
  return {show, open: (/** @type {Picture} */ picture) => {
    const place = ordered().indexOf(picture);
    turn(place);
    at("pictures").children[place % perPage].scrollIntoView({block: "center"});
  }};
}
