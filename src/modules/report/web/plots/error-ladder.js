// Bar chart of each model's held-out error, with the noise floor.
import {element, tipOver} from "naocal/lib/dom.js";
import {chance, px3} from "naocal/lib/format.js";

/** @import {Rung} from "naocal/lib/types.js" */

/**
 * One bar per model: held-out error; hollow if only the fit's error is known.
 * @param {Rung[]} rungs
 * @param {{floorName?: string, at?: number, choose?: (rung: number) => void}} [options] `at`: present model; `choose`: selects a model
 */
export function errorLadder(rungs, {floorName = "noise floor", at, choose} = {}) {
  const floor = rungs.reduce((last, rung) => rung.floor ?? last, 0);
  const most = 1.05 * Math.max(floor, ...rungs.map(errorOf)), place = (/** @type {number} */ value) => 100 * value / most + "%";
  return element("ol", {class: "ladder"}, ...rungs.map((rung, i) => {
    const isKnown = rung.heldOut !== null, name = rung.name || "base model";
    const parts = [element("span", {class: "name"}, ...name.split(/(?<=@)/).flatMap((part, i) => i ? [element("wbr"), part] : [part])),
      element("span", {class: "number" + (isKnown ? "" : " soft")}, isKnown ? px3(errorOf(rung)) : px3(rung.rms) + " fitted"),
      axis(place(rung.floor ?? floor), place(errorOf(rung)), isKnown)];
    return element("li", {}, tipOver(choose ? element("button", {type: "button", class: "rung", "aria-current": i === at ? "step" : null, onclick: () => choose(i)}, ...parts)
      : element("div", {class: "rung"}, ...parts), words(rung, name, floorName, rungs[rung.from ?? i - 1], (rung.from ?? i - 1) !== i - 1)));
  }), element("li", {class: "floor soft"}, element("span", {class: "name"}, floorName), element("span", {class: "number"}, floor ? px3(floor) : "…"), axis(place(floor))));
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

/** @param {Rung} rung @param {string} name @param {string} floorName @param {Rung} [previous] the one it was made from @param {boolean} [isBranch] */
function words({dropped = [], rms, heldOut, floor, alarm}, name, floorName, previous, isBranch) {
  return name + (dropped.length ? ", which makes superfluous: " + dropped.join(", ") : "") + (isBranch ? "\nmade from: " + (previous?.name || "base model") : "") +
    "\nheld-out error: " + (heldOut === null ? "not known" : px3(heldOut) + (previous?.heldOut ? " (" + px3(previous.heldOut) + " before)" : "")) +
    "\nfitted poses: " + px3(rms) + (floor === null ? "" : "\n" + floorName + ": " + px3(floor)) +
    (alarm === null ? "" : "\nchance that noise alone looks this convincing: " + chance(alarm));
}
