// Every candidate as a row: evidence, size, what was concluded, and what it would do to the errors.

const shownFirst = 12;
let shownState = "", showAll = false;

const detectableWords = ({detectable, unit}) =>
  detectable === null ? "–" : withUnit(String(Number(detectable.toPrecision(2))), unit);

// What else is to be said, under the label.
function remarks({state, why, equivalent, plausible}) {
  const said = [];
  if (why) said.push(why);
  if (equivalent.length) said.push("cannot be told from " + equivalent.join(", "));
  if (!plausible && state !== "no-data") said.push("larger than plausible");
  return said.join("; ");
}

function tipOf(candidate) {
  const {label, state, sizes, power, kept, evidence, pValue, predictedDrop, realDrop, before, after, step} = candidate;
  if (state === "no-data") return label + "\n" + stateWords[state];
  const lines = [label + ": " + stateWords[state], "evidence " + (evidence === null ? "–" : tenths(evidence)) + ", alone " + chance(pValue || 0) +
    (step ? ", after " + step + " additions" : "")];
  sizes.forEach(size => lines.push(sizeWords(size) +
    (size.detectable === null ? "" : "; least seen " + detectableWords(size))));
  lines.push("would be noticed if as large as plausible: " + Math.round(100 * power) + " %");
  lines.push("share that other unknowns do not imitate: " + Math.round(100 * kept) + " %");
  lines.push("chi² falls by " + short(predictedDrop) + " (predicted)" +
    (realDrop === null ? "" : ", " + short(realDrop) + " (refitted)"));
  if (before !== null && after !== null) lines.push("unseen poses: " + px(before) + " → " + px(after));
  return lines.join("\n");
}

function candidateRow(candidate, most) {
  const {label, state, sizes, evidence, predictedDrop, realDrop, before, after} = candidate;
  const row = element("tr"), tested = state !== "no-data";
  const cell = (title, className) => {
    const made = row.appendChild(element("td", className));
    made.dataset.title = title;
    return made;
  };
  const name = cell("effect", "name");
  name.append(element("b", "", label));
  if (remarks(candidate)) name.append(element("small", "", remarks(candidate)));
  const strength = cell("evidence", "strength").appendChild(element("div"));
  strength.append(element("span", "", tested && evidence !== null ? tenths(evidence) : "–"));
  const bar = strength.appendChild(element("div", "axis")).appendChild(element("div", "bar " + state));
  bar.style.width = 100 * Math.max(0, evidence || 0) / most + "%";
  const size = cell("size ± 1 sigma", "number");
  (tested ? sizes : []).forEach(one => size.append(element("div", "", sizeWords(one))));
  cell("verdict").append(element("span", "state " + state, state.replace("-", " ")));
  const least = cell("least seen", "number");
  (tested ? sizes : []).forEach(one => least.append(element("div", "", detectableWords(one))));
  cell("unseen poses", "number").textContent =
    before === null || after === null ? "–" : before.toFixed(2) + " → " + after.toFixed(2) + " px";
  cell("fall of chi²", "number").textContent =
    tested ? short(predictedDrop) + (realDrop === null ? "" : " / " + short(realDrop)) : "–";
  tipOver(row, tipOf(candidate));
  return row;
}

function showCandidates() {
  const chosen = data.candidates.filter(candidate => !shownState || candidate.state === shownState);
  const most = Math.max(1, ...data.candidates.map(candidate => candidate.evidence || 0));
  const shown = showAll ? chosen : chosen.slice(0, shownFirst);
  at("candidates").tBodies[0].replaceChildren(...shown.map(candidate => candidateRow(candidate, most)));
  at("more").hidden = chosen.length <= shownFirst;
  at("more").textContent = showAll ? "show fewer" : "show all " + chosen.length;
  for (const button of at("states").children) button.setAttribute("aria-pressed", button.value === shownState);
}

function offerStates() {
  const offer = (state, words, count) => {
    const button = at("states").appendChild(element("button", "", words + " " + count));
    button.type = "button";
    button.value = state;
    if (state) button.title = stateWords[state];
    button.addEventListener("click", () => { shownState = state; showCandidates(); });
  };
  offer("", "all", data.candidates.length);
  for (const state of Object.keys(stateWords)) {
    const count = data.candidates.filter(candidate => candidate.state === state).length;
    if (count) offer(state, state.replace("-", " "), count);
  }
  at("more").addEventListener("click", () => { showAll = !showAll; showCandidates(); });
}

// In words: what these captures cannot tell, and why.
function showUntested(parent) {
  const list = element("ul", "untested");
  const tell = (title, words, members) => {
    if (!members.length) return;
    const item = list.appendChild(element("li"));
    item.append(element("b", "", title), element("span", "", words), element("small", "", members.join(", ")));
  };
  const of = state => data.candidates.filter(candidate => candidate.state === state);
  for (const why of new Set(of("no-data").map(candidate => candidate.why))) {
    tell(why || "its driver was not recorded", ": record it to test", of("no-data").filter(
      candidate => candidate.why === why).map(candidate => candidate.label));
  }
  tell("these poses cannot test", ": what is already in the model can do the same in them, or hardly anything moves " +
    "it; other poses may tell", of("absorbed").map(candidate => candidate.label));
  tell("too small to be seen", ": these could be there, smaller than what is written beside each", of("inconclusive").map(
    ({label, sizes}) => label + " (" + sizes.map(detectableWords).join(", ") + ")"));
  if (list.children.length) parent.append(list);
  else parent.append(element("p", "", "Every candidate could be tested."));
}
