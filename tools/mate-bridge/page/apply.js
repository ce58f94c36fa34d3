// A result put on a robot, as its own calibration would: it counts at once, and is written into its files only when
// that is confirmed too.
import {make, button, confirmation} from "./elements.js";
import {act, say} from "./state.js";
import {robots, lookedAt, needKeys, nameOf} from "./robots.js";
import {number} from "./words.js";
import {savingOn} from "./save.js";
import {offsetsMount, mountsMount} from "./steer.js";

const settable = /^(jointOffset|cameraRotation|backlash|hysteresis)$/; // a gap as what it was on average in these captures
let confirming = null; // {what, robot}

// What is to be set, beside what the robot has: offsets in degrees, mounts in radians, as HULKs' configuration has them.
function changesOf({compensation: {offsets, mounts}}, keys) {
  const had = (mp, key) => (keys.get(mp) || []).find(one => one.key === key)?.value;
  const change = (mp, key, value) => ({mp, key, value, old: had(mp, key)});
  const keyOf = joint => joint.charAt(0).toLowerCase() + joint.slice(1);
  const joints = joint => joint === "LHipYawPitch" ? [joint, "RHipYawPitch"] : [joint]; // these have one motor
  return [...offsets.flatMap(({joint, value}) => joints(joint).map(one => change(offsetsMount, keyOf(one), value))),
    ...mounts.map(({camera, rotation}) => change(mountsMount, camera + "_ext", rotation))];
}

const degrees = value => number(value.toFixed(2)) + "°";
function cell(value) {
  const words = value === undefined ? ["–"] : Array.isArray(value) ? value.map(one => degrees(one * 180 / Math.PI)) : [degrees(value)];
  return make("td", {class: "number wrap"}, ...words.flatMap(one => [make("span", {}, one), " "]));
}

function table(changes) {
  const head = ["", "on it now", "will be"].map((words, i) => make("th", {scope: "col", class: i ? "number" : ""}, words));
  return make("table", {class: "narrow"}, make("thead", {}, make("tr", {}, ...head)), make("tbody", {}, ...changes.map(({key, old, value}) =>
    make("tr", {}, make("th", {scope: "row"}, key.replace("_ext", " camera (rx ry rz)")), cell(old), cell(value)))));
}

export function applying(fit, again) {
  const robot = lookedAt(), entry = robot && robots.get(robot);
  if (!entry || !entry.connected || !entry.mounts.some(({key}) => key === offsetsMount)) return [];
  [offsetsMount, mountsMount].forEach(mount => needKeys(robot, mount));
  const changes = changesOf(fit, entry.keys), asks = what => () => { confirming = what && {what, robot}; again(); };
  const waits = what => confirming && confirming.what === what && confirming.robot === robot;
  const parts = [make("p", {class: "controls"}, button("Apply to " + nameOf(robot) + " …", asks("apply"), {disabled: !changes.length}),
    button("Save …", asks("save")))];
  if (waits("apply")) {
    const others = [...new Set(fit.with.map(label => label.split("@")[0]))].filter(effect => !settable.test(effect)), {untold} = fit.compensation;
    parts.push(confirmation(["Set this on " + nameOf(robot) + "? It counts at once, and until it ends unless it is saved." +
      (fit.usable ? "" : " This result should not be used."), table(changes),
      ...(untold.length ? ["These captures hardly tell " + untold.join(", ") + ": the robot keeps what it has there."] : []),
      ...(others.length ? ["What is beyond constant offsets (" + others.join(", ") + ") cannot be set on it."] : [])], "Apply to " + nameOf(robot), () => {
      confirming = null;
      const settings = changes.map(({mp, key, value}) => ({mp, key, value}));
      if (act({do: "set", robot, settings})) say("Sent to " + nameOf(robot) + ". Save writes it into its files.");
      [offsetsMount, mountsMount].forEach(mount => act({do: "keys", robot, mount})); // what it took
      again();
    }, asks(null)));
  }
  if (waits("save")) parts.push(savingOn(robot, [], asks(null)));
  return parts;
}
