// Applies a result to a robot: effective immediately, written to its files after a second confirmation.
import {button, confirmation, element} from "naocal/lib/dom.js";
import {number} from "naocal/lib/format.js";
import {act, say, state} from "../core/state.js";
import {mountsMount, offsetsMount, savingOn} from "../robots/controls.js";
import {selectedRobot, nameOf, needKeys, robots, matchRobot} from "../robots/robots.js";

const settable = /^(jointOffset|cameraRotation|backlash|hysteresis)$/; // backlash and hysteresis count as their average offset in these captures
let confirming = null; // {what, robot}

const olds = keys => (mp, key) => (keys.get(mp) || []).find(one => one.key === key)?.value;

// New and old values: offsets [deg], mounts [rad], as in HULKs' configuration.
function changesOf({compensation: {offsets, mounts}}, had) {
  const change = (mp, key, value) => ({mp, key, value, old: had(mp, key)});
  const keyOf = joint => joint.charAt(0).toLowerCase() + joint.slice(1);
  const joints = joint => joint === "LHipYawPitch" ? [joint, "RHipYawPitch"] : [joint]; // driven by one motor
  return [...offsets.flatMap(({joint, value}) => joints(joint).map(one => change(offsetsMount, keyOf(one), value))),
    ...mounts.map(({camera, rotation}) => change(mountsMount, camera + "_ext", rotation))];
}

const degrees = value => number(value.toFixed(2)) + "°";
function cell(value) {
  const words = value === undefined ? ["–"] : Array.isArray(value) ? value.map(one => degrees(one * 180 / Math.PI)) : [degrees(value)];
  return element("td", {class: "number wrap"}, ...words.flatMap(one => [element("span", {}, one), " "]));
}

function table(changes) {
  const head = ["", "now", "new"].map((words, i) => element("th", {scope: "col", class: i ? "number" : ""}, words));
  return element("table", {class: "narrow"}, element("thead", {}, element("tr", {}, ...head)), element("tbody", {}, ...changes.map(({key, old, value}) =>
    element("tr", {}, element("th", {scope: "row"}, key.replace("_ext", " camera (rx ry rz)")), cell(old), cell(value)))));
}

// Values before the last applied result; lost when the page is closed.
const before = new Map(); // by robot: settings

function put(robot, changes, words) {
  if (!act({do: "set", robot, settings: changes.map(({mp, key, value}) => ({mp, key, value}))})) return false;
  say(words);
  [offsetsMount, mountsMount].forEach(mount => act({do: "keys", robot, mount})); // reads back the accepted values
  return true;
}

function applied(robot, changes) {
  const had = changes.filter(({old, value}) => old !== undefined && JSON.stringify(old) !== JSON.stringify(value));
  if (put(robot, changes, "Sent to " + nameOf(robot) + ". Save writes it to the robot's files.") && had.length) before.set(robot, had.map(({mp, key, old}) => ({mp, key, value: old})));
}

const untouched = (fit, changes) => {
  const others = [...new Set(fit.with.map(label => label.split("@")[0]))].filter(effect => !settable.test(effect)), {untold} = fit.compensation;
  return [table(changes), ...(untold.length ? ["These captures hardly determine " + untold.join(", ") + ": the robot keeps its present values."] : []),
    ...(others.length ? ["Effects beyond constant offsets (" + others.join(", ") + ") cannot be set on the robot."] : [])];
};

function question(what, {robot, fit, changes, earlier, leave}) {
  const name = nameOf(robot), counts = " It takes effect immediately, and lasts until the robot restarts unless it is saved.";
  if (what === "save") return savingOn(robot, [], leave);
  if (what === "back") {
    return confirmation(["Put back what " + name + " had before the last result was put on it?" + counts, table(earlier)], "Put back on " + name, () => {
      if (put(robot, earlier, "Sent to " + name + " what it had before.")) before.delete(robot);
      leave();
    }, leave);
  }
  return confirmation(["Set this on " + name + "?" + counts + (fit.usable ? "" : " This result should not be used."), matchRobot(state.set, robot), ...untouched(fit, changes)], "Apply to " + name, () => {
    applied(robot, changes);
    leave();
  }, leave);
}

export function applying(fit, again) {
  const robot = selectedRobot(), entry = robot && robots.get(robot);
  if (!state.set.isNao || !entry || !entry.connected || !entry.mounts.some(({key}) => key === offsetsMount)) return [];
  const mounts = [offsetsMount, mountsMount].filter(mount => entry.mounts.some(({key}) => key === mount));
  mounts.forEach(mount => needKeys(robot, mount));
  const isKnown = mounts.every(mount => entry.keys.get(mount)), had = olds(entry.keys);
  const changes = changesOf(fit, had).filter(({mp}) => mounts.includes(mp)), earlier = before.get(robot)?.map(one => ({...one, old: had(one.mp, one.key)}));
  const asks = what => () => { confirming = what && {what, robot}; again(); };
  const asked = confirming?.robot === robot && (confirming.what !== "back" || earlier) ? confirming.what : null;
  return [element("p", {class: "controls"}, button("Apply to " + nameOf(robot) + " …", asks("apply"), {disabled: !isKnown || !changes.length}),
    earlier ? button("Put back …", asks("back"), {title: "what it had before the last result was put on it"}) : null, button("Save …", asks("save"))),
  asked && isKnown ? question(asked, {robot, fit, changes, earlier, leave: asks(null)}) : ""];
}
