// Robots: connections, states, and the selected one.
import {button, confirmation, element, keepingFocus} from "naocal/lib/dom.js";
import {on} from "../core/connection.js";
import {act, of, state, valueOf} from "../core/state.js";
import {running, stateKey, health} from "./health.js";

export const robots = state.robots; // by address: {connected, sentence, list, mounts, keys: Map by mount}
/** A listed robot's entry. @param {string} robot @returns {import("../core/messages.js").RobotEntry} */
export const entryOf = robot => /** @type {any} */ (robots.get(robot));
const typedSecrets = new Map(); // by robot, until sent
let looked = null, typed = "", leaving = null; // leaving: calibrating robot whose disconnection awaits confirmation

// A reconnected bridge lists its robots first; their states follow.
on("hello", ({robots: there}) => { for (const name of [...robots.keys()]) if (!there.includes(name)) robots.delete(name); });

export function bridgeLost() {
  for (const entry of robots.values()) Object.assign(entry, {connected: false, sentence: "is unreachable: the bridge is away"});
}

// Head name from the robot's configuration; "" if unknown.
export function headName(robot) {
  const name = (robots.get(robot)?.keys.get("tuhhSDK.base") || []).find(({key}) => key === "NaoInfo.headName")?.value;
  return typeof name === "string" ? name : "";
}

// "Ada (10.1.24.13)": head name and address.
export function displayName(robot) {
  const name = headName(robot);
  return name && name !== robot ? name + " (" + robot + ")" : robot;
}

// "Ada", or the address if the name is unknown or not unique.
export function nameOf(robot) {
  const name = headName(robot);
  return name && [...robots.keys()].every(other => other === robot || headName(other) !== name) ? name : robot;
}

let awaitsSimulated = false; // a simulated robot that is to be shown
/** Starts a simulated robot if none runs, and shows it in Calibrate. */
export function simulateRobot() {
  const robot = state.start?.robot;
  if (robot?.state !== "running") awaitsSimulated = act({do: "startRobot"});
  else showRobot(robot.address);
}
on("start", ({robot}) => {
  if (!awaitsSimulated || robot.state !== "running") return;
  awaitsSimulated = false;
  showRobot(robot.address);
});

/** Shows a robot in Calibrate. @param {string} robot */
export function showRobot(robot) {
  lookAt(robot);
  if (location.hash === "#match") dispatchEvent(new HashChangeEvent("hashchange")); // draws the view again
  else location.hash = "match";
}

/** Selects a robot; it may be listed later. @param {string} robot */
export const lookAt = robot => { looked = robot; };

export const selectedRobot = () => robots.get(looked) ? looked : (robots.keys().next().value ?? null);

// Returns false if no view needs a redraw (repeated lists are keep-alives).
export function onMessage(message) {
  const {kind, robot} = message;
  if (["update", "picture", "taken", "scene", "seen", "stand"].includes(kind)) return true;
  if (kind === "robotGone") return robots.delete(robot);
  if (!robots.has(robot)) robots.set(robot, {connected: false, sentence: "connecting", list: [], mounts: [], keys: new Map()});
  const entry = entryOf(robot);
  if (kind === "robot") {
    if (message.connected && !entry.connected) { // discards values from before the reconnection
      entry.keys.clear();
      of(robot).values.clear();
    }
    if (robot === typed.trim()) typed = "";
    Object.assign(entry, {connected: message.connected, sentence: message.sentence});
    needKeys(robot, "tuhhSDK.base");
  }
  if (kind === "keys" && message.body && message.body.mountPoint) {
    entry.keys.set(message.body.mountPoint, keysOf(message.body));
    for (const chip of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("[data-called]"))) chip.textContent = displayName(chip.dataset.called);
  }
  if (kind === "list" || kind === "mounts") {
    const names = JSON.stringify(entry[kind].map(({key}) => key));
    entry[kind] = keysOf(message.body);
    return names !== JSON.stringify(entry[kind].map(({key}) => key));
  }
  return true;
}

const keysOf = body => body && Array.isArray(body.keys) ? body.keys.filter(({key}) => typeof key === "string").sort((a, b) => a.key < b.key ? -1 : 1) : [];

// Requests a mount's keys once; the bridge defers the request until the robot lists the mount.
export function needKeys(robot, mount) {
  const {keys, connected} = entryOf(robot);
  if (connected && !keys.has(mount) && act({do: "keys", robot, mount})) keys.set(mount, null);
}

// Robot bar above every robot view; `changed` redraws the view.
export function robotBar(changed) {
  const address = element("input", {type: "text", id: "address", placeholder: "nao21, HOST:PORT or /sockets", "aria-label": "robot to connect to", spellcheck: "false", autocomplete: "off"});
  address.value = typed;
  address.addEventListener("input", () => { typed = address.value; });
  const form = element("form", {class: "controls", onsubmit: event => {
    event.preventDefault();
    if (typed.trim() && act({do: "connect", robot: typed.trim()})) looked = typed.trim(); // the address stays until the bridge has accepted it
  }}, address, element("button", {type: "submit"}, "Connect"));
  const classOf = (name, {connected, list}) => ["robot", connected && "connected", connected && !list.length && "silent", name === selectedRobot() && "is-looked"].filter(Boolean).join(" ");
  const chips = [...robots].map(([name, entry]) => element("span", {class: classOf(name, entry)},
    button(displayName(name), () => { looked = name; changed(); }, {class: "plain", "data-called": name, "aria-pressed": String(name === selectedRobot())}),
    element("span", {class: "soft"}, entry.sentence), health(name),
    button("×", () => leave(name, changed), {class: "small", "aria-label": "disconnect from " + name})));
  const name = selectedRobot();
  return element("div", {class: "robots"}, ...chips, form, name && entryOf(name).connected && !entryOf(name).list.length ? secretForm(name) : null,
    leaving && robots.has(leaving) ? confirmation(leaving + " is calibrating. Without its panel it stops and goes back to its stand. Disconnect?", "Disconnect", () => {
      act({do: "disconnect", robot: leaving});
      leaving = null;
    }, () => { leaving = null; changed(); }) : null);
}

function leave(robot, changed) {
  if (!entryOf(robot).connected || !running(valueOf(robot, stateKey)?.phase ?? "idle")) return act({do: "disconnect", robot});
  leaving = robot;
  changed();
}

// Redraws only the bar, after changes of other robots.
export function refreshBar(parent, changed) {
  keepingFocus(parent, () => parent.querySelector(".robots")?.replaceWith(robotBar(changed)));
}

// Form for the secret; until a networked robot receives it (access.json), it lists nothing.
function secretForm(robot) {
  const secret = element("input", {type: "password", id: "secret", oninput: () => typedSecrets.set(robot, secret.value), placeholder: "its secret", "aria-label": "secret of " + robot, autocomplete: "off"});
  secret.value = typedSecrets.get(robot) ?? "";
  return element("form", {class: "controls", onsubmit: event => {
    event.preventDefault();
    if (!act({do: "set", robot, settings: [{mp: "naocal.access", key: "secret", value: secret.value}]})) return;
    typedSecrets.delete(robot);
    secret.value = "";
  }}, secret, element("button", {type: "submit"}, "Send secret"));
}

// Reason why there is nothing to show: title, text and next steps; null if there is something.
/** @returns {[string, ...(string | Node)[]] | null} */
export function whyNothing() {
  const name = selectedRobot();
  if (!name) {
    return ["No robot yet", "Type a robot's name or address above: HOST, HOST:PORT with its base port (12440 unless it was changed), or the folder of its UNIX sockets.",
      element("span", {class: "controls next-steps"}, button("Simulate a robot", simulateRobot, {class: "main"}), button("Look for robots", () => { location.hash = "home"; }))];
  }
  const {connected, sentence, list} = entryOf(name);
  if (connected && !list.length) return [name + " shows nothing yet", "It lists no values. A robot reached over the network requires its secret first: type it above."];
  if (!connected && !list.length) return [name + " is not connected", name + " " + (sentence === "connecting" ? "is being connected …" : sentence + ". The panel retries every second.")];
  return null;
}

// Compares the head and body ids of captures with a robot's.

const toldBy = (keys, names) => names.map(name => keys.find(({key}) => key === name)?.value).find(value => typeof value === "string" && value);

function stands(keys, part, id) {
  const own = toldBy(keys, ["NaoInfo." + part + "Id"]), called = toldBy(keys, ["NaoInfo." + part + "Name"]);
  if (!id) return "unknown";
  if (own) return own === id ? "its" : "another's";
  return called === id ? "its" : "unknown"; // parts without a name in id_map.json are named by their id
}

// Text or warning shown before applying a result of these captures to that robot.
export function matchRobot({headId, bodyId}, robot) {
  const keys = robots.get(robot)?.keys.get("tuhhSDK.base") || [], name = nameOf(robot);
  const parts = [["head", headId], ["body", bodyId]], how = parts.map(([part, id]) => stands(keys, part, id));
  const of = "These captures are of " + parts.map(([part, id]) => part + " " + (id || "(unknown)")).join(" and ");
  const warning = words => element("p", {class: "bad"}, words);
  if (how.includes("another's")) {
    const others = parts.filter((_, i) => how[i] === "another's").map(([part]) => part).join(" and ");
    return warning(of + ", but " + name + " has another " + others + ": its joints and cameras differ. Take captures with " + name + " itself.");
  }
  if (how.includes("unknown")) {
    const called = parts.map(([part]) => part + " " + (toldBy(keys, ["NaoInfo." + part + "Id", "NaoInfo." + part + "Name"]) || "(unknown)")).join(" and ");
    return warning(of + "; " + name + " reports " + called + ". Make sure that it is the same robot: joints and cameras differ between robots.");
  }
  return of + ": those of " + name + ".";
}
