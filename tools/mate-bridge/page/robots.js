// The robots: connecting, how each stands, and which one is looked at.
import {make, button, confirmation, keepingFocus} from "./elements.js";
import {on} from "./connection.js";
import {state, act} from "./state.js";
import {vitals} from "./vitals.js";
import {of, valueOf} from "./values.js";
import {stateKey, running} from "./follow.js";

export const robots = state.robots; // by address: {connected, sentence, list, mounts, keys: Map by mount}
const typedSecrets = new Map(); // by robot, until it is told
let looked = null, typed = "", leaving = null; // the robot that is to be left while it calibrates

// A bridge that is back says which robots it still has; how each stands follows.
on("hello", ({robots: there}) => { for (const name of [...robots.keys()]) if (!there.includes(name)) robots.delete(name); });

export function bridgeLost() {
  for (const entry of robots.values()) Object.assign(entry, {connected: false, sentence: "is out of sight: the bridge is away"});
}

// Its head's name, as its own configuration has it; "" where that is not known.
function headName(robot) {
  const name = (robots.get(robot)?.keys.get("tuhhSDK.base") || []).find(({key}) => key === "NaoInfo.headName")?.value;
  return typeof name === "string" ? name : "";
}

// "Ada (10.1.24.13)": its name, and where it is reached.
export function calledBy(robot) {
  const name = headName(robot);
  return name && name !== robot ? name + " (" + robot + ")" : robot;
}

// "Ada", or where it is reached if it has no name of its own.
export function nameOf(robot) {
  const name = headName(robot);
  return name && [...robots.keys()].every(other => other === robot || headName(other) !== name) ? name : robot;
}

export const lookedAt = () => robots.get(looked) ? looked : (robots.keys().next().value ?? null);

// False: nothing that views show has changed; a list that only repeats itself says that the robot is alive.
export function told(message) {
  const {kind, robot} = message;
  if (["update", "picture", "taken", "scene", "seen", "stand"].includes(kind)) return true;
  if (kind === "robotGone") return robots.delete(robot);
  if (!robots.has(robot)) robots.set(robot, {connected: false, sentence: "connecting", list: [], mounts: [], keys: new Map()});
  const entry = robots.get(robot);
  if (kind === "robot") {
    if (message.connected && !entry.connected) { // what it had before may be true no more
      entry.keys.clear();
      of(robot).values.clear();
    }
    if (robot === typed.trim()) typed = "";
    Object.assign(entry, {connected: message.connected, sentence: message.sentence});
    needKeys(robot, "tuhhSDK.base");
  }
  if (kind === "keys" && message.body && message.body.mountPoint) {
    entry.keys.set(message.body.mountPoint, keysOf(message.body));
    for (const chip of document.querySelectorAll("[data-called]")) chip.textContent = calledBy(chip.dataset.called);
  }
  if (kind === "list" || kind === "mounts") {
    const names = JSON.stringify(entry[kind].map(({key}) => key));
    entry[kind] = keysOf(message.body);
    return names !== JSON.stringify(entry[kind].map(({key}) => key));
  }
  return true;
}

const keysOf = body => body && Array.isArray(body.keys) ? body.keys.filter(({key}) => typeof key === "string").sort((a, b) => a.key < b.key ? -1 : 1) : [];

// Asks a robot for a mount's keys unless they are known, or were asked for; the bridge waits until the robot lists it.
export function needKeys(robot, mount) {
  const {keys, connected} = robots.get(robot);
  if (connected && !keys.has(mount) && act({do: "keys", robot, mount})) keys.set(mount, null);
}

// The row on top of every robot view; `changed` draws the view anew.
export function robotBar(changed) {
  const address = make("input", {type: "text", id: "address", placeholder: "nao21, HOST:PORT or /sockets", "aria-label": "robot to connect to", spellcheck: "false", autocomplete: "off"});
  address.value = typed;
  address.addEventListener("input", () => { typed = address.value; });
  const form = make("form", {class: "controls", onsubmit: event => {
    event.preventDefault();
    if (typed.trim() && act({do: "connect", robot: typed.trim()})) looked = typed.trim(); // it stays there until the bridge has taken it
  }}, address, make("button", {type: "submit"}, "Connect"));
  const classOf = (name, {connected, list}) => ["robot", connected && "connected", connected && !list.length && "silent", name === lookedAt() && "is-looked"].filter(Boolean).join(" ");
  const chips = [...robots].map(([name, entry]) => make("span", {class: classOf(name, entry)},
    button(calledBy(name), () => { looked = name; changed(); }, {class: "plain", "data-called": name, "aria-pressed": String(name === lookedAt())}),
    make("span", {class: "soft"}, entry.sentence), vitals(name),
    button("×", () => leave(name, changed), {class: "small", "aria-label": "disconnect from " + name})));
  const name = lookedAt();
  return make("div", {class: "robots"}, ...chips, form, name && robots.get(name).connected && !robots.get(name).list.length ? secretForm(name) : null,
    leaving && robots.has(leaving) ? confirmation(leaving + " calibrates. Without its panel it ends that and goes back to its stand. Disconnect?", "Disconnect", () => {
      act({do: "disconnect", robot: leaving});
      leaving = null;
    }, () => { leaving = null; changed(); }) : null);
}

function leave(robot, changed) {
  if (!robots.get(robot).connected || !running(valueOf(robot, stateKey)?.phase ?? "idle")) return act({do: "disconnect", robot});
  leaving = robot;
  changed();
}

// Only that row: another robot has news.
export function refreshBar(parent, changed) {
  keepingFocus(parent, () => parent.querySelector(".robots")?.replaceWith(robotBar(changed)));
}

// A robot that listens beyond its own computer shows nothing before it is told its secret (access.json).
function secretForm(robot) {
  const secret = make("input", {type: "password", id: "secret", oninput: () => typedSecrets.set(robot, secret.value), placeholder: "its secret", "aria-label": "secret of " + robot, autocomplete: "off"});
  secret.value = typedSecrets.get(robot) ?? "";
  return make("form", {class: "controls", onsubmit: event => {
    event.preventDefault();
    if (!act({do: "set", robot, settings: [{mp: "naocal.access", key: "secret", value: secret.value}]})) return;
    typedSecrets.delete(robot);
    secret.value = "";
  }}, secret, make("button", {type: "submit"}, "Tell it"));
}

// What to say where there is nothing to look at; null where there is.
export function whyNothing() {
  const name = lookedAt();
  if (!name) return ["No robot yet", "Type a robot's name or address above: HOST, HOST:PORT with its base port (12440 unless it was changed), or the folder of its UNIX sockets."];
  const {connected, sentence, list} = robots.get(name);
  if (connected && !list.length) return [name + " shows nothing yet", "It lists no values. A robot that is reached over the network wants its secret first: type it above."];
  if (!connected && !list.length) return [name + " is not connected", name + " " + (sentence === "connecting" ? "is being connected to …" : sentence + ". It is tried again every second.")];
  return null;
}
