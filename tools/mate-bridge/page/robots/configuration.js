// Configuration view: parameters of all mounts; set one by one, saved after a confirmation.
import {button, element, empty, renew} from "naocal/lib/dom.js";
import {act, notice} from "../core/state.js";
import {runner, savingOn} from "./controls.js";
import {entryOf, nameOf, needKeys, refreshBar, robotBar, selectedRobot, whyNothing} from "./robots.js";

let mount = null, parentShown = null, filter = "", confirming = null; // confirming: robot whose save awaits confirmation
const edits = new Map(); // unsent text by robot, mount and key
const changed = new Map(); // values set, by robot, mount and key
const commands = ["run", "confirmed", "poses"]; // runner keys that move the robot; set in Calibrate, with a confirmation

export function showKeys(parent) {
  parentShown = parent;
  const robot = selectedRobot(), why = whyNothing();
  renew(parent, element("div", {class: "heading"}, element("h1", {}, "Configuration"), robotBar(() => showKeys(parent))), ...(why ? [empty(...why)] : content(robot)));
}

export function onMessage(message, isShown) {
  if (message.kind === "keys") compare(message);
  if (message.kind === "robotGone" || (message.kind === "robot" && !message.connected)) forget(message.robot);
  if (!isShown || !parentShown || !["robot", "robotGone", "mounts", "keys"].includes(message.kind)) return;
  if (message.robot === selectedRobot() || message.kind === "robotGone") showKeys(parentShown);
  else refreshBar(parentShown, () => showKeys(parentShown));
}

// A robot that restarts has its saved values again.
const forget = robot => [...changed.keys()].filter(place => place.startsWith(robot + "\n")).forEach(place => changed.delete(place));

// A robot rejects a value silently: its reply then contains the old value.
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
  const entry = entryOf(robot);
  if (!entry.mounts.some(({key}) => key === mount)) mount = entry.mounts.length ? entry.mounts[0].key : null;
  if (mount) needKeys(robot, mount);
  return [entry.connected ? element("p", {class: "soft"}, "Changes take effect immediately and last until the robot restarts. Saving writes all changes to the robot's files.")
    : element("p", {class: "bad"}, nameOf(robot) + " " + entry.sentence + ". Nothing can be set until it is back."),
    element("div", {class: "split keys-split"}, mountList(robot, entry), parameters(robot, entry))];
}

function mountList(robot, {mounts, keys}) {
  const search = element("input", {type: "search", id: "mountFilter", placeholder: "filter " + mounts.length + " modules", "aria-label": "filter modules", oninput: () => { filter = search.value; fill(); }});
  const list = element("ul", {class: "keylist"});
  const fill = () => list.replaceChildren(...mounts.filter(({key}) => key.toLowerCase().includes(filter.toLowerCase())).map(({key}) => element("li", {},
    button(key, () => { mount = key; keys.delete(key); showKeys(parentShown); }, {class: "plain", "aria-pressed": String(key === mount)}))));
  search.value = filter;
  fill();
  return element("div", {}, element("h2", {}, "Modules"), search, list);
}

function parameters(robot, entry) {
  const values = mount && entry.keys.get(mount), file = entry.mounts.find(({key}) => key === mount)?.filename;
  const part = element("div", {}, element("h2", {}, mount || "No module"), file ? element("p", {class: "soft"}, "last read from ", element("code", {}, file)) : null);
  if (!mount) part.append(empty("The robot lists no parameters", "It may require a secret first."));
  else if (!values) part.append(element("p", {class: "soft"}, entry.connected ? "Asking the robot …" : "Not known: the robot is gone."));
  else if (!values.length) part.append(element("p", {class: "soft"}, "This module has no parameters."));
  else part.append(element("table", {class: "parameters"}, element("tbody", {}, ...values.map(value => parameter(robot, entry, value)))), saving(robot, entry));
  return part;
}

const textOf = value => JSON.stringify(value), long = 60; // characters; longer values get a text area
const isCommand = key => mount === runner && commands.includes(key);

function parameter(robot, entry, {key, value}) {
  if (isCommand(key)) {
    return element("tr", {}, element("th", {scope: "row"}, key), element("td", {class: "soft", colspan: "2"}, "A command, not a setting: use Calibrate or Next poses."));
  }
  const place = robot + "\n" + mount + "\n" + key, here = mount, id = "parameter-" + key, isLong = textOf(value).length > long;
  const before = isLong ? JSON.stringify(value, null, 1) : textOf(value);
  const input = isLong ? element("textarea", {class: "code", spellcheck: "false", rows: "6", id})
    : element("input", {type: "text", class: "code", spellcheck: "false", autocomplete: "off", id});
  const set = button("Set", change, {class: "small", "aria-label": "set " + key});
  const back = button("Back", () => { edits.delete(place); show(); }, {class: "small", "aria-label": "take the change of " + key + " back"});
  const row = element("tr", {}, element("th", {scope: "row"}, element("label", {for: id}, key)), element("td", {}, input), element("td", {class: "nowrap"}, set, " ", back));
  function show() {
    input.value = edits.get(place) ?? before;
    let isJson = true;
    try { JSON.parse(input.value); } catch { isJson = false; }
    input.setAttribute("aria-invalid", String(!isJson));
    input.title = isJson ? "" : "not JSON: a text needs quotes, a list needs brackets";
    row.className = edits.has(place) ? "edited" : "";
    set.disabled = !edits.has(place) || !isJson || !entry.connected;
    back.disabled = !edits.has(place);
  }
  function change() {
    if (set.disabled || !act({do: "set", robot, settings: [{mp: here, key, value: JSON.parse(input.value)}]})) return;
    changed.set(place, {text: textOf(JSON.parse(input.value)), answered: false});
    edits.delete(place);
    act({do: "keys", robot, mount: here}); // reads back the accepted value
  }
  input.addEventListener("input", () => { if (input.value === before) edits.delete(place); else edits.set(place, input.value); show(); });
  input.addEventListener("keydown", (/** @type {any} */ event) => { if (event.key === "Enter" && !isLong) change(); if (event.key === "Escape") { edits.delete(place); show(); } });
  show();
  return row;
}

// Lists the values set on this page; the robot saves all values set by any client.
function saving(robot, {connected}) {
  const again = () => showKeys(parentShown), here = [...changed].filter(([place]) => place.startsWith(robot + "\n"));
  if (confirming !== robot) return element("p", {class: "controls"}, button("Save …", () => { confirming = robot; again(); }, {disabled: !connected}));
  return savingOn(robot, [here.length ? element("ul", {}, ...here.map(([place, {text}]) => element("li", {}, element("code", {}, place.split("\n").slice(1).join(" ") + " = " + text))))
    : "Nothing was set from this page so far."], () => { confirming = null; again(); }, () => here.forEach(([place]) => changed.delete(place)));
}
