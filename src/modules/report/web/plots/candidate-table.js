// Candidate table: evidence, size, state, and effect on the errors.
import {button, element, tipOver} from "naocal/lib/dom.js";
import {allStates, chance, detectableWords, percent, short, sized, sizeWords, stateName, stateTip, tenths} from "naocal/lib/format.js";

/** @import {Candidate} from "naocal/lib/types.js" */

/** A column: `cell` fills a candidate's cell. @typedef {{title: string, words?: string, className?: string, cell: (candidate: Candidate, most: number) => (Node | string | null)[]}} Column */

/** @param {Candidate} candidate */
const isTested = ({state, setUp}) => state !== "no-data" && !setUp;

/** @param {Candidate} candidate */
export const stateChip = candidate => element("span", {class: "state " + candidate.state}, stateName(candidate.shown));

/** Splits a label after its at sign, where a line may break: "elasticity@", "LKneePitch". @param {string} label */
export const brokenLabel = label => label.split(/(?<=@)/).flatMap((part, i) => i ? [element("wbr"), part] : [part]);

/** @param {Candidate} candidate @param {number} most */
function strength({state, evidence}, most) {
  const bar = element("span", {class: "bar " + state});
  bar.style.width = 100 * Math.max(0, evidence || 0) / most + "%";
  return [element("span", {class: "number"}, state !== "no-data" && evidence !== null ? tenths(evidence) : "–"), element("span", {class: "axis"}, bar)];
}

/** Available columns. */
export const columns = {
  /** @type {Column} */
  evidence: {title: "evidence", className: "strength", cell: strength,
    words: "how much better the captures are explained with it than without, its size weighed against what is plausible"},
  /** @type {Column} */
  size: {title: "size ± 1 sigma", words: "as these captures tell it", className: "sizes",
    cell: one => (isTested(one) ? one.sizes : []).map(size => element("div", {}, sizeWords(size)))},
  /** @type {Column} */
  verdict: {title: "verdict", cell: one => [stateChip(one)]},
  /** @type {Column} */
  detectable: {title: "smallest detectable", words: "the size that is noticed in 9 of 10 cases", className: "number",
    cell: one => (isTested(one) ? one.sizes : []).map(size => element("div", {}, detectableWords(size)))},
  /** @type {Column} */
  heldOut: {title: "held-out error", words: "error on poses that were not fitted, without and with it", className: "number",
    cell: ({before, after, errorUnit}) => [before === null || after === null ? "–" : sized(before, errorUnit).replace(/\s?[^\d.]*$/, "") + " → " + sized(after, errorUnit)]},
  /** @type {Column} */
  fall: {title: "fall of χ²", words: "predicted / found by refitting", className: "number",
    cell: one => [isTested(one) ? short(one.predictedDrop) + (one.realDrop === null ? "" : " / " + short(one.realDrop)) : "–"]},
};

/** Remarks shown below the label. @param {Candidate} candidate */
export const remarks = ({state, why, equivalent, plausible}) => [why,
  equivalent.length ? "cannot be told from " + equivalent.join(", ") : "",
  !plausible && state !== "no-data" ? "larger than plausible" : ""].filter(Boolean).join("; ");

/** Tooltip with all numbers of a candidate. @param {Candidate} candidate */
function candidateTip(candidate) {
  const {label, sizes, power, kept, evidence, pValue, predictedDrop, realDrop, before, after, step, errorUnit, setUp} = candidate;
  if (setUp) return label + "\na suspected set-up: " + candidate.why;
  if (!isTested(candidate)) return label + "\n" + stateTip(candidate.shown);
  return [label, stateTip(candidate.shown), "evidence " + (evidence === null ? "–" : tenths(evidence)) + ", alone " + chance(pValue || 0) +
    (step ? ", after " + step + " additions" : ""),
  ...sizes.map(size => sizeWords(size) + (size.detectable === null ? "" : "; smallest detectable " + detectableWords(size))),
  "chance to notice a plausible size: " + percent(power ?? 0), "share that other parameters cannot mimic: " + percent(kept ?? 0),
  "χ² falls by " + short(predictedDrop) + " (predicted)" + (realDrop === null ? "" : ", " + short(realDrop) + " (refitted)"),
  ...(before !== null && after !== null ? ["held-out error: " + sized(before, errorUnit) + " → " + sized(after, errorUnit)] : [])].join("\n");
}

/**
 * @param {Candidate[]} candidates the rows
 * @param {Column[]} shown
 * @param {{most: number, rowOf?: (candidate: Candidate) => Record<string, any>}} options `most`: evidence of the longest
 *   bar; `rowOf`: attributes of a candidate's row
 */
export const candidateTable = (candidates, shown, {most, rowOf = () => ({})}) => element("table", {class: "candidates"},
  element("thead", {}, element("tr", {}, ...shown.map(({title, words, className}) =>
    title ? element("th", {scope: "col", title: words, class: className}, title) : element("td")))),
  element("tbody", {}, ...candidates.map(candidate => tipOver(element("tr", rowOf(candidate), ...shown.map(({title, className, cell}) =>
    element("td", {class: className, "data-title": title}, ...cell(candidate, most)))), candidateTip(candidate)))));

/** Candidates of a state; "" for all. @param {Candidate[]} candidates @param {string} state */
export const ofState = (candidates, state) => candidates.filter(candidate => !state || candidate.shown === state);

/**
 * Filter buttons, one per state.
 * @param {Candidate[]} candidates
 * @param {string} shown "" for all
 * @param {(state: string) => void} choose
 */
export const stateButtons = (candidates, shown, choose) => ["", ...allStates].map(state => {
  const count = ofState(candidates, state).length;
  return count || !state ? button((state ? stateName(state) : "all") + " " + count, () => choose(state),
    {"aria-pressed": String(shown === state), title: state ? stateTip(state) : undefined, class: "small"}) : null;
});
