// Formatting of numbers, units and states.

/** @import {Size} from "naocal/lib/types.js" */

/** Replaces the hyphen by a minus sign. @param {string} text */
const minus = text => text.replace("-", "−");

/** @param {string} text @param {string} [unit] */
export const withUnit = (text, unit) => !unit ? text : unit.startsWith("°") ? text + unit : text + " " + unit;

/** "value ± sigma", rounded to two significant digits of sigma. @param {number} value @param {number} sigma */
export function withError(value, sigma, unit = "") {
  const digits = Math.min(9, Math.max(0, 1 - Math.floor(Math.log10(Math.abs(sigma) || 1))));
  const text = value.toFixed(digits);
  return withUnit(minus(Number(text) ? text : text.replace("-", "")) + " ± " + sigma.toFixed(digits), unit);
}

/** "k = 0.82 ± 0.05°/Nm" @param {Size} size */
export const sizeWords = ({name, value, sigma, unit, told}) =>
  told === false || value === null || sigma === null ? name + " undetermined" : name + " = " + withError(value, sigma, unit);

/** Smallest detectable size, two digits. @param {Size} size */
export const detectableWords = ({detectable, unit}) => detectable === null ? "–" : withUnit(String(Number(detectable.toPrecision(2))), unit);

/** @param {number} value */
export const px = value => minus(value.toFixed(Math.abs(value) < 10 ? 2 : 1)) + " px";

/** "0.53 px", "0.532 mm": an error in a unit of pages. @param {number} value @param {string} unit */
export const sized = (value, unit) => unit === "px" ? px(value) : withUnit(minus(value.toFixed(Math.abs(value) < 1 ? 3 : 2)), unit);

/** @param {number} value @param {string} unit */
export const sized3 = (value, unit) => withUnit(value.toFixed(3), unit);

/** At most three significant digits; a dash for unknown values. @param {number | null | undefined} value */
export const short = value => value === null || value === undefined || !isFinite(value) ? "–"
  : minus(String(Number(value.toPrecision(3))));

/** One decimal, never −0.0. @param {number} value */
export const tenths = value => minus((Math.round(10 * value) / 10 || 0).toFixed(1));

/** @param {number} value */
export const number = value => minus(String(value));

/** @param {number} share */
export const percent = share => Math.round(100 * share) + " %";

/** "p = 0.02" @param {number} p */
export const chance = p => p < 0.001 ? "p < 0.001" : "p = " + Number(p.toPrecision(2));

/** "0.80 px to the right, 0.30 px down" @param {number} x @param {number} y */
export const direction = (x, y) =>
  px(Math.abs(x)) + (x < 0 ? " to the left, " : " to the right, ") + px(Math.abs(y)) + (y < 0 ? " up" : " down");

/** The text with a capital, unless it begins with a name: "elbow_joint", "HeadYaw". @param {string} text */
export const capitalized = text => /^[a-z]+(?![\w@])/.test(text) ? text.charAt(0).toUpperCase() + text.slice(1) : text;

// Candidate states by their key in files and style sheets: display name and explanation.
/** @type {Record<string, {name: string, words: string}>} */
const states = {
  "present": {name: "needed", words: "the misfit needs it"},
  "aliased": {name: "could explain", words: "explains the misfit alone, another explains it as well"},
  "trivial": {name: "too small to matter", words: "it is there, but changes the error too little"},
  "absent": {name: "ruled out", words: "would have been seen at a plausible size"},
  "inconclusive": {name: "undecided", words: "may be there, too small for these captures"},
  "absorbed": {name: "not testable here", words: "other unknowns imitate it in these poses"},
  "no-data": {name: "no data", words: "its driver was not recorded"},
};
export const allStates = Object.keys(states);
/** @param {string} state */
export const stateName = state => states[state]?.name ?? state;
/** @param {string} state */
export const stateWords = state => states[state]?.words ?? "";
/** "needed: the misfit needs it" @param {string} state */
export const stateTip = state => stateName(state) + ": " + stateWords(state);

/** @param {string} name */
export const driverWords = name => name === "t" ? "time" : name === "approach" ? "how it was approached"
  : name === "T" ? "its temperature" : name === "qd" ? "its speed"
  : name.startsWith("tau_") ? "the torque on " + name.slice(4) : "the angle of " + name;

/** @param {{candidates: number}} fit */
export const waitingWords = ({candidates}) => "Testing " + candidates + " possible " + (candidates === 1 ? "cause" : "causes") + " …";
