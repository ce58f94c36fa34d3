// The dialog that imports a table: what its columns are guessed to mean, and what belongs to it.
import {at, button, element, question, renew} from "naocal/lib/dom.js";
import {capitalized} from "naocal/lib/format.js";
import {on} from "../core/connection.js";
import {act, say} from "../core/state.js";
import {fileChoosers, uploadProgress} from "./drop.js";

/** @typedef {import("../core/messages.js").DroppedTable} DroppedTable */
/** @typedef {{value: string, text: string}} Option */

const mostUnused = 100; // columns without a meaning that are listed; the column map can name the others
/** @type {DroppedTable | null} */
let table = null;
/** @type {HTMLDialogElement | null} */
let dialog = null;
const content = element("div", {class: "import"}); // redrawn; the buttons below it stay, so that no click misses them
const problem = element("p", {class: "bad", role: "alert"});
const importing = button("Import and open", () => act({do: "importWrite"}), {class: "main"});
let isMapOpen = false;
/** @type {string | null} */
let typedMap = null; // null: as the bridge has it

on("import", ({table: told, sentence}) => {
  table = told;
  if (!told) close();
  else {
    if (!told.problem) typedMap = null;
    if (!dialog) open();
    draw();
  }
  if (sentence) say(capitalized(sentence) + ".");
});

function open() {
  isMapOpen = false;
  dialog = question({class: "confirm importing", "aria-label": "import a table"}, leave, content,
    element("div", {class: "decide"}, problem, element("p", {class: "controls"}, importing, button("Not now", leave, {autofocus: true}))));
  document.body.append(dialog);
}

function close() {
  dialog?.remove();
  dialog = null;
  typedMap = null;
}

function leave() {
  act({do: "importEnd"});
  endImport();
}

/** Closes the dialog: the bridge has gone, or shall forget the table. */
export function endImport() {
  table = null;
  close();
}

/** Shows the progress of an upload. */
export const refreshImport = () => { if (table) draw(); };

function draw() {
  const told = /** @type {DroppedTable} */ (table), progress = uploadProgress();
  importing.disabled = !told.isReady || told.busy || progress !== null;
  importing.textContent = told.busy ? "Importing …" : "Import and open";
  problem.hidden = !told.problem;
  problem.textContent = told.problem;
  const {scrollTop} = content, listTop = at("import-columns")?.scrollTop ?? 0;
  renew(content, element("h2", {}, told.files.table.chosen ? "Import " + told.files.table.chosen : "Import a table"),
    element("p", {}, told.sentence),
    told.columns && columns(told.columns),
    files(told),
    adding(progress),
    told.ignored.length ? element("p", {class: "soft"}, "Not needed: " + told.ignored.join(", ") + ".") : null);
  content.scrollTop = scrollTop;
  if (told.columns) at("import-columns").scrollTop = listTop;
}

// Columns.

/** @param {NonNullable<DroppedTable["columns"]>} told */
function columns({list, meanings, map}) {
  let unused = 0;
  const shown = list.map((column, i) => ({...column, i, meaning: meanings.find(one => one.column === column.name)})).filter(({meaning}) => meaning || ++unused <= mostUnused);
  const head = element("tr", {}, ...["Column", "First values", ...meanings.length ? ["Meaning", "Unit"] : []].map(name => element("th", {}, name)));
  return element("div", {}, element("div", {class: "import-columns", id: "import-columns", tabindex: "0", role: "group", "aria-label": "columns of the table"}, element("table", {}, element("thead", {}, head), element("tbody", {}, ...shown.map(({name, examples, i, meaning}) => element("tr", {},
    element("td", {class: "code"}, name), element("td", {class: "soft", title: examples.join(", ")}, examples.join(", ")),
    ...meanings.length ? [element("td", {}, meaningOf(name, i, meaning, meanings)), element("td", {}, meaning?.units.length ? unitOf(name, i, meaning) : null)] : []))))),
  unused > mostUnused ? element("p", {class: "soft"}, (unused - mostUnused) + " further columns are not used; the column map can name them.") : null,
  meanings.length ? mapOf(map) : null);
}

const isOfSeveral = id => /^(point|frame):/.test(id); // their columns are named together

const meaningOf = (name, i, meaning, meanings) => select("import-meaning-" + i, "meaning of " + name,
  [{value: "", text: "not used"}, ...meanings.filter(({id}) => id === meaning?.id || !isOfSeveral(id)).map(({id, words}) => ({value: id, text: words}))],
  meaning?.id ?? "", value => act({do: "importColumn", column: name, meaning: value, unit: ""}));

const unitOf = (name, i, {id, units, unit}) => select("import-unit-" + i, "unit of " + name, units.map(value => ({value, text: value})), unit,
  value => act({do: "importColumn", column: name, meaning: id, unit: value}));

/** The column map as a text, for what has no choice above: signs, factors, links, points. @param {string} map */
function mapOf(map) {
  const text = element("textarea", {id: "import-map", class: "code", spellcheck: "false", rows: String(Math.min(16, map.split("\n").length)), "aria-label": "column map",
    oninput: () => { typedMap = text.value; }});
  text.value = typedMap ?? map;
  const details = element("details", {open: isMapOpen, ontoggle: () => { isMapOpen = details.open; }},
    element("summary", {}, "The column map: signs, factors, links, and points or frames of several columns"), text,
    element("p", {class: "controls"}, button("Use this column map", () => act({do: "importColumns", columns: text.value}), {class: "small"})));
  return details;
}

// Files, links and folders.

/** @param {DroppedTable} told */
function files(told) {
  const {table: tables, columns: maps} = told.files, links = told.links.map(value => ({value, text: value}));
  const isOf = ({chosen, found}) => Boolean(chosen || found.length);
  return element("div", {class: "form"},
    tables.found.length > 1 || !isOf(tables) ? source(told, "table", "Table", "") : null,
    source(told, "robot", "Robot's URDF", "--robot"),
    isOf(maps) ? source(told, "columns", "Column map", "--columns") : null,
    ...told.hasPictures ? [source(told, "pictures", "Folder of the pictures", "--pictures"),
      source(told, "cameraModel", "Lens calibration", "--camera-model"),
      field("import-cameraLink", "Link of the camera", "--camera-link", id => select(id, "", [{value: "", text: "choose …"}, {value: "world", text: "world: it stands beside the robot"}, ...links], told.cameraLink, chosen("cameraLink"))),
      source(told, "boards", "Printed boards", "--boards"),
      field("import-boardLink", "Link of the boards", "--board-link", id => select(id, "", [{value: "world", text: "world"}, {value: "floor", text: "floor"}, ...links], told.boardLink, chosen("boardLink")))] : [],
    told.isReady ? field("import-output", "Write the set to", "-o", id => path(id, told.output, "a temporary folder, deleted when mate-bridge ends", chosen("output"))) : null);
}

const chosen = key => value => act({do: "importChoose", choices: {[key]: value}});

/** A file: one of the dropped ones, or a path. @param {DroppedTable} told @param {keyof DroppedTable["files"]} key @param {string} label @param {string} option */
function source(told, key, label, option) {
  const {chosen: now, found} = told.files[key], isDropped = found.includes(now);
  const named = value => key === "pictures" && value === "." ? "as dropped, in no folder" : value;
  const id = "import-" + key + (found.length ? "" : "-path"); // a path and a choice are no one element that keeps the focus
  return field(id, label, option, () => found.length
    ? element("span", {class: "import-source"}, select(id, "", [...isDropped ? [] : [{value: "", text: now ? "a path:" : "choose …"}], ...found.map(value => ({value, text: named(value)}))], isDropped ? now : "", chosen(key)),
      path(id + "-path", isDropped ? "" : now, "or a path on this computer", chosen(key), label))
    : path(id, now, "drop it here, or type its path on this computer", chosen(key)));
}

const field = (id, label, option, input) => element("div", {class: "field"},
  element("label", {for: id}, label, option ? element("code", {class: "soft", title: "its option of naocal import csv"}, " " + option) : null), input(id));

/** @param {string} id @param {string} label empty: it has its own @param {Option[]} options @param {string} now @param {(value: string) => void} changed */
function select(id, label, options, now, changed) {
  const made = element("select", {id, ...label && {"aria-label": label}, onchange: () => changed(made.value)}, ...options.map(({value, text}) => element("option", {value, selected: value === now}, text)));
  return made;
}

/** @param {string} id @param {string} now @param {string} hint @param {(value: string) => void} changed @param {string} [label] */
function path(id, now, hint, changed, label) {
  const input = element("input", {type: "text", id, class: "code", spellcheck: "false", autocomplete: "off", placeholder: hint, ...label && {"aria-label": "path: " + label}, onchange: () => changed(input.value.trim())});
  input.value = now;
  return input;
}

/** Further files. @param {number | null} progress */
function adding(progress) {
  if (progress === null) return element("p", {class: "controls"}, element("span", {class: "soft"}, "Drop further files anywhere, or"), ...fileChoosers(Boolean(table?.busy)));
  const bar = element("progress", {max: "1", "aria-label": "files read"});
  bar.value = progress;
  return element("p", {class: "controls", role: "status"}, "Reading the files …", bar);
}
