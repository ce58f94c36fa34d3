/// <reference path="./markdown.d.ts" />
// Terms explain themselves: the first occurrence of each in a view gets the glossary's sentence as a tooltip.
import {element, hideTip, showTip, tipOver} from "naocal/lib/dom.js";
import glossary from "../../../../docs/glossary.md";

/** @typedef {{name: string, meaning: string, isState: boolean}} Term */

/** Markdown without links and code marks. @param {string} text */
const plain = text => text.replace(/\[([^\]]*)\]\([^)]*\)/g, "$1").replaceAll("`", "").trim();

/** Terms of the page docs/glossary.md, one per row of its table. @param {string} page @returns {Term[]} */
export const termsOf = page => page.split("\n").map(line => line.match(/^\| \[([^\]]+)\]\([^)]*\) \| (.*) \|$/)).filter(row => row !== null)
  .flatMap(([, name, meaning]) => name.split(", ").map(one => ({name: one, meaning: plain(meaning), isState: meaning.startsWith("state of")})))
  .filter(({name}) => /^\w/.test(name));

const terms = termsOf(glossary), byName = new Map(terms.map(term => [term.name.toLowerCase(), term]));

/** Matches all of these terms, with a plural s. @param {Term[]} some */
const pattern = some => new RegExp("(?<![\\w-])(" + some.map(({name}) => name).sort((a, b) => b.length - a.length).join("|") + ")(s?)(?![\\w-])", "i");
const ofText = pattern(terms.filter(({isState}) => !isState)), ofState = pattern(terms.filter(({isState}) => isState)); // states are ordinary words elsewhere

const explained = "p, li, dd, dt, th, h1, h2, h3, .state";
const left = "button, a, label, select, textarea, code, pre, figcaption, summary, dialog, dfn, .rests, .waiting, .keylist, [contenteditable]";

/** A term in the text, with its sentence. @param {string} word @param {Term} term */
function explain(word, {name, meaning}) {
  const words = name + ": " + meaning + ".", part = tipOver(element("dfn", {tabindex: "0", "data-term": name, "aria-description": meaning}, word), words);
  part.addEventListener("focus", () => {
    const {left: clientX, top: clientY} = part.getBoundingClientRect();
    showTip({clientX, clientY}, words);
  });
  part.addEventListener("blur", hideTip);
  part.addEventListener("keydown", event => { if (event.key === "Escape") { hideTip(); event.stopPropagation(); } });
  return part;
}

/** Explains terms in a part of the page that are not explained there yet. @param {Element} root */
export function explainTerms(root) {
  const seen = new Set([...root.querySelectorAll("dfn")].map(one => /** @type {HTMLElement} */ (one).dataset.term)), texts = [];
  for (const walker = document.createTreeWalker(root, NodeFilter.SHOW_TEXT); walker.nextNode();) texts.push(/** @type {Text} */ (walker.currentNode));
  for (const text of texts) {
    const parent = text.parentElement;
    if (!parent || !parent.closest(explained) || parent.closest(left)) continue;
    let rest = text;
    for (let found; (found = rest.data.match(parent.closest(".state") ? ofState : ofText));) {
      const term = /** @type {Term} */ (byName.get(found[1].toLowerCase())), word = rest.splitText(/** @type {number} */ (found.index));
      rest = word.splitText(found[0].length);
      if (seen.has(term.name)) continue;
      seen.add(term.name);
      word.replaceWith(explain(found[0], term));
    }
    parent.normalize();
  }
}

/** Keeps the terms in these parts explained. @param {Element[]} parts */
export function explainAlways(parts) {
  let due = 0;
  const observer = new MutationObserver(() => {
    clearTimeout(due);
    due = window.setTimeout(() => {
      parts.forEach(explainTerms);
      observer.takeRecords(); // its own changes
    }, 150);
  });
  parts.forEach(part => observer.observe(part, {childList: true, subtree: true, characterData: true}));
}
