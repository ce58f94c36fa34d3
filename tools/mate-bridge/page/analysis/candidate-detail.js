// The selected candidate: its effect, the verdict, and every view of one candidate.
import {button, element} from "naocal/lib/dom.js";
import {capitalized, chance, detectableWords, percent, short, sizeWords, stateName, stateWords, withUnit} from "naocal/lib/format.js";
import {views} from "naocal/views/views.js";
import {act, state} from "../core/state.js";

export function candidateDetail(candidate, diagnosis) {
  const [name, place] = candidate.label.split("@"), effect = state.set.effects.find(one => one.name === name);
  /** @type {Node[]} */
  const parts = [element("h2", {}, candidate.label), element("p", {}, effect ? sentenceOf(effect.what) : "", element("span", {class: "soft"},
    " " + (place === "all" ? "Everywhere." : "At " + place + ".")))];
  if (effect) {
    parts.push(element("p", {}, element("code", {}, effect.formula)), element("p", {class: "soft"}, "Plausible (1 sigma): " +
      effect.unknowns.map(({name: unknown, sigma, unit}) => unknown + " ± " + withUnit(short(sigma), unit)).join(", ") + "."));
  }
  const facts = [[stateName(candidate.shown), stateWords(candidate.shown)]], isTested = candidate.state !== "no-data" && !candidate.setUp;
  if (candidate.why) facts.push(["why", candidate.why]);
  if (isTested) {
    facts.push(["size", candidate.sizes.map(sizeWords).join(", ") + (candidate.plausible ? "" : ": larger than plausible")]);
    facts.push(["smallest detectable", candidate.sizes.map(detectableWords).join(", ") + " (90 % power)"]);
    if (candidate.pValue !== null) facts.push(["by chance", chance(candidate.pValue)]);
    facts.push(["power", percent(candidate.power) + " at a plausible size"]);
    facts.push(["signature", percent(candidate.kept) + " of it is unique; other parameters can mimic the rest"]);
  }
  if (candidate.equivalent.length) facts.push(["alias of", candidate.equivalent.join(", ") + ": these captures cannot tell them apart"]);
  parts.push(element("dl", {class: "facts"}, ...facts.flatMap(([term, words]) => [element("dt", {}, term), element("dd", {}, words)])));
  if (isTested) parts.push(element("p", {}, button("Add " + candidate.label, () => act({do: "add", labels: [candidate.label]}), {class: "main"})));
  for (const {title, ofCandidate} of views) {
    const shown = ofCandidate?.(candidate, diagnosis, {});
    if (shown) parts.push(element("h3", {}, title), ...shown.filter(part => part !== null));
  }
  return parts;
}

const sentenceOf = text => capitalized(text) + ".";
