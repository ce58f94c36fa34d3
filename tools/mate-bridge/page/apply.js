// A result put on a robot: it counts at once, and is written into its files only when that is confirmed too.
import {make, button} from "./elements.js";
import {act, notice} from "./state.js";
import {robots, lookedAt} from "./robots.js";
import {offsetsMount, mountsMount} from "./steer.js";

let confirming = null;

// Offsets in degrees and mounts in radians, as HULKs' configuration has them.
function settingsOf({groups}) {
  const rowsOf = title => groups.filter(group => group.title === title && group.unit === "°").flatMap(({rows}) => rows), mounts = new Map();
  for (const {name, value} of rowsOf("camera rotation")) {
    const [camera, axis] = name.split(" ");
    if (!mounts.has(camera)) mounts.set(camera, [0, 0, 0]);
    mounts.get(camera)[["rx", "ry", "rz"].indexOf(axis)] = value * Math.PI / 180;
  }
  return [...rowsOf("joint offset").map(({name, value}) => ({mp: offsetsMount, key: name.charAt(0).toLowerCase() + name.slice(1), value})),
    ...[...mounts].map(([camera, value]) => ({mp: mountsMount, key: camera + "_ext", value}))];
}

export function applying(fit, again) {
  const robot = lookedAt(), entry = robot && robots.get(robot);
  if (!entry || !entry.connected) return [];
  const settings = settingsOf(fit), others = fit.with.filter(label => !/^(jointOffset|cameraRotation)@/.test(label));
  const ask = (question, yes, action) => make("div", {class: "confirm", role: "group", "aria-label": "confirm"}, make("p", {}, question),
    make("p", {class: "controls"}, button(yes, () => { confirming = null; action(); again(); }, {class: "main"}), button("Not now", () => { confirming = null; again(); })));
  const parts = [make("p", {class: "controls"}, button("Apply to " + robot + " …", () => { confirming = "apply"; again(); }, {disabled: !settings.length}),
    button("Save …", () => { confirming = "save"; again(); }))];
  if (confirming === "apply") {
    parts.push(ask("Set " + settings.length + " offsets and camera mounts on " + robot + " to what stands here? They count at once, and until it ends unless they are saved." +
      (others.length ? " What is beyond constant offsets (" + others.join(", ") + ") cannot be set on it." : "") + (fit.usable ? "" : " This result should not be used."), "Apply to " + robot,
    () => { act({do: "set", robot, settings}); notice("Set on " + robot + ". Save writes it into its files."); }));
  }
  if (confirming === "save") parts.push(ask("Write everything that was set on " + robot + " into its own configuration files?", "Save on " + robot, () => act({do: "save", robot})));
  return parts;
}
