// Numbers in words, as the report writes them, and what only the panel says.
import {stateWords as concluded} from "../../../src/modules/report/page/shared/words.js";

export * from "../../../src/modules/report/page/shared/words.js";

export const px3 = value => value.toFixed(3) + " px";
export const rms = values => Math.sqrt(values.reduce((sum, value) => sum + value * value, 0) / Math.max(1, values.length));

export const stateWords = {...concluded, present: "added to this model, it would explain more than chance does"};
export const stateName = name => ({present: "would help", absorbed: "not testable", aliased: "look-alike"})[name] || name.replace("-", " ");

export const waitingWords = ({candidates}) => "Testing " + candidates + " possible " + (candidates === 1 ? "cause" : "causes") + " …";

export const pictureName = ({capture, camera, pose}) =>
  "capture " + capture + (pose ? ", pose " + pose : "") + ", " + camera + " camera";
