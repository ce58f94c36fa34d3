// Reads the page's data and fills its head: headline, sentence, key figures, further findings.
import {at, element} from "naocal/lib/dom.js";
import {findingList} from "naocal/plots/finding-list.js";
import {readColours} from "naocal/lib/figure.js";

/** @import {Fact, Finding} from "naocal/lib/types.js" */

readColours();
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", readColours);

addEventListener("beforeprint", () => document.querySelectorAll("details").forEach(details => { details.open = true; }));

export const readData = () => JSON.parse(at("data").textContent);

/** @param {{headline: string, facts: Fact[], verdict: string, sentence: string, findings: Finding[]}} head */
export function showHead({headline, facts, verdict, sentence, findings}) {
  at("verdict").classList.add(verdict);
  at("headline").textContent = document.title = headline;
  at("sentence").textContent = sentence;
  at("facts").append(...facts.map(fact => element("div", {}, element("dt", {}, fact.figure), element("dd", {}, fact.sentence))));
  at("findings").append(...findingList(findings).flatMap(part => part ?? []));
}

/** Links to the sections of the page that are shown, below its head. */
export function showContents() {
  const titles = /** @type {HTMLElement[]} */ ([...document.querySelectorAll("main section h2")]).filter(title => !title.closest("[hidden]"));
  const links = titles.map((title, i) => {
    title.id ||= "section-" + (i + 1);
    return element("a", {href: "#" + title.id}, title.textContent);
  });
  if (links.length > 2) at("verdict").after(element("nav", {id: "contents", "aria-label": "contents"}, ...links));
}
