// Result view: estimates with error bars.
import {button, csv, download, element} from "naocal/lib/dom.js";
import {findingList} from "naocal/plots/finding-list.js";
import {drawEstimates, drawingSize, estimates, titleOf} from "naocal/plots/estimates.js";
import {offscreenButtons} from "../core/figure-export.js";
import {state} from "../core/state.js";
import {applying} from "./apply-result.js";

export function showResult(parent) {
  const {fit} = state;
  parent.replaceChildren(
    element("div", {class: "verdict " + fit.verdict}, element("h1", {}, fit.headline), element("p", {}, fit.sentence), ...findingList(fit.findings),
      element("dl", {class: "figures"}, ...fit.facts.map(({figure, sentence}) => element("div", {}, element("dt", {}, figure), element("dd", {}, sentence))))),
    ...applying(fit, () => showResult(parent)),
    element("div", {class: "controls"}, button("CSV", () => save(fit), {class: "small"}),
      element("span", {class: "soft"}, "Bars: 95 % intervals. ±: one standard error. Learned: the share of the prior uncertainty that these captures removed.")),
    ...fit.groups.flatMap(group));
}

const group = one => [
  element("h2", {class: "controls"}, titleOf(one), element("span", {class: "savers"},
    ...offscreenButtons(one.title, (context, width, height) => drawEstimates(context, width, height, one), drawingSize(one)))),
  estimates(one)];

function save({groups}) {
  const rows = [["effect", "at", "unit", "value", "standard error", "lower end of 95 %", "upper end of 95 %", "learned"]];
  for (const {title, unit, rows: estimates} of groups) {
    for (const {name, value, sigma, low, high, learned} of estimates) rows.push([title, name, unit, value, sigma, low, high, learned]);
  }
  download("estimates.csv", csv(rows), "text/csv");
}
