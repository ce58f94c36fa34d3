// Findings beyond the first, which the head tells: what is to be done is listed, notes open on a click.
import {element} from "naocal/lib/dom.js";

/** @import {Finding} from "naocal/lib/types.js" */

const list = (/** @type {Finding[]} */ findings) => element("ul", {class: "findings"}, ...findings.map(({level, sentence}) => element("li", {class: level}, sentence)));

/** @param {Finding[]} findings @returns {(HTMLElement | null)[]} */
export function findingList(findings) {
  const grave = findings.filter(({level}) => level !== "note"), notes = findings.filter(({level}) => level === "note");
  return [grave.length ? list(grave) : null,
    notes.length ? element("details", {class: "notes"}, element("summary", {}, notes.length + (notes.length === 1 ? " note" : " notes")), list(notes)) : null];
}
