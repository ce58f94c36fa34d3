// The bridge's last messages, and state shared by views.
import {send} from "./connection.js";

/** @type {import("./messages.js").PanelState} */
export const state = /** @type {any} */ ({
  analysis: false, set: null, ladder: null, fit: null, diagnosis: null, unsearched: null, earlier: null, unfitted: null, next: null, compared: null,
  start: null, history: null, missing: null, work: null, robots: new Map(), layer: "reported", chosen: null,
});

/** @type {(sentence: string, kind: "problem" | "news", cause: string) => void} */
let notify = () => {};
/** @type {(cause: string) => void} */
let endNotify = () => {};
export const onNotice = (listener, ends) => { notify = listener; endNotify = ends; };
/** Shows a problem until its cause ends. "action": the next action ends it. @param {string} sentence */
export const notice = (sentence, cause = "action") => notify(sentence, "problem", cause);
export const say = sentence => notify(sentence, "news", "action");
/** Hides the notice of a cause that is over. @param {string} cause */
export const endNotice = cause => endNotify(cause);

// Sends a request. Shows a notice and returns false if the bridge is not connected.
export function act(request) {
  if (request.do !== "keys") endNotice("action"); // views ask for keys by themselves
  const sent = send(request);
  if (!sent) notice("The bridge is not connected: nothing was changed. The panel keeps trying.", "bridge");
  return sent;
}

// Per robot: last value of each key, and the bridge's results.
const known = new Map(); // by robot

export const of = robot => {
  if (!known.has(robot)) known.set(robot, {values: new Map(), scene: null, before: null, pictures: {series: 0, places: []}});
  return known.get(robot);
};
export const valueOf = (robot, key) => of(robot).values.get(key) ?? null;
