// The result: what the fit found, each estimate with its error bar.
import {applying} from "./apply.js";
import {make, button, csv, download} from "./elements.js";
import {ticks} from "./canvas.js";
import {savers} from "./bars.js";
import {withError, number} from "./words.js";
import {state} from "./state.js";

export function showResult(parent) {
  const {fit} = state;
  parent.replaceChildren(
    make("div", {class: "verdict " + fit.verdict}, make("h1", {}, fit.headline), make("p", {}, fit.sentence),
      make("dl", {class: "figures"}, ...fit.facts.map(({figure, sentence}) => make("div", {}, make("dt", {}, figure), make("dd", {}, sentence)))),
      fit.warnings.length ? make("ul", {class: "warnings"}, ...fit.warnings.map(warning => make("li", {}, warning))) : null),
    ...applying(fit, () => showResult(parent)),
    make("div", {class: "controls"}, button("CSV", () => save(fit), {class: "small"}),
      make("span", {class: "soft"}, "bars: 95 % intervals, ±: one standard error; at the right how much these captures taught, from what was plausible before")),
    ...fit.groups.flatMap(group));
}

function group({title, unit, rows}) {
  const ends = rows.flatMap(({low, high}) => [low, high, 0]), low = Math.min(...ends), high = Math.max(...ends);
  const margin = 0.04 * (high - low || 1), place = value => 100 * (value - low + margin) / (high - low + 2 * margin) + "%";
  const marks = ticks(low - margin, high + margin, 6);
  const scale = make("div", {class: "ticks"});
  for (const mark of marks) scale.appendChild(make("span", {}, number(mark))).style.left = place(mark);
  return [make("h2", {class: "controls"}, title.charAt(0).toUpperCase() + title.slice(1) + (unit ? " [" + unit + "]" : ""), make("span", {class: "savers"}, ...savers({title, unit, rows}))),
    make("div", {class: "estimates"}, ...rows.map(row => estimate(row, unit, place, marks)), make("div", {class: "estimate"}, make("span"), scale))];
}

function estimate({name, value, sigma, low, high, learned}, unit, place, marks) {
  const axis = make("div", {class: "axis"}), share = Math.round(100 * Math.max(0, learned));
  for (const mark of marks) axis.appendChild(make("i", {class: mark === 0 ? "zero" : ""})).style.left = place(mark);
  const bar = axis.appendChild(make("span", {class: "bar"}));
  bar.style.left = place(low);
  bar.style.right = "calc(100% - " + place(high) + ")";
  axis.appendChild(make("span", {class: "dot"})).style.left = place(value);
  const told = make("span", {class: "learned number" + (learned < 0.5 ? " little" : "")}, make("span", {}, share + " %"));
  told.style.setProperty("--share", share + "%");
  return make("div", {class: "estimate"}, make("span", {}, name), axis, make("span", {class: "number"}, withError(value, sigma, unit)), told);
}

function save({groups}) {
  const rows = [["effect", "at", "unit", "value", "standard error", "lower end of 95 %", "upper end of 95 %", "learned"]];
  for (const {title, unit, rows: estimates} of groups) {
    for (const {name, value, sigma, low, high, learned} of estimates) rows.push([title, name, unit, value, sigma, low, high, learned]);
  }
  download("estimates.csv", csv(rows), "text/csv");
}
