// What the bridge has told, and what views share.
import {send} from "./connection.js";

export const state = {
  laboratory: false, set: null, ladder: null, fit: null, questions: null, found: null, next: null, compared: null, work: null,
  robots: new Map(), // by address: {connected, sentence, list, mounts, keys: Map}
  layer: "reported", chosen: null, // the picture that was clicked on, by capture and set
};

let notify = () => {};
export const onNotice = listener => { notify = listener; };
export const notice = (sentence, kind) => notify(sentence, kind);

// Asks the bridge, and says so when it is away.
export function act(request) {
  if (!send(request)) notice("The bridge is not connected: nothing was changed. It is tried again by itself.");
}
