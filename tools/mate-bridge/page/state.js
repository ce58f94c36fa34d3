// What the bridge has told, and what views share.
import {send} from "./connection.js";

export const state = {
  laboratory: false, set: null, ladder: null, fit: null, questions: null, found: null, next: null, compared: null, work: null,
  earlier: null, // questions as they were answered for the model before
  unfitted: null, // why there is no fit at all
  robots: new Map(), // by address: {connected, sentence, list, mounts, keys: Map}
  layer: "reported", chosen: null, // the picture that was clicked on, by capture and set
};

let notify = () => {};
export const onNotice = listener => { notify = listener; };
export const notice = sentence => notify(sentence, "problem");
export const say = sentence => notify(sentence, "news");

// Asks the bridge; false when it is away, which it says.
export function act(request) {
  const sent = send(request);
  if (!sent) notice("The bridge is not connected: nothing was changed. It is tried again by itself.");
  return sent;
}
