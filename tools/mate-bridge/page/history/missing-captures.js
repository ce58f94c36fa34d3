// Asks where captures are that a document or a run names and that were not found.
import {button, element} from "naocal/lib/dom.js";
import {capitalized} from "naocal/lib/format.js";
import {act, state} from "../core/state.js";

let typed = "";

// The bridge's clause as a sentence, without the advice for the terminal.
const asSentence = clause => capitalized(clause).replace("; say where with --look-in FOLDER", "") + ".";

// The question; null if nothing is missing. `done` redraws.
export function missingCaptures(done) {
  const {missing} = state;
  if (!missing) return null;
  const forget = () => { state.missing = null; done(); };
  const field = element("input", {type: "text", id: "lookIn", class: "code", spellcheck: "false", "aria-label": "folder to search for the captures", placeholder: "/path/to/search"});
  field.value = typed;
  field.addEventListener("input", () => { typed = field.value; });
  return element("form", {class: "confirm asks missing", onsubmit: event => {
    event.preventDefault();
    if (!typed.trim()) return;
    const lookIn = [typed.trim()];
    if (act(missing.run ? {do: "openRun", id: missing.run, lookIn} : {do: "open", paths: missing.paths, lookIn})) forget();
  }}, element("h2", {}, "Where are the captures now?"), element("p", {}, asSentence(missing.sentence)),
  element("p", {class: "soft"}, "Name a folder: it and the folders below it are searched, and the captures recognised by their SHA-256."),
  element("div", {class: "paths"}, field, element("span", {class: "controls"}, element("button", {type: "submit", class: "main", disabled: Boolean(state.work)}, "Look there"), button("Not now", forget))));
}
