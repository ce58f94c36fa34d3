// Tour of five steps on the sample: where the prediction fails, the candidate, adding it, the fallen error.
import {button, element} from "naocal/lib/dom.js";
import {px} from "naocal/lib/format.js";
import {on, send} from "../core/connection.js";
import {act, state} from "../core/state.js";

/** @typedef {{title: string, view: string, target: string, words: () => (string | Node)[], next?: string, go?: () => void, isDone?: () => boolean}} Step */

let at = -1; // present step; -1: no tour
let isWaiting = false; // for the sample
let truth = "", asked = 0;
/** @type {HTMLElement | null} */
let shown = null, pointed = null;

const isAdded = () => Boolean(state.fit?.with.length);
/** The best candidate, or what was added; empty while candidates are being tested. */
const label = () => state.fit?.with[0] ?? state.diagnosis?.suggested[0] ?? state.diagnosis?.candidates[0]?.label ?? "";
const bold = text => element("b", {}, text);
/** Held-out error of the first and of the present model. */
const errors = () => {
  const {rungs, at: now} = state.ladder;
  return {before: rungs[0].heldOut ?? rungs[0].rms, after: rungs[now].heldOut ?? null, floor: rungs[now].floor ?? null};
};

/** @type {Step[]} */
const steps = [
  {title: "Compare", view: "compare", target: ".split > div:last-child .figure", words: () => ["A simulated NAO took these pictures. Circles are the boards' corners as measured, crosses are where the calibrated robot predicts them. " +
    "They differ by ", bold(px(state.fit ? state.ladder.rungs[state.ladder.at].rms : 0)), ", far more than noise."]},
  {title: "Where it fails", view: "compare", target: ".finding", words: () => state.diagnosis ? ["The panel has tested every known effect at every place. The sentence on top says what is missing. " +
    "Below it, on the left, is the error that this effect makes, pose by pose; on the right is what remains with it."] : ["The panel is testing every known effect at every place …"]},
  {title: "A candidate", view: "learn", target: ".candidates tbody tr:first-child", words: () => label()
    ? ["All candidates with their evidence. The best is ", bold(label()), ": beside it are its size, and the error it would leave."]
    : ["Every known effect is being tested at every place …"]},
  {title: "Add it", view: "learn", target: ".candidates tbody tr:first-child", next: "Add it for me", isDone: isAdded, go: () => { if (label()) act({do: "add", labels: [label()]}); },
    words: () => ["Press ", bold("Add"), " in its row. The model is fitted again with it, in about a second. Undo takes it back at any time."]},
  {title: "The error falls", view: "learn", target: ".ladder, .strip", next: "Finish", words: () => {
    const {before, after, floor} = errors();
    return after === null ? ["The new model is being tested on captures that were not used for it …"]
      : ["On captures that were not used for the fit, the error fell from ", bold(px(before)), " to ", bold(px(after)), floor === null ? "" : "; noise alone leaves " + px(floor), ". ",
        ...truth ? ["And now the truth, which was sealed: hidden was ", bold(truth), "."] : []];
  }},
];

on("truth", message => {
  if (message.number !== asked) return;
  truth = message.label;
  refreshTour();
});
on("opened", () => {
  if (isWaiting) isWaiting = false;
  else if (at >= 0) endTour(); // other captures
  refreshTour();
});

/** Opens the sample and begins the tour. */
export function startTour() {
  if (!act({do: "sample"})) return;
  at = 0;
  truth = "";
  isWaiting = true;
  refreshTour();
}

export function endTour() {
  at = -1;
  isWaiting = false;
  point(null);
  shown?.remove();
  shown = null;
}

export const isTouring = () => at >= 0;

function move(to) {
  if (to >= steps.length) return endTour();
  at = Math.max(0, to);
  if (at === steps.length - 1 && !truth) send({do: "truth", number: asked = Date.now()});
  const {view} = steps[at];
  if (location.hash !== "#" + view) location.hash = view;
  refreshTour();
  shown?.querySelector("button")?.focus({preventScroll: true});
}

function next() {
  const step = steps[at];
  if (step.go && !step.isDone?.()) step.go();
  else move(at + 1);
}

/** The last step before that is still to be done. */
function back() {
  let to = at - 1;
  while (to > 0 && steps[to].isDone?.()) --to;
  move(to);
}

/** Outlines what a step is about. @param {HTMLElement | null} part */
function point(part) {
  if (part === pointed) return;
  pointed?.classList.remove("toured");
  pointed = part;
  if (!part) return;
  part.classList.add("toured");
  part.scrollIntoView({block: "center", behavior: matchMedia("(prefers-reduced-motion: reduce)").matches ? "instant" : "smooth"});
}

/** Draws the present step again; called after every redraw of the page. */
export function refreshTour() {
  if (at < 0) return;
  const failed = state.start?.sample.state === "failed";
  const isReady = !isWaiting && Boolean(state.fit && state.ladder && state.set);
  if (isReady && steps[at].isDone?.()) return move(at + 1);
  const step = steps[at], words = failed ? ["The sample could not be made: " + state.start?.sample.sentence] : isReady ? step.words() : ["The sample is being made: a simulated robot takes 48 pictures …"];
  if (!shown) {
    shown = element("section", {id: "tour", role: "region", "aria-label": "Tour"});
    document.body.append(shown);
  }
  const text = element("div", {"aria-live": "polite"}, element("p", {class: "soft"}, "Step " + (at + 1) + " of " + steps.length), element("h2", {}, step.title), element("p", {}, ...words));
  const content = text.textContent + isReady;
  if (shown.dataset.content !== content) {
    const hadFocus = shown.contains(document.activeElement);
    shown.dataset.content = content;
    shown.replaceChildren(text, element("p", {class: "controls"}, button(step.next ?? "Next", next, {class: "main", id: "tourNext", disabled: !isReady, title: "key →"}),
      button("Back", back, {disabled: at === 0 || !isReady, title: "key ←"}), ...at === steps.length - 1 ? [] : [button("Skip the tour", endTour, {title: "key Esc"})]));
    if (hadFocus || at === 0) shown.querySelector("button")?.focus({preventScroll: true});
  }
  const parts = /** @type {HTMLElement[]} */ ([...document.querySelectorAll(step.target)]);
  point(isReady && location.hash === "#" + step.view ? parts.find(part => part.offsetParent) ?? null : null); // the first that is displayed
}

document.addEventListener("keydown", event => {
  if (at < 0 || event.ctrlKey || event.metaKey || event.altKey || /^(INPUT|SELECT|TEXTAREA)$/.test(/** @type {Element} */ (event.target).tagName) || document.querySelector("dialog[open]")) return;
  if (event.key === "Escape") endTour();
  else if (event.key === "ArrowRight" && !shown?.querySelector("#tourNext")?.matches(":disabled")) next();
  else if (event.key === "ArrowLeft" && at > 0) back();
});
