// The bridge's last messages, and state shared by views.
import {send} from "./connection.js";

/** @type {import("./messages.js").PanelState} */
export const state = /** @type {any} */ ({
  analysis: false, set: null, ladder: null, fit: null, questions: null, earlier: null, unfitted: null, found: null, next: null, compared: null, history: null, missing: null,
  work: null, robots: new Map(), layer: "reported", chosen: null,
});

/** @type {(sentence: string, kind: "problem" | "news") => void} */
let notify = () => {};
export const onNotice = listener => { notify = listener; };
export const notice = sentence => notify(sentence, "problem");
export const say = sentence => notify(sentence, "news");

// Sends a request. Shows a notice and returns false if the bridge is not connected.
export function act(request) {
  const sent = send(request);
  if (!sent) notice("The bridge is not connected: nothing was changed. The panel keeps trying.");
  return sent;
}

// Per robot: last value of each key, and the bridge's results.
const known = new Map(); // by robot

export const of = robot => {
  if (!known.has(robot)) known.set(robot, {values: new Map(), scene: null, before: null, pictures: {series: 0, places: []}});
  return known.get(robot);
};
export const valueOf = (robot, key) => of(robot).values.get(key) ?? null;
