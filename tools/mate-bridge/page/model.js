// The model beside every laboratory view: the ladder of errors, what is in the model, undo, and the search.
import {make, button, csv, download, renew} from "./elements.js";
import {px3, chance} from "./words.js";
import {state, act} from "./state.js";

export function showModel(parent) {
  const {ladder, fit} = state;
  if (!ladder || !fit) {
    parent.replaceChildren(make("p", {class: "soft"}, state.unfitted ? "There is no fit." : "Fitting the first model …"));
    return;
  }
  renew(parent, make("h2", {}, "Ladder of errors ", button("CSV", () => saveLadder(ladder), {class: "small", "aria-label": "save as CSV: ladder of errors"})), ladderOf(ladder), historyButtons(ladder), modelOf(fit), search());
}

// A bar per model: the error on poses it has not seen, hollow while only the error of the fit is known; the grey band
// is what noise would leave.
function ladderOf({at, rungs}) {
  const floors = rungs.filter(rung => rung.floor !== undefined).map(rung => rung.floor);
  const floor = floors.length ? floors[floors.length - 1] : 0;
  const error = rung => rung.heldOut === undefined ? rung.rms : rung.heldOut;
  const most = 1.04 * Math.max(floor, ...rungs.map(error));
  const list = make("ol", {class: "ladder"});
  rungs.forEach((rung, i) => {
    const isKnown = rung.heldOut !== undefined;
    const bar = make("span", {class: "bar" + (isKnown ? "" : " open")});
    const band = make("span", {class: "band"});
    bar.style.width = 100 * error(rung) / most + "%";
    band.style.width = 100 * (rung.floor === undefined ? floor : rung.floor) / most + "%";
    const origin = rung.from === null || rung.from === i - 1 ? "" : "made from: " + (rungs[rung.from].step || "base model") + "\n";
    const words = origin + (!isKnown ? "fitted poses: " + px3(rung.rms) + "; held-out error: not known yet"
      : "held-out error: " + px3(rung.heldOut) + "\nfitted poses: " + px3(rung.rms) + "\nnoise floor: " + px3(rung.floor) +
        "\nchance that noise alone looks this convincing: " + chance(rung.alarm));
    list.append(make("li", {}, make("button", {
      type: "button", class: "rung", title: words, "aria-current": i === at ? "step" : null,
      onclick: () => { act({do: "goTo", rung: i}); },
    }, make("span", {class: "name"}, ...(rung.step || "base model").split(/(?<=@)/).flatMap((part, at) => at ? [make("wbr"), part] : [part])), make("span", {class: "number" + (isKnown ? "" : " soft")}, isKnown ? px3(rung.heldOut) : px3(rung.rms) + " fitted"),
      make("span", {class: "axis"}, band, bar))));
  });
  list.append(make("li", {class: "floor soft"}, make("span", {}, "noise floor"), make("span", {class: "number"},
    floor ? px3(floor) : "…")));
  return list;
}

function saveLadder({rungs}) {
  const rows = rungs.map(({step, rms, heldOut, floor, alarm}) => [step || "base model", rms, heldOut, floor, alarm]);
  download("ladder.csv", csv([["model", "fitted poses [px]", "held-out error [px]", "noise floor [px]", "p that it is chance"], ...rows]), "text/csv");
}

// Undo goes to the model that the current one was made from, redo to the newest that was made from it.
export const canUndo = ({at, rungs}) => rungs[at].from !== null;
export const canRedo = ({at, rungs}) => rungs.some(rung => rung.from === at);
export const undo = ({at, rungs}) => act({do: "goTo", rung: rungs[at].from});
export const redo = ({at, rungs}) => act({do: "goTo", rung: rungs.map(rung => rung.from).lastIndexOf(at)});

function historyButtons(ladder) {
  return make("p", {class: "controls"},
    button("Undo", () => undo(ladder), {disabled: !canUndo(ladder), id: "undo", title: "u"}),
    button("Redo", () => redo(ladder), {disabled: !canRedo(ladder), title: "r"}));
}

// What is in the model; what was added stands first, the base below.
function modelOf(fit) {
  const base = fit.labels.filter(label => !fit.with.includes(label));
  const row = label => make("li", {}, make("span", {}, label),
    button("×", () => act({do: "drop", label}), {class: "small", "aria-label": "remove " + label, title: "remove " + label}));
  const parts = [make("h2", {}, "In the model")];
  parts.push(fit.with.length ? make("ul", {class: "terms"}, ...fit.with.map(row))
    : make("p", {class: "soft"}, "The base model. Add effects in Learn."));
  const folded = make("details", {}, make("summary", {}, "base: " + base.length + " effects"), make("ul", {class: "terms"}, ...base.map(row)));
  folded.open = openBase;
  folded.addEventListener("toggle", () => { openBase = folded.open; });
  parts.push(folded);
  if (fit.without.length) {
    parts.push(make("h3", {}, "Taken out"), make("ul", {class: "terms"}, ...fit.without.map(label => make("li", {},
      make("span", {class: "soft"}, label), button("+", () => act({do: "add", label}),
        {class: "small", "aria-label": "put " + label + " back"})))));
  }
  return make("div", {}, ...parts);
}
let openBase = false;

// What was found is still worth reading while only that was added.
const stillTrue = ({with: began, suggested}) => began.every(label => state.fit.with.includes(label)) &&
  state.fit.with.every(label => began.includes(label) || suggested.includes(label));

// Everything that is missing, found by the bridge; added only when the person says so.
function search() {
  const searching = Boolean(state.work && state.work.startsWith("searching"));
  const part = make("div", {class: "search"}, make("h2", {}, "Automatic search"), make("p", {class: "controls"},
    button("Find missing effects", () => act({do: "search"}), {disabled: searching}),
    searching ? button("Stop searching", () => act({do: "cancel"}), {title: "after the addition that it is at; what it has found so far is kept"}) : null));
  if (state.found && stillTrue(state.found)) {
    part.append(make("p", {}, (state.found.stopped ? "Stopped before its end. " : "") + state.found.sentence));
    for (const label of state.found.suggested) {
      const has = state.fit.with.includes(label);
      part.append(make("p", {class: "controls"}, button(has ? label + " is in" : "Add " + label, () => act({do: "add", label}), {disabled: has})));
    }
  }
  return part;
}
