// Pictures of the open captures; the bridge serves their photographs.
import {cornersOf as cornersIn, pictureError, pictureName} from "naocal/lib/captures.js";
import {cornersFigure} from "naocal/plots/corners.js";
import {on} from "../core/connection.js";
import {state} from "../core/state.js";

const layer = () => state.layer;
export const cornersOf = picture => cornersIn(picture, state.layer);
export const errorOf = picture => pictureError(picture, state.layer);
export const pictureFigure = picture => cornersFigure(picture, {layer, nameOf: pictureName, photograph, steady});

const factors = new Map(); // by what is drawn; stay while the model changes, so that errors are seen to fall
on("opened", () => factors.clear());
/** The factor by which errors were enlarged when they were first drawn. */
export function steady(name, factor) {
  if (!factors.has(name)) factors.set(name, factor);
  return factors.get(name);
}

const photographs = new Map(); // by address
let desk = 0; // part of the address: other captures may have equal names
for (const kind of ["opened", "hello"]) on(kind, () => { photographs.clear(); ++desk; });

function photograph(picture, loaded) {
  if (!picture.kept) return null;
  const address = "picture/" + encodeURIComponent(picture.set) + "/" + picture.capture + "?" + desk;
  if (!photographs.has(address)) {
    const image = new Image();
    photographs.set(address, image);
    image.src = address;
    if (photographs.size > 60) photographs.delete(photographs.keys().next().value);
  }
  const image = photographs.get(address);
  if (!image.complete) image.addEventListener("load", loaded, {once: true});
  return image.complete && image.naturalWidth ? image : null;
}
