// Tools view: runs naocal commands and shows the command line.
import {button, element, empty} from "naocal/lib/dom.js";
import {on} from "./core/connection.js";
import {act, state} from "./core/state.js";

// What is open in the panel, else what the commands before have written.
const openCaptures = () => state.set?.names[0] ?? "simulated", openResult = () => state.set?.result || "result.json";

// Field: `flag` (absent: positional argument), `value` (initial, or a function that returns it), `options` (select; a name: a list of the bridge), `check` (switch), `opens` (a path that the panel can open).
const modelFields = [{flag: "--with", label: "add effects", value: ""}, {flag: "--without", label: "leave effects out", value: ""}, {flag: "--model", label: "model file", value: ""},
  {flag: "--same-place", label: "boards and stances of equal names are at the same place in all sets", check: true}, {flag: "--skip-bad", label: "skip unusable captures", check: true}];
const commands = [
  {words: ["board"], name: "Print boards", what: "ChArUco boards to print, and the size of the print: print the PDF at 100 %, measure both rulers of a board, then run it again with the two lengths.",
    fields: [{flag: "-o", label: "write the PDF to", value: "boards.pdf"}, {flag: "--boards", label: "keep the boards and their real size in", value: "boards.json"},
      {flag: "--paper", label: "paper", options: ["a4", "a3", "a2", "a1", "a0"]}, {flag: "--measured", label: "measured rulers [m], as 0.1995,0.1990", value: ""}]},
  {words: ["poses"], name: "Plan poses", what: "Poses to take, and where to place the boards: a plan for the whole robot before its first capture.",
    fields: [{flag: "-o", label: "write the plan to", value: "poses.json"}, {flag: "--support", label: "stand on", options: ["left", "right", "both"]},
      {flag: "--select", label: "poses", value: "8"}, {flag: "--candidates", label: "candidate poses", value: "1000000"},
      {flag: "--robot", label: "robot", options: ["V6", "V5"]}, {flag: "--mirror", label: "mirror the plan for the other leg", check: true}]},
  {words: ["simulate"], name: "Simulate", what: "Captures of a simulated robot. Its hidden errors are written to a truth file beside them.",
    fields: [{label: "write the captures to", value: "simulated", opens: true}, {flag: "--poses", label: "number of poses, or a plan file", value: "24"}, {flag: "--samples", label: "pictures per pose", value: "3"},
      {flag: "--support", label: "stand on", options: ["left", "right", "both"]}, {flag: "--seed", label: "robot number", value: "1"},
      {flag: "--hidden-flaw", label: "hide a flaw in it", check: true}, {flag: "--images", label: "with pictures", check: true},
      {flag: "--force", label: "replace existing captures", check: true}]},
  {words: ["check"], name: "Check captures", what: "Every problem of a capture set at once.", fields: [{label: "captures", value: openCaptures}]},
  {words: ["detect"], name: "Find corners", what: "Finds the boards' corners in recorded pictures.",
    fields: [{label: "captures", value: openCaptures, opens: true}, {flag: "--dry-run", label: "do not change the captures", check: true}]},
  {words: ["solve"], name: "Solve", what: "Calibrates joints and cameras from captures. The captures open in this panel are not affected.",
    fields: [{label: "captures", value: openCaptures}, {flag: "-o", label: "write the result to", value: "result.json", opens: true}, ...modelFields,
      {flag: "--restarts", label: "additional random starts", value: "0"}]},
  {words: ["diagnose"], name: "Diagnose", what: "Shows where and why the model fails, and which effect is missing.",
    fields: [{label: "captures", value: openCaptures}, {flag: "--json", label: "write the diagnosis to", value: "diagnosis.json", opens: true}, ...modelFields,
      {flag: "--next", label: "write next poses to", value: ""}, {flag: "--own", label: "write an unexplained pattern as a custom effect to", value: ""}, {flag: "--draws", label: "noise draws", value: "199"}]},
  {words: ["compare"], name: "Compare a result", what: "How well a result predicts captures that it was not fitted to.",
    fields: [{label: "result", value: openResult}, {label: "captures", value: openCaptures}, {flag: "--against", label: "against another result", value: ""},
      {flag: "--same-place", label: "boards and feet have not moved since the result", check: true}]},
  {words: ["report"], name: "Report", what: "One page about a result, a diagnosis or an evaluation; opens without a network.",
    fields: [{label: "result, diagnosis or evaluation", value: openResult}, {flag: "-o", label: "write the page to", value: "report.html"}]},
  {words: ["apply"], name: "Apply a result", what: "Writes a result into a robot's configuration in HULKs' layout, both files or none. First look at what changes, without writing.",
    fields: [{label: "result", value: openResult}, {flag: "--configuration", label: "folder with location/ in it", value: ""},
      {flag: "--dry-run", label: "show what would change, write nothing", check: true}, {flag: "--undo", label: "restore what was there before the last save", check: true}]},
  {words: ["export"], name: "Export a result", what: "Writes a result as configuration files of another program. Joints that are less than 50 % learned keep the values of files that are there.",
    fields: [{label: "result", value: openResult}, {flag: "--to", label: "for", options: "exportedDialects"}, {flag: "-o", label: "folder to write to", value: "exported"}]},
  {words: ["import"], name: "Import a configuration", what: "Reads a robot's calibration from another program's files, as the start of a calibration (solve --start).",
    fields: [{label: "file", value: ""}, {flag: "--from", label: "of", options: "importedDialects"}, {flag: "-o", label: "write the calibration to", value: "start.json"}]},
  {words: ["evaluate", "thesis"], name: "Evaluate: solver", what: "Success rate of the solver, beside plain Levenberg-Marquardt, the Cramér-Rao limit and the thesis's tables.",
    fields: [{flag: "--sets", label: "error sets per cell", value: "100"}, {flag: "--seed", label: "seed", value: "1"}, {flag: "--json", label: "write to", value: "thesis.json"}]},
  {words: ["evaluate", "effects"], name: "Evaluate: diagnosis", what: "A blind benchmark: robots with hidden effects, whose truth is sealed until the answers are written. An interrupted benchmark resumes.",
    fields: [{flag: "--out", label: "folder", value: "blind"}, {flag: "--seed", label: "seed", value: "1"}, {flag: "--controls", label: "robots without an effect, per kind of noise", value: "4"},
      {flag: "--sets", label: "robots per effect and size", value: "1"}, {flag: "--page", label: "page with plots", value: "blind.html"}]},
  {words: ["evaluate", "next"], name: "Evaluate: next poses", what: "Number of further poses needed to tell effects apart: proposed against random poses.",
    fields: [{flag: "--robots", label: "robots", value: "10"}, {flag: "--seed", label: "seed", value: "1"}]},
  {words: ["effects"], name: "List effects", what: "Every effect of the catalogue: formula, unknowns, required data.", fields: []},
];
const typed = new Map(); // input by command and field
let chosen = commands[0], further = "", told = null, fresh = () => {};

on("errand", message => { told = message; fresh(); });

/** Selects a command by its name. @param {string} name */
export function chooseCommand(name) {
  chosen = commands.find(one => one.name === name) ?? chosen;
  further = "";
}

const keyOf = field => chosen.name + "/" + field.label;
const optionsOf = field => typeof field.options === "string" ? told[field.options] : field.options;
const valueOf = field => typed.get(keyOf(field)) ?? (field.check ? false : field.options ? optionsOf(field)[0] : typeof field.value === "function" ? field.value() : field.value);

// The command line's words, including defaults.
function wordsNow() {
  const words = [...chosen.words];
  for (const field of chosen.fields) {
    const value = valueOf(field);
    if (field.check) { if (value) words.push(field.flag); }
    else if (String(value).trim()) words.push(...(field.flag ? [field.flag] : []), String(value).trim());
  }
  return [...words, ...further.split(/\s+/).filter(Boolean)];
}
const quoted = words => ["naocal", ...words].map(word => /^[\w@%+=:,./-]+$/.test(word) ? word : "'" + word.replaceAll("'", "'\\''") + "'");
const typedWords = words => quoted(words).join(" ");

export function showTools(parent) {
  if (!told) {
    parent.replaceChildren(element("h1", {}, "Tools"), empty("Waiting for the bridge", "Its list of commands has not arrived yet."));
    fresh = () => showTools(parent);
    return;
  }
  const line = element("pre", {class: "code", id: "toolLine"}), output = element("pre", {id: "toolOutput", tabindex: "0", "aria-label": "output of the command"});
  const status = element("p", {id: "toolStatus", role: "status"}), start = button("Run", () => act({do: "run", words: wordsNow()}), {class: "main", id: "toolRun"});
  const stop = button("End it", () => act({do: "endRun"}), {id: "toolEnd"}), opened = element("span", {});
  const saidNow = () => { line.replaceChildren(...quoted(wordsNow()).flatMap(word => [element("span", {}, word), " "])); };
  fresh = () => {
    start.disabled = told.running || !told.program;
    stop.hidden = !told.running;
    status.textContent = !told.program ? "The program naocal was not found beside mate-bridge, nor where the shell looks: install it, too."
      : told.running && told.ending ? typedWords(told.words) + " finishes what it has begun; press again to end it immediately."
      : told.running ? typedWords(told.words) + " is running …"
      : told.exitCode === null ? "Runs in " + told.folder + "."
      : typedWords(told.words) + (told.ending ? " was ended." : told.exitCode === 0 ? " has finished." : told.exitCode === 3 ? " has finished: read its verdict in the last lines." : " ended with " + told.exitCode + ": read its last lines.");
    const atEnd = output.scrollTop + output.clientHeight > output.scrollHeight - 30;
    output.textContent = told.lines.join("\n");
    output.hidden = !told.lines.join("");
    if (atEnd) output.scrollTop = output.scrollHeight;
    const place = [0, 3].includes(told.exitCode) && placeWritten(told.words); // exit code 3: completed, but the result is not usable
    opened.replaceChildren(...(place ? [button("Open " + place, () => act({do: "open", paths: [place.startsWith("/") ? place : told.folder + "/" + place]}))] : []));
  };
  parent.replaceChildren(element("h1", {}, "Tools"),
    element("p", {class: "soft"}, "The terminal's commands, with every option. The line below is the command as typed there."),
    element("div", {class: "controls", role: "group", "aria-label": "commands"}, ...commands.map(command => button(command.name, () => { chosen = command; further = ""; showTools(parent); },
      {class: "small", "aria-pressed": String(command === chosen)}))),
    element("p", {}, chosen.what),
    element("form", {class: "form", onsubmit: event => { event.preventDefault(); if (!start.disabled) start.click(); }, oninput: saidNow, onchange: saidNow},
      ...chosen.fields.map(fieldOf), furtherField(), line, element("div", {class: "controls"}, start, stop, opened)),
    status, output);
  saidNow();
  fresh();
}

// Path written by the last command, if the panel can open it.
function placeWritten(words) {
  const command = commands.find(one => one.words.every((word, i) => words[i] === word)), field = command?.fields.find(({opens}) => opens);
  return command && field && (field.flag ? words[words.indexOf(field.flag) + 1] : words[command.words.length]);
}

function fieldOf(field) {
  const id = "tool-" + field.label.replace(/\W+/g, "-");
  const remember = value => typed.set(keyOf(field), value);
  if (field.check) {
    const box = element("input", {type: "checkbox", id, checked: valueOf(field), onchange: () => remember(box.checked)});
    return element("label", {class: "check", for: id}, box, " " + field.label);
  }
  if (field.options) {
    const select = element("select", {id, onchange: () => remember(select.value)}, ...optionsOf(field).map(value => element("option", {value, selected: value === valueOf(field)}, value)));
    return element("div", {class: "field"}, element("label", {for: id}, field.label), select);
  }
  const input = element("input", {type: "text", id, class: "code", spellcheck: "false", autocomplete: "off", oninput: () => remember(input.value)});
  input.value = valueOf(field);
  return element("div", {class: "field"}, element("label", {for: id}, field.label), input);
}

function furtherField() {
  const input = element("input", {type: "text", id: "toolFurther", class: "code", spellcheck: "false", autocomplete: "off", placeholder: "--help lists them", oninput: () => { further = input.value; }});
  input.value = further;
  return element("div", {class: "field"}, element("label", {for: "toolFurther"}, "further options"), input);
}
