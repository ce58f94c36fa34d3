// Bar chart of each model's held-out error, with the noise floor.
import {element, tipOver} from "naocal/lib/dom.js";
import {chance, sized3} from "naocal/lib/format.js";

/** @import {Rung} from "naocal/lib/types.js" */

/**
 * One bar per model: held-out error; hollow if only the fit's error is known.
 * @param {Rung[]} rungs
 * @param {{floorName?: string, unit?: string, at?: number, choose?: (rung: number) => void}} [options] `at`: present model; `choose`: selects a model
 */
export function errorLadder(rungs, {floorName = "noise floor", unit = "px", at, choose} = {}) {
  const floor = rungs.reduce((last, rung) => rung.floor ?? last, 0);
  const most = 1.05 * Math.max(floor, ...rungs.map(errorOf)), place = (/** @type {number} */ value) => 100 * value / most + "%";
  return element("ol", {class: "ladder"}, ...rungs.map((rung, i) => {
    const isKnown = rung.heldOut !== null, name = rung.name || "base model";
    const parts = [element("span", {class: "name"}, ...name.split(/(?<=@)/).flatMap((part, i) => i ? [element("wbr"), part] : [part])),
      element("span", {class: "number" + (isKnown ? "" : " soft")}, isKnown ? sized3(errorOf(rung), unit) : sized3(rung.rms, unit) + " fitted"),
      axis(place(rung.floor ?? floor), place(errorOf(rung)), isKnown)];
    return element("li", {}, tipOver(choose ? element("button", {type: "button", class: "rung", "aria-current": i === at ? "step" : null, onclick: () => choose(i)}, ...parts)
      : element("div", {class: "rung"}, ...parts), words(rung, {name, floorName, unit}, rungs[rung.from ?? i - 1], (rung.from ?? i - 1) !== i - 1)));
  }), element("li", {class: "floor soft"}, element("span", {class: "name"}, floorName), element("span", {class: "number"}, floor ? sized3(floor, unit) : "…"), axis(place(floor))));
}

/** @param {Rung} rung */
const errorOf = ({heldOut, rms}) => heldOut ?? rms;

/** @param {string} band @param {string} [length] @param {boolean} [isKnown] */
function axis(band, length, isKnown) {
  const made = element("span", {class: "axis"});
  made.appendChild(element("span", {class: "band"})).style.width = band;
  if (length) made.appendChild(element("span", {class: "bar" + (isKnown ? "" : " open")})).style.width = length;
  return made;
}

/** @param {Rung} rung @param {{name: string, floorName: string, unit: string}} shown @param {Rung} [previous] the one it was made from @param {boolean} [isBranch] */
function words({dropped = [], rms, heldOut, floor, alarm}, {name, floorName, unit}, previous, isBranch) {
  return name + (dropped.length ? ", which makes superfluous: " + dropped.join(", ") : "") + (isBranch ? "\nmade from: " + (previous?.name || "base model") : "") +
    "\nheld-out error: " + (heldOut === null ? "not known" : sized3(heldOut, unit) + (previous?.heldOut ? " (" + sized3(previous.heldOut, unit) + " before)" : "")) +
    "\nfitted poses: " + sized3(rms, unit) + (floor === null ? "" : "\n" + floorName + ": " + sized3(floor, unit)) +
    (alarm === null ? "" : "\nchance that noise alone looks this convincing: " + chance(alarm));
}
