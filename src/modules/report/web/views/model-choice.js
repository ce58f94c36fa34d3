// Select of the model whose residuals a view shows.
import {choosing} from "naocal/lib/dom.js";

/** @import {Diagnosis, Left} from "naocal/lib/types.js" */

const names = {asGiven: "base model", withSuggested: "with the suggested effects"};

/** @param {string} id of the choice @param {Diagnosis} data @param {(left: Left) => Node} show */
export function modelChoice(id, {left}, show) {
  const models = /** @type {("asGiven" | "withSuggested")[]} */ (Object.keys(names)).filter(model => left[model]);
  return choosing(id, "Model", models.map(value => ({value, text: names[value]})),
    model => show(/** @type {Left} */ (left[/** @type {"asGiven"} */ (model)])));
}
