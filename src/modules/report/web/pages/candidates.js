// The candidate table, and the list of candidates that these captures cannot test.
import {at, bold, element, renew} from "naocal/lib/dom.js";
import {detectableWords} from "naocal/lib/format.js";
import {groupBy} from "naocal/lib/statistics.js";
import {brokenLabel, candidateTable, columns, ofState, remarks, stateButtons} from "naocal/plots/candidate-table.js";

/** @import {Candidate} from "naocal/lib/types.js" */
/** @import {Column} from "naocal/plots/candidate-table.js" */

const shownFirst = 12;

/** @type {Column} */
const effect = {title: "effect", className: "name", cell: one => [element("b", {}, ...brokenLabel(one.label)),
  remarks(one) ? element("small", {}, remarks(one)) : null]};
const {evidence, size, verdict, detectable, heldOut, fall} = columns;

/** @param {Candidate[]} candidates */
export function showCandidates(candidates) {
  let state = "", all = false;
  const most = Math.max(1, ...candidates.map(({evidence}) => evidence || 0)), more = at("more");
  const show = () => {
    const chosen = ofState(candidates, state);
    renew(at("states"), ...stateButtons(candidates, state, value => { state = value; show(); }));
    renew(at("candidates"), candidateTable(all ? chosen : chosen.slice(0, shownFirst), [effect, evidence, size, verdict, detectable, heldOut, fall], {most}));
    more.hidden = chosen.length <= shownFirst;
    more.textContent = all ? "show fewer" : "show all " + chosen.length;
  };
  more.addEventListener("click", () => { all = !all; show(); });
  show();
}

/** List of the candidates that these captures cannot test or separate, with reasons. @param {Candidate[]} candidates */
export function untested(candidates) {
  const of = (/** @type {string} */ state) => candidates.filter(candidate => candidate.state === state);
  const item = (/** @type {string} */ title, /** @type {string} */ words, /** @type {string[]} */ members) =>
    members.length ? element("li", {}, bold(title), element("span", {}, words), element("small", {}, members.join(", "))) : null;
  const items = [
    ...[...groupBy(of("no-data"), ({why}) => why)].map(([why, list]) =>
      item(String(why) || "its driver was not recorded", ": record it to test", list.map(({label}) => label))),
    item("not testable here", ": other parameters of the model imitate it in these poses, or hardly anything moves it; other poses may tell",
      of("absorbed").map(({label}) => label)),
    item("undecided", ": may be there, below the size beside each", of("inconclusive").map(({label, sizes}) =>
      label + " (" + sizes.map(detectableWords).join(", ") + ")"))].filter(Boolean);
  return items.length ? element("ul", {class: "untested"}, ...items) : element("p", {}, "Every candidate could be tested.");
}
