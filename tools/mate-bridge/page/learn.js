// Learn: every effect at every place and the evidence for it.
import {make, button, csv, download, empty} from "./elements.js";
import {short, tenths, px, sizeWords, stateWords, stateName, waitingWords} from "./words.js";
import {detail} from "./looked.js";
import {state, act} from "./state.js";

const shown = {state: "", all: false, label: null};
const shownFirst = 15;

export function showLearn(parent) {
  const {questions} = state;
  if (!questions) {
    parent.replaceChildren(make("h1", {}, "What is missing?"), empty(waitingWords(state.fit),
      "How much of the misfit would each effect at each place explain?"));
    return;
  }
  const again = () => showLearn(parent);
  const chosen = questions.candidates.filter(candidate => !shown.state || candidate.state === shown.state);
  const looked = questions.candidates.find(({label}) => label === shown.label) || questions.candidates[0];
  parent.replaceChildren(
    verdict(questions),
    make("div", {class: "split learn"},
      make("div", {}, make("h2", {}, "Candidates"), states(questions, again), table(chosen, questions, looked, again)),
      make("div", {class: "looked"}, ...(looked ? detail(looked, questions, again) : []))));
}

function verdict(questions) {
  const {headline, sentence} = questions, stem = headline.replace(/\.$/, "");
  const rest = sentence.startsWith(stem) ? sentence.slice(stem.length).replace(/^[\s:,;.]+/, "") : sentence; // it says the headline again
  return make("div", {class: "verdict " + questions.verdict}, make("h1", {}, headline), make("p", {}, rest.charAt(0).toUpperCase() + rest.slice(1)));
}

function states({candidates}, again) {
  const offer = (value, words, count) => button(words + " " + count, () => { shown.state = value; again(); },
    {"aria-pressed": String(shown.state === value), title: stateWords[value], class: "small"});
  return make("div", {class: "controls"}, offer("", "all", candidates.length), ...Object.keys(stateWords).map(value => {
    const count = candidates.filter(candidate => candidate.state === value).length;
    return count ? offer(value, stateName(value), count) : null;
  }), button("CSV", () => save(candidates), {class: "small"}));
}

function table(chosen, {candidates}, looked, again) {
  if (!chosen.length) return make("p", {class: "soft"}, "There is no such candidate now.");
  const most = Math.max(1, ...candidates.map(({evidence}) => evidence || 0));
  const head = (words, title, className) => make("th", {scope: "col", title, class: className}, words);
  const body = make("tbody", {}, ...(shown.all ? chosen : chosen.slice(0, shownFirst)).map(one => row(one, most, one === looked, again)));
  return make("div", {},
    make("table", {class: "candidates"}, make("thead", {}, make("tr", {}, head("effect", "an effect at a place"),
      head("evidence", "how much better the captures are explained with it than without, its size weighed against what is plausible"),
      head("size ± 1 sigma", "as these captures tell it"), head("what it would bring", "the error on unseen poses now and with it; and how far χ², the sum of squared misfits, would fall: of the best ones as found by refitting, of others as predicted", "number"), make("td", {}))), body),
    chosen.length > shownFirst ? button(shown.all ? "show fewer" : "show all " + chosen.length, () => { shown.all = !shown.all; again(); }) : null);
}

function row(candidate, most, isLooked, again) {
  const {label, state: verdict, sizes, evidence, predictedDrop, realDrop, before, after} = candidate;
  const tested = verdict !== "no-data";
  const bar = make("span", {class: "bar " + verdict});
  bar.style.width = 100 * Math.max(0, evidence || 0) / most + "%";
  const look = event => { if (event.target.closest(".add")) return; shown.label = label; again(); };
  return make("tr", {class: isLooked ? "is-looked" : "", onclick: look},
    make("td", {class: "name"}, make("button", {type: "button", class: "plain", "aria-pressed": String(isLooked)}, label.split("@")[0] + "@", make("wbr"), label.split("@")[1]),
      make("span", {class: "state " + verdict, title: stateWords[verdict]}, stateName(verdict))),
    make("td", {class: "strength"}, make("span", {class: "number"}, tested && evidence !== null ? tenths(evidence) : "–"), make("span", {class: "axis"}, bar)),
    make("td", {}, ...(tested ? sizes : []).map(size => make("div", {class: "nowrap"}, sizeWords(size)))),
    make("td", {class: "number"}, make("div", {}, before === null || after === null ? "–" : before.toFixed(2) + " → " + after.toFixed(2) + " px"),
      tested ? make("div", {class: "soft"}, "χ² falls by " + short(realDrop ?? predictedDrop)) : null),
    make("td", {}, tested ? button("Add", () => act({do: "add", label}), {class: "add small", "aria-label": "add " + label}) : null));
}

function save(candidates) {
  const rows = [["effect", "state", "evidence", "sizes", "p", "predicted fall of chi2", "found fall of chi2", "unseen before [px]", "unseen after [px]"]];
  for (const one of candidates) {
    rows.push([one.label, one.state, one.evidence, one.sizes.map(sizeWords).join("; "), one.pValue, one.predictedDrop, one.realDrop, one.before, one.after]);
  }
  download("candidates.csv", csv(rows), "text/csv");
}
