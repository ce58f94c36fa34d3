// Files view: opens captures, compares with others, saves the same files as the command line.
import {button, csvTable, download, element, renew} from "naocal/lib/dom.js";
import {px, sized} from "naocal/lib/format.js";
import {on} from "../core/connection.js";
import {saveSession} from "../core/session-export.js";
import {act, notice, state} from "../core/state.js";
import {missingCaptures} from "../history/missing-captures.js";

let typed = "", typedOthers = "";
const kinds = {
  "result.json": "the fit, as naocal solve writes it",
  "report.html": "report of that result, one page",
  "diagnosis.json": "candidates, map and curves, as naocal diagnose writes them",
  "diagnosis.html": "report of that diagnosis",
  "model.json": "the model, for --model",
  "session.json": "the ladder with all its models, to continue later: here, or in naocal explore --session",
  "poses.json": "the poses suggested in Next poses",
};

const requested = new Set(); // files that this page waits for: others may have asked for theirs

export function requestFile(file) {
  if (act({do: "make", file})) requested.add(file);
}

on("made", async ({file}) => {
  if (!requested.delete(file)) return;
  const answer = await fetch("made/" + file).catch(() => null);
  if (answer && answer.ok) download(file, await answer.blob());
  else notice(file + " was written, but could not be fetched from the bridge; try again.");
});

export function showFiles(parent) {
  const {set, compared} = state, open = state.analysis;
  renew(parent, element("h1", {}, "Files"), missingCaptures(() => showFiles(parent)),
    element("h2", {}, "Open"), element("p", {class: "soft"}, open && set ? "Open now: " + set.names.join(", ") + "." : "Nothing is open.", " A capture set, a recording of the robot, a result, a diagnosis, a session.json, or a saved model.json with its captures; nothing in them is changed. One path per line."),
    paths("open", "path of what to open", typed, value => { typed = value; }, list => act({do: "open", paths: list}), "Open"),
    ...(open ? [element("h2", {}, "Compare with captures not used for the calibration"), paths("compare", "path of other captures", typedOthers, value => { typedOthers = value; }, list => act({do: "compare", paths: list}), "Compare"),
      ...(compared ? comparison(compared) : []),
      element("h2", {}, "Save"), element("table", {class: "files"}, element("tbody", {}, element("tr", {}, element("td", {}, button("session.html", saveSession)), element("td", {}, "everything this panel shows, as one page")),
        ...Object.entries(kinds).map(([file, words]) => element("tr", {}, element("td", {}, button(file, () => requestFile(file))), element("td", {}, words)))))]
      : [element("h2", {}, "Save"), element("p", {}, button("session.html", saveSession), " everything this panel shows, as one page")]));
}

// Disabled while the bridge is busy.
export function filesWorked(parent) {
  for (const go of parent.querySelectorAll("form.paths button, form.missing [type=submit]")) go.disabled = Boolean(state.work);
}

function paths(id, label, value, changed, go, words) {
  const field = element("textarea", {rows: "2", spellcheck: "false", class: "code", id, "aria-label": label, placeholder: "/path/to/captures"});
  field.value = value;
  field.addEventListener("input", () => changed(field.value));
  return element("form", {class: "paths", onsubmit: event => {
    event.preventDefault();
    const list = field.value.split("\n").map(line => line.trim()).filter(Boolean);
    if (list.length) go(list);
  }}, field, element("button", {type: "submit", disabled: Boolean(state.work)}, words));
}

function comparison({names, kinds, byBoard, byCamera, byPose, byMarker = {}}) {
  const millimetre = 1e-3;
  const rows = [...[["board", byBoard], ["camera", byCamera], ["pose", byPose]].flatMap(([kind, group]) => Object.entries(group).map(([name, one]) => [kind + " " + name, px(one.rmsPx)])),
    ...Object.entries(byMarker).flatMap(([tracker, group]) => Object.entries(group).map(([name, one]) => [name + " of " + tracker, sized(one.rms / millimetre, "mm")]))];
  const row = (/** @type {any[]} */ [name, size]) => element("tr", {}, element("th", {scope: "row"}, name), element("td", {class: "number"}, size));
  return [...kinds.map(({title, unit, count, rms, median, nominal}) => element("p", {}, element("b", {}, sized(rms, unit) + " rms"), " (median " + sized(median, unit) + ") from their predictions over " +
    count + " " + title + " in " + names.join(", ") + (nominal === null ? "." : "; with the drawing alone " + sized(nominal, unit) + "."))),
  rows.length ? csvTable(element("table", {class: "narrow"}, element("thead", {}, element("tr", {}, element("th", {scope: "col"}, "of"), element("th", {scope: "col", class: "number"}, "rms error"))), element("tbody", {}, ...rows.map(row))), "comparison") : null];
}
