// What the search found: its sentence, what to do about it, and the picture of its cause.
import {button, choosing, element} from "naocal/lib/dom.js";
import {captureNames} from "naocal/lib/captures.js";
import {capitalized, sized} from "naocal/lib/format.js";
import {findingList} from "naocal/plots/finding-list.js";
import {partialResiduals, partialWords} from "naocal/plots/partial-residuals.js";
import {act, state} from "../core/state.js";

const searching = "Searching for what is missing …";

/** In a few words, for every view. */
export const findingInShort = () => state.diagnosis ? state.diagnosis.headline : state.unsearched ? "The search failed." : searching;

/** The verdict with its actions; while the search runs, what is certain. @param {"h1" | "h2"} heading */
export function finding(heading) {
  const {diagnosis, ladder, unsearched} = state;
  if (!diagnosis) {
    const {rms} = ladder.rungs[ladder.at];
    return element("div", {class: "verdict finding searching", role: "status"}, element(heading, {}, findingInShort()),
      element("p", {}, "The fit leaves " + sized(rms, ladder.unit) + " rms. " + (unsearched ? capitalized(unsearched.sentence.replace(/\.?$/, ".")) : "Every known effect is being tested at every place.")));
  }
  const {headline, sentence, verdict} = diagnosis, stem = headline.replace(/\.$/, "");
  const rest = sentence.startsWith(stem) ? sentence.slice(stem.length).replace(/^[\s:,;.]+/, "") : sentence; // drops the repeated headline
  return element("div", {class: "verdict finding " + verdict}, element(heading, {}, headline, " ", usable(diagnosis.level)), element("p", {}, capitalized(rest)),
    element("dl", {class: "figures brief"}, ...diagnosis.facts.slice(0, 3).map(({figure, sentence}) => element("div", {}, element("dt", {}, figure), element("dd", {}, sentence)))),
    actions(diagnosis), ...findingList(diagnosis.findings));
}

/** Whether the calibration may be used as it is. */
const usable = level => level === "stop" ? element("span", {class: "level stop"}, "do not use yet") : level === "act" ? element("span", {class: "level act"}, "usable meanwhile") : null;

/** Buttons that mend a set-up, or else add what is suggested; and that leave out captures which do not belong. */
function actions({suggested, own, curves, candidates, tentative, leaveOut}) {
  const setUps = candidates.filter(({setUp}) => setUp).map(({label}) => label), isMended = setUps.length > 0;
  const labels = isMended ? setUps : own ? suggested.slice(0, -1) : suggested, verb = isMended ? "Mend " : "Add ", waits = tentative && !isMended;
  const add = (...labels) => act({do: "add", labels});
  const buttons = [
    ...waits ? [button("Suggest poses", () => { location.hash = "next"; }, {class: "main"})] : [],
    ...labels.length > 1 ? [button(verb + "all " + labels.length, () => add(...labels), {class: "main"})] : [],
    ...labels.map(label => button(verb + label, () => add(label), {class: labels.length > 1 || waits ? "" : "main"})),
    ...!isMended && own && curves[0]?.model ? [button("Add it as a custom effect", () => act({do: "define", effect: curves[0].model.define[0]}), {class: "main"})] : [],
  ];
  buttons.push(...leaveOut.slice(0, 3).map(label => button("Leave out " + label.replace("leftOut@", "").replace(":", " "), () => add(label), {class: buttons.length ? "" : "main"})));
  return buttons.length ? element("p", {class: "controls"}, ...buttons) : null;
}

/** The capture of the fit that a diagnosis lists at this place. @param {number} index @returns {any} */
export const captureAt = index => [...state.fit.pictures, ...state.fit.captures].find(one => one.index === index) ?? null;

/** The error that the cause makes and what remains with it; null without a cause. @param {(picture: any) => void} choose shows a capture */
export function causePlots(choose) {
  const {diagnosis} = state;
  if (!diagnosis?.causes.length) return null;
  const {causes} = diagnosis, {capturesName} = captureNames(diagnosis);
  const show = label => partialResiduals(causes.find(cause => cause.label === label) ?? causes[0], {nameOf: capturesName, open: index => choose(captureAt(index))});
  return element("div", {class: "cause"}, diagnosis.verdict === "adequate" ? element("h2", {}, "Certain, but too small to matter") : null, choosing("cause", "Cause", causes.map(({label}) => ({value: label, text: label})), show), element("p", {class: "soft"}, partialWords));
}
