// Configuration: every mount's parameters; each is set by itself, and saved only when the person confirms it.
import {make, button, empty, renew} from "./elements.js";
import {act, notice} from "./state.js";
import {robots, robotBar, refreshBar, lookedAt, needKeys, nameOf, whyNothing} from "./robots.js";
import {savingOn} from "./save.js";
import {runner} from "./steer.js";

let mount = null, parentShown = null, filter = "", confirming = null; // the robot that is to save
const edits = new Map(); // text by robot, mount and key, until it is set
const changed = new Map(); // what was set, in the same way
const commands = ["run", "confirmed", "poses"]; // of the runner: whoever sets them moves the robot, which Calibrate asks about

export function showKeys(parent) {
  parentShown = parent;
  const robot = lookedAt(), why = whyNothing();
  renew(parent, make("div", {class: "heading"}, make("h1", {}, "Configuration"), robotBar(() => showKeys(parent))), ...(why ? [empty(...why)] : content(robot)));
}

export function keysTold(message, isShown) {
  if (message.kind === "keys") compare(message);
  if (!isShown || !parentShown || !["robot", "robotGone", "mounts", "keys"].includes(message.kind)) return;
  if (message.robot === lookedAt() || message.kind === "robotGone") showKeys(parentShown);
  else refreshBar(parentShown, () => showKeys(parentShown));
}

// A robot that does not like a value keeps its own, without a word.
function compare({robot, body}) {
  for (const {key, value} of (body && body.keys) || []) {
    const place = robot + "\n" + body.mountPoint + "\n" + key, sent = changed.get(place);
    if (!sent || sent.answered) continue;
    sent.answered = true;
    if (sent.text === textOf(value)) continue;
    changed.delete(place);
    notice(nameOf(robot) + " did not take " + key + " = " + sent.text + ": it has " + textOf(value) + ". Its own log says why.");
  }
}

function content(robot) {
  const entry = robots.get(robot);
  if (!entry.mounts.some(({key}) => key === mount)) mount = entry.mounts.length ? entry.mounts[0].key : null;
  if (mount) needKeys(robot, mount);
  return [entry.connected ? make("p", {class: "soft"}, "A value that is set counts at once and until the robot ends. Saving writes all that was set into the robot's own files.")
    : make("p", {class: "bad"}, nameOf(robot) + " " + entry.sentence + ". Nothing can be set until it is back."),
    make("div", {class: "split keys-split"}, mountList(robot, entry), parameters(robot, entry))];
}

function mountList(robot, {mounts, keys}) {
  const search = make("input", {type: "search", id: "mountFilter", placeholder: "filter " + mounts.length + " modules", "aria-label": "filter modules", oninput: () => { filter = search.value; fill(); }});
  const list = make("ul", {class: "keylist"});
  const fill = () => list.replaceChildren(...mounts.filter(({key}) => key.toLowerCase().includes(filter.toLowerCase())).map(({key}) => make("li", {},
    button(key, () => { mount = key; keys.delete(key); showKeys(parentShown); }, {class: "plain", "aria-pressed": String(key === mount)}))));
  search.value = filter;
  fill();
  return make("div", {}, make("h2", {}, "Modules"), search, list);
}

function parameters(robot, entry) {
  const values = mount && entry.keys.get(mount), file = entry.mounts.find(({key}) => key === mount)?.filename;
  const part = make("div", {}, make("h2", {}, mount || "No module"), file ? make("p", {class: "soft"}, "last read from ", make("code", {}, file)) : null);
  if (!mount) part.append(empty("The robot lists no parameters", "It may ask for a secret before it shows them."));
  else if (!values) part.append(make("p", {class: "soft"}, entry.connected ? "Asking the robot …" : "It was not asked before it went."));
  else if (!values.length) part.append(make("p", {class: "soft"}, "This module has no parameters."));
  else part.append(make("table", {class: "parameters"}, make("tbody", {}, ...values.map(value => parameter(robot, entry, value)))), saving(robot, entry));
  return part;
}

const textOf = value => JSON.stringify(value), long = 60; // letters
const isCommand = key => mount === runner && commands.includes(key);

function parameter(robot, entry, {key, value}) {
  if (isCommand(key)) {
    return make("tr", {}, make("th", {scope: "row"}, key), make("td", {class: "soft", colspan: "2"}, "A command, not a setting: Calibrate and Next poses give it."));
  }
  const place = robot + "\n" + mount + "\n" + key, here = mount, id = "parameter-" + key, isLong = textOf(value).length > long;
  const before = isLong ? JSON.stringify(value, null, 1) : textOf(value);
  const input = isLong ? make("textarea", {class: "code", spellcheck: "false", rows: "6", id})
    : make("input", {type: "text", class: "code", spellcheck: "false", autocomplete: "off", id});
  const set = button("Set", change, {class: "small", "aria-label": "set " + key});
  const back = button("Back", () => { edits.delete(place); show(); }, {class: "small", "aria-label": "take the change of " + key + " back"});
  const row = make("tr", {}, make("th", {scope: "row"}, make("label", {for: id}, key)), make("td", {}, input), make("td", {class: "nowrap"}, set, " ", back));
  function show() {
    input.value = edits.get(place) ?? before;
    let isJson = true;
    try { JSON.parse(input.value); } catch { isJson = false; }
    input.setAttribute("aria-invalid", String(!isJson));
    input.title = isJson ? "" : "not JSON: a text needs quotes, a list brackets";
    row.className = edits.has(place) ? "edited" : "";
    set.disabled = !edits.has(place) || !isJson || !entry.connected;
    back.disabled = !edits.has(place);
  }
  function change() {
    if (set.disabled || !act({do: "set", robot, settings: [{mp: here, key, value: JSON.parse(input.value)}]})) return;
    changed.set(place, {text: textOf(JSON.parse(input.value)), answered: false});
    edits.delete(place);
    act({do: "keys", robot, mount: here}); // what the robot took
  }
  input.addEventListener("input", () => { if (input.value === before) edits.delete(place); else edits.set(place, input.value); show(); });
  input.addEventListener("keydown", event => { if (event.key === "Enter" && !isLong) change(); if (event.key === "Escape") { edits.delete(place); show(); } });
  show();
  return row;
}

// What was set from here and may be saved; the robot saves whatever was set on it by anybody.
function saving(robot, {connected}) {
  const again = () => showKeys(parentShown), here = [...changed].filter(([place]) => place.startsWith(robot + "\n"));
  if (confirming !== robot) return make("p", {class: "controls"}, button("Save …", () => { confirming = robot; again(); }, {disabled: !connected}));
  return savingOn(robot, [here.length ? make("ul", {}, ...here.map(([place, {text}]) => make("li", {}, make("code", {}, place.split("\n").slice(1).join(" ") + " = " + text))))
    : "Nothing was set from this page since it was opened."], () => { confirming = null; again(); }, () => here.forEach(([place]) => changed.delete(place)));
}
