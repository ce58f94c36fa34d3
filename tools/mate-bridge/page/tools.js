// Tools: the terminal's commands, with the words that one would type there.
import {make, button, empty} from "./elements.js";
import {on} from "./connection.js";
import {act} from "./state.js";

// A field: `flag` before it (none: it stands alone), `value` to begin with; `options` to choose from, `check`: with or without.
const modelFields = [{flag: "--with", label: "add effects", value: ""}, {flag: "--without", label: "leave effects out", value: ""}, {flag: "--model", label: "a model's file", value: ""},
  {flag: "--same-place", label: "boards and stances of equal names lie at the same place in all sets", check: true}, {flag: "--skip-bad", label: "leave out captures that cannot be used", check: true}];
const commands = [
  {words: ["poses"], name: "Plan poses", what: "Poses worth taking, and where to lay the boards: a plan for the whole robot before it has seen anything.",
    fields: [{flag: "-o", label: "write the plan to", value: "poses.json"}, {flag: "--support", label: "stand on", options: ["left", "right", "both"]},
      {flag: "--select", label: "poses", value: "8"}, {flag: "--candidates", label: "chosen among", value: "1000000"},
      {flag: "--robot", label: "robot", options: ["V6", "V5"]}, {flag: "--mirror", label: "and mirrored, for the other leg", check: true}]},
  {words: ["simulate"], name: "Simulate", what: "Captures of a simulated robot, to try everything without one. What it hides stands in a truth file beside them.",
    fields: [{label: "write the captures to", value: "simulated", opens: true}, {flag: "--poses", label: "poses, or a plan's file", value: "24"}, {flag: "--samples", label: "pictures of each", value: "3"},
      {flag: "--support", label: "stand on", options: ["left", "right", "both"]}, {flag: "--seed", label: "robot number", value: "1"},
      {flag: "--hidden-flaw", label: "hide a flaw in it", check: true}, {flag: "--images", label: "with pictures", check: true},
      {flag: "--force", label: "replace the captures that lie there", check: true}]},
  {words: ["detect"], name: "Find corners", what: "Finds the boards' corners in pictures that were taken without looking for them.",
    fields: [{label: "captures", value: "simulated", opens: true}, {flag: "--dry-run", label: "leave the captures as they are", check: true}]},
  {words: ["solve"], name: "Solve", what: "Calibrates joints and cameras from captures, with whatever options; what is on the desk here is left alone.",
    fields: [{label: "captures", value: "simulated"}, {flag: "-o", label: "write the result to", value: "result.json", opens: true}, ...modelFields,
      {flag: "--restarts", label: "random starts beside the ordinary one", value: "0"}]},
  {words: ["diagnose"], name: "Diagnose", what: "Says where and why the model fails, and which effect is missing.",
    fields: [{label: "captures", value: "simulated"}, {flag: "--json", label: "write the diagnosis to", value: "diagnosis.json", opens: true}, ...modelFields,
      {flag: "--next", label: "write poses to take next to", value: ""}, {flag: "--own", label: "write what no effect explains to", value: ""}, {flag: "--draws", label: "draws of pure noise", value: "199"}]},
  {words: ["compare"], name: "Compare a result", what: "How well a result predicts captures that it has not seen.",
    fields: [{label: "result", value: "result.json"}, {label: "captures", value: "simulated"}, {flag: "--against", label: "beside another result", value: ""},
      {flag: "--same-place", label: "boards and feet are where the result found them", check: true}]},
  {words: ["report"], name: "Report", what: "One page of a result, a diagnosis or an evaluation, readable without a network.",
    fields: [{label: "result, diagnosis or evaluation", value: "result.json"}, {flag: "-o", label: "write the page to", value: "report.html"}]},
  {words: ["evaluate", "thesis"], name: "Evaluate: solver", what: "How often joint offsets are found, beside plain Levenberg-Marquardt, the Cramer-Rao limit and the thesis's tables.",
    fields: [{flag: "--sets", label: "error sets in a cell", value: "100"}, {flag: "--seed", label: "seed", value: "1"}, {flag: "--json", label: "write to", value: "thesis.json"}]},
  {words: ["evaluate", "effects"], name: "Evaluate: diagnosis", what: "A blind benchmark: robots with hidden effects, whose truth is sealed until the answers are written. Ended, it goes on where it was.",
    fields: [{flag: "--out", label: "folder", value: "blind"}, {flag: "--seed", label: "seed", value: "1"}, {flag: "--controls", label: "robots without effect, each kind of noise", value: "4"},
      {flag: "--sets", label: "robots of each effect and size", value: "1"}, {flag: "--page", label: "page with plots", value: "blind.html"}]},
  {words: ["evaluate", "next"], name: "Evaluate: next poses", what: "How many further poses it takes to tell effects apart: the proposed ones against random ones.",
    fields: [{flag: "--robots", label: "robots", value: "10"}, {flag: "--seed", label: "seed", value: "1"}]},
  {words: ["effects"], name: "List effects", what: "Every effect of the catalogue: formula, unknowns, what data it needs.", fields: []},
];
const typed = new Map(); // by command and field
let chosen = commands[0], further = "", told = null, fresh = () => {};

on("errand", message => { told = message; fresh(); });

const keyOf = field => chosen.name + "/" + field.label;
const valueOf = field => typed.get(keyOf(field)) ?? (field.check ? false : field.options ? field.options[0] : field.value);

// What one would type: options that stand as they are by default are said, too.
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
    parent.replaceChildren(make("h1", {}, "Tools"), empty("Waiting for the bridge", "It has not said yet what it can run."));
    fresh = () => showTools(parent);
    return;
  }
  const line = make("pre", {class: "code", id: "toolLine"}), output = make("pre", {id: "toolOutput", tabindex: "0", "aria-label": "what the command prints"});
  const status = make("p", {id: "toolStatus", role: "status"}), start = button("Run", () => act({do: "run", words: wordsNow()}), {class: "main", id: "toolRun"});
  const stop = button("End it", () => act({do: "endRun"}), {id: "toolEnd"}), opened = make("span", {});
  const saidNow = () => { line.replaceChildren(...quoted(wordsNow()).flatMap(word => [make("span", {}, word), " "])); };
  fresh = () => {
    start.disabled = told.running || !told.program;
    stop.hidden = !told.running;
    status.textContent = !told.program ? "The program naocal was not found beside mate-bridge, nor where the shell looks: install it, too."
      : told.running && told.ending ? typedWords(told.words) + " finishes what it has begun; once more ends it at once."
      : told.running ? typedWords(told.words) + " is running …"
      : told.exitCode === null ? "Runs in " + told.folder + "."
      : typedWords(told.words) + (told.ending ? " was ended." : told.exitCode === 0 ? " has finished." : told.exitCode === 3 ? " has finished: read its verdict in the last lines." : " ended with " + told.exitCode + ": read its last lines.");
    const atEnd = output.scrollTop + output.clientHeight > output.scrollHeight - 30;
    output.textContent = told.lines.join("\n");
    output.hidden = !told.lines.join("");
    if (atEnd) output.scrollTop = output.scrollHeight;
    const place = [0, 3].includes(told.exitCode) && placeWritten(told.words); // 3: done, but not to be used
    opened.replaceChildren(...(place ? [button("Open " + place, () => act({do: "open", paths: [place.startsWith("/") ? place : told.folder + "/" + place]}))] : []));
  };
  parent.replaceChildren(make("h1", {}, "Tools"),
    make("p", {class: "soft"}, "What the terminal can do, with every option. The line below is what one would type there."),
    make("div", {class: "controls", role: "group", "aria-label": "commands"}, ...commands.map(command => button(command.name, () => { chosen = command; further = ""; showTools(parent); },
      {class: "small", "aria-pressed": String(command === chosen)}))),
    make("p", {}, chosen.what),
    make("form", {class: "form", onsubmit: event => { event.preventDefault(); if (!start.disabled) start.click(); }, oninput: saidNow, onchange: saidNow},
      ...chosen.fields.map(fieldOf), furtherField(), line, make("div", {class: "controls"}, start, stop, opened)),
    status, output);
  saidNow();
  fresh();
}

// What the last command wrote or filled, and that can be opened here.
function placeWritten(words) {
  const command = commands.find(one => one.words.every((word, i) => words[i] === word)), field = command?.fields.find(({opens}) => opens);
  return field && (field.flag ? words[words.indexOf(field.flag) + 1] : words[command.words.length]);
}

function fieldOf(field) {
  const id = "tool-" + field.label.replace(/\W+/g, "-");
  const remember = value => typed.set(keyOf(field), value);
  if (field.check) {
    const box = make("input", {type: "checkbox", id, checked: valueOf(field), onchange: () => remember(box.checked)});
    return make("label", {class: "check", for: id}, box, " " + field.label);
  }
  if (field.options) {
    const select = make("select", {id, onchange: () => remember(select.value)}, ...field.options.map(value => make("option", {value, selected: value === valueOf(field)}, value)));
    return make("div", {class: "field"}, make("label", {for: id}, field.label), select);
  }
  const input = make("input", {type: "text", id, class: "code", spellcheck: "false", autocomplete: "off", oninput: () => remember(input.value)});
  input.value = valueOf(field);
  return make("div", {class: "field"}, make("label", {for: id}, field.label), input);
}

function furtherField() {
  const input = make("input", {type: "text", id: "toolFurther", class: "code", spellcheck: "false", autocomplete: "off", placeholder: "--help tells all", oninput: () => { further = input.value; }});
  input.value = further;
  return make("div", {class: "field"}, make("label", {for: "toolFurther"}, "further options"), input);
}
