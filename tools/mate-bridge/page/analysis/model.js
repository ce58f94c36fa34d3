// Model panel beside every analysis view: error ladder, undo, what is missing, effects.
import {button, csv, download, element, renew} from "naocal/lib/dom.js";
import {sized} from "naocal/lib/format.js";
import {errorLadder} from "naocal/plots/error-ladder.js";
import {act, state} from "../core/state.js";
import {findingInShort} from "./finding.js";

export function showModel(parent) {
  const {ladder, fit} = state;
  if (!ladder || !fit) {
    parent.replaceChildren(element("p", {class: "soft"}, state.unfitted ? "There is no fit." : "Fitting the first model …"));
    return;
  }
  renew(parent, strip(parent, ladder), element("h2", {}, "Ladder of errors ", button("CSV", () => saveLadder(ladder), {class: "small", "aria-label": "save as CSV: ladder of errors"})), ladderOf(ladder), historyButtons(ladder), missing(), modelOf(fit));
}

// In narrow windows the panel is folded to this strip, which stays in sight.
function strip(parent, ladder) {
  const {unit} = ladder, {rms, heldOut, floor} = ladder.rungs[ladder.at], isOpen = parent.classList.contains("open");
  const fold = button(isOpen ? "Fold" : "Model", () => { parent.classList.toggle("open"); showModel(parent); }, {class: "small", id: "foldModel", "aria-expanded": String(isOpen), title: "ladder and effects of the model"});
  return element("div", {class: "strip"}, element("b", {}, sized(heldOut ?? rms, unit)), element("span", {class: "soft"}, (heldOut === undefined || heldOut === null ? "fitted" : "held out") + (floor ? "; noise floor " + sized(floor, unit) : "")),
    button("Undo", () => undo(ladder), {class: "small", disabled: !canUndo(ladder), "aria-label": "undo"}), button("Redo", () => redo(ladder), {class: "small", disabled: !canRedo(ladder), "aria-label": "redo"}), fold);
}

// Converts the bridge's ladder for errorLadder; unknown numbers become null.
const ladderOf = ({at, unit, rungs}) => errorLadder(rungs.map(({step, from, rms, heldOut = null, floor = null, alarm = null}) =>
  ({name: step, from, rms, heldOut, floor, alarm})), {at, unit, choose: rung => act({do: "goTo", rung})});

function saveLadder({unit, rungs}) {
  const rows = rungs.map(({step, rms, heldOut, floor, alarm}) => [step || "base model", rms, heldOut, floor, alarm]);
  download("ladder.csv", csv([["model", ...["fitted poses", "held-out error", "noise floor"].map(title => title + " [" + unit + "]"), "chance that noise alone looks this convincing"], ...rows]), "text/csv");
}

// What the search found, in a word; Compare and Learn say the rest.
const missing = () => element("p", {class: "missing", role: "status"}, findingInShort());

// Undo selects the parent of the present model, redo its newest child.
export const canUndo = ({at, rungs}) => rungs[at].from !== null;
export const canRedo = ({at, rungs}) => rungs.some(({from}) => from === at);
export const undo = ({at, rungs}) => act({do: "goTo", rung: rungs[at].from});
export const redo = ({at, rungs}) => act({do: "goTo", rung: rungs.map(({from}) => from).lastIndexOf(at)});

const historyButtons = ladder => element("p", {class: "controls"},
  button("Undo", () => undo(ladder), {disabled: !canUndo(ladder), id: "undo", title: "u"}),
  button("Redo", () => redo(ladder), {disabled: !canRedo(ladder), title: "r"}));

// Effects of the model: added ones, then the base model.
function modelOf(fit) {
  const base = fit.labels.filter(label => !fit.with.includes(label));
  const row = label => element("li", {}, element("span", {}, label),
    button("×", () => act({do: "drop", label}), {class: "small", "aria-label": "remove " + label, title: "remove " + label}));
  /** @type {Node[]} */
  const parts = [element("h2", {}, "In the model")];
  parts.push(fit.with.length ? element("ul", {class: "terms"}, ...fit.with.map(row))
    : element("p", {class: "soft"}, "The base model. Add effects in Learn."));
  const folded = element("details", {}, element("summary", {}, "base model: " + base.length + " effects"), element("ul", {class: "terms"}, ...base.map(row)));
  folded.open = openBase;
  folded.addEventListener("toggle", () => { openBase = folded.open; });
  parts.push(folded);
  if (fit.without.length) {
    parts.push(element("h3", {}, "Taken out"), element("ul", {class: "terms"}, ...fit.without.map(label => element("li", {},
      element("span", {class: "soft"}, label), button("+", () => act({do: "add", labels: [label]}),
        {class: "small", "aria-label": "put " + label + " back"})))));
  }
  return element("div", {}, ...parts);
}
let openBase = false;
