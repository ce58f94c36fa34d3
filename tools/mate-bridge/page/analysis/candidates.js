// Learn view: all candidates with their evidence.
import {button, csv, download, element, empty} from "naocal/lib/dom.js";
import {short, sizeWords, waitingWords} from "naocal/lib/format.js";
import {brokenLabel, candidateTable, columns, ofState, stateButtons, stateChip} from "naocal/plots/candidate-table.js";
import {views} from "naocal/views/views.js";
import {candidateDetail} from "./candidate-detail.js";
import {finding} from "./finding.js";
import {act, state} from "../core/state.js";

const shown = {state: "", all: false, label: ""};
const shownFirst = 15;

export function showLearn(parent) {
  const {diagnosis} = state;
  if (!diagnosis) {
    parent.replaceChildren(element("h1", {}, "What is missing?"), empty(waitingWords(state.fit),
      "How much of the misfit would each effect at each place explain?"));
    return;
  }
  const again = () => showLearn(parent);
  const {candidates} = diagnosis, chosen = ofState(candidates, shown.state);
  const looked = candidates.find(({label}) => label === shown.label) || candidates[0];
  parent.replaceChildren(
    finding("h1"),
    element("div", {class: "split learn"},
      element("div", {}, element("h2", {}, "Candidates"), element("div", {class: "controls"},
        ...stateButtons(candidates, shown.state, value => { shown.state = value; again(); }).filter(Boolean),
        button("CSV", () => save(candidates), {class: "small"})), table(chosen, candidates, looked, again), ...together(diagnosis)),
      element("div", {class: "looked"}, ...(looked ? candidateDetail(looked, diagnosis) : []))));
}

function table(chosen, candidates, looked, again) {
  if (!chosen.length) return element("p", {class: "soft"}, "There is no such candidate now.");
  const most = Math.max(1, ...candidates.map(({evidence}) => evidence || 0));
  const effect = {title: "effect", words: "an effect at a place", className: "name", cell: one => [
    element("button", {type: "button", class: "plain", "aria-pressed": String(one === looked)}, ...brokenLabel(one.label)), stateChip(one)]};
  const gain = {title: "what it would bring", className: "number", words: "held-out error now and with it; and the fall of χ², the sum of squared misfits: " +
    "found by refitting for the best ones, predicted for the others", cell: one => [...columns.heldOut.cell(one, most),
    one.state === "no-data" || one.setUp ? null : element("div", {class: "soft"}, "χ² falls by " + short(one.realDrop ?? one.predictedDrop))]};
  const add = {title: "", cell: ({label, state: found, setUp}) => [found === "no-data" ? null
    : button(setUp ? "Mend" : "Add", () => act({do: "add", labels: [label]}), {class: "add small", "aria-label": (setUp ? "mend " : "add ") + label})]};
  return element("div", {},
    candidateTable(shown.all ? chosen : chosen.slice(0, shownFirst), [effect, columns.evidence, columns.size, gain, add], {most, rowOf: one => ({
      class: one === looked ? "is-looked" : "",
      onclick: event => { if (!event.target.closest(".add")) { shown.label = one.label; again(); } },
    })}),
    chosen.length > shownFirst ? button(shown.all ? "show fewer" : "show all " + chosen.length, () => { shown.all = !shown.all; again(); }) : null);
}

// Views of all candidates; views of one candidate are shown beside the table.
const together = diagnosis => views.filter(({about, ofCandidate}) => about === "candidates" && !ofCandidate).flatMap(({title, show}) => {
  const parts = show(diagnosis, {});
  return parts ? [element("h2", {}, title), ...parts] : [];
});

function save(candidates) {
  const rows = [["effect", "state", "evidence", "sizes", "p", "predicted fall of chi2", "found fall of chi2", ...["before", "after"].map(when => "held-out error " + when + " [" + state.ladder.unit + "]")]];
  for (const one of candidates) {
    rows.push([one.label, one.state, one.evidence, one.sizes.map(sizeWords).join("; "), one.pValue, one.predictedDrop, one.realDrop, one.before, one.after]);
  }
  download("candidates.csv", csv(rows), "text/csv");
}
