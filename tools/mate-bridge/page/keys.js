// Configuration: every mount's parameters; each is set by itself, and saved only when the person confirms it.
import {make, button, empty, renew} from "./elements.js";
import {act, notice} from "./state.js";
import {robots, robotBar, lookedAt, whyNothing} from "./robots.js";

let mount = null, parentShown = null, filter = "", confirming = false;
const edits = new Map(); // text by robot, mount and key, until it is set

export function showKeys(parent) {
  parentShown = parent;
  const robot = lookedAt(), why = whyNothing();
  renew(parent, make("h1", {}, "Configuration"), robotBar(() => showKeys(parent)), ...(why ? [empty(...why)] : content(robot)));
}

export function keysTold(message, isShown) {
  if (isShown && parentShown && message.kind !== "update" && message.kind !== "picture" && message.kind !== "list") showKeys(parentShown);
}

function content(robot) {
  const entry = robots.get(robot);
  if (!entry.mounts.some(({key}) => key === mount)) mount = entry.mounts.length ? entry.mounts[0].key : null;
  if (mount && !entry.keys.has(mount)) {
    entry.keys.set(mount, null); // asked for
    act({do: "keys", robot, mount});
  }
  return [entry.connected ? make("p", {class: "soft"}, "A value that is set counts at once and until the robot ends. Saving writes all that was set into the robot's own files.")
    : make("p", {class: "bad"}, robot + " " + entry.sentence + ". Nothing can be set until it is back."),
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
  else if (!values) part.append(make("p", {class: "soft"}, "Asking the robot …"));
  else if (!values.length) part.append(make("p", {class: "soft"}, "This module has no parameters."));
  else part.append(make("table", {class: "parameters"}, make("tbody", {}, ...values.map(value => parameter(robot, entry, value)))), saving(robot, entry));
  return part;
}

const textOf = value => JSON.stringify(value);

function parameter(robot, entry, {key, value}) {
  const place = robot + "\n" + mount + "\n" + key, before = textOf(value), here = mount, id = "parameter-" + key;
  const input = make("input", {type: "text", class: "code", spellcheck: "false", autocomplete: "off", id});
  const set = button("Set", change, {class: "small", "aria-label": "set " + key}), back = button("Back", () => { edits.delete(place); show(); }, {class: "small", "aria-label": "take the change of " + key + " back"});
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
    if (set.disabled) return;
    act({do: "set", robot, settings: [{mp: here, key, value: JSON.parse(input.value)}]});
    edits.delete(place);
    act({do: "keys", robot, mount: here}); // what the robot took
  }
  input.addEventListener("input", () => { if (input.value === before) edits.delete(place); else edits.set(place, input.value); show(); });
  input.addEventListener("keydown", event => { if (event.key === "Enter") change(); if (event.key === "Escape") { edits.delete(place); show(); } });
  show();
  return row;
}

function saving(robot, {connected}) {
  const again = () => showKeys(parentShown);
  if (!confirming) return make("p", {class: "controls"}, button("Save …", () => { confirming = true; again(); }, {disabled: !connected}));
  return make("div", {class: "confirm", role: "group", "aria-label": "confirm saving"}, make("p", {}, "Write everything that was set on " + robot + " into its own configuration files?"),
    make("p", {class: "controls"}, button("Save on " + robot, () => { confirming = false; act({do: "save", robot}); notice("Asked " + robot + " to save. (HULKs' protocol has no answer to this.)"); again(); }, {class: "main", disabled: !connected}),
      button("Not now", () => { confirming = false; again(); })));
}
