// Calibrate: beside the field. Start, see what the robot does and waits for, stop at any moment, see what it brought,
// take it back.
import {make, button, empty} from "./elements.js";
import {act, notice} from "./state.js";
import {robots, robotBar, lookedAt, whyNothing} from "./robots.js";
import {wish} from "./subscriptions.js";
import {Camera, cameraKeys} from "./camera.js";
import {outcome} from "./outcome.js";

const runner = "Brain.CalibrationRunner", offsetsMount = "Motion.JointCalibrationProvider", mountsMount = "Brain.Projection";
const stateKey = "Brain.calibration", playerKey = "Motion.player";
const running = phase => !["idle", "finished", "failed"].includes(phase);

let parentShown = null, shownRobot = null, cameras = [], parts = null, confirming = null;
const known = new Map(); // by robot: {state, player, before: offsets before the calibration}

const of = robot => {
  if (!known.has(robot)) known.set(robot, {state: null, player: null, before: null});
  return known.get(robot);
};

export function showMatch(parent) {
  parentShown = parent;
  shownRobot = lookedAt();
  const why = whyNothing();
  parent.replaceChildren(make("h1", {}, "Calibrate"), robotBar(() => showMatch(parent)), ...(why ? [empty(...why)] : content()));
  if (why) wish("match", null, []);
  else draw();
}

export function leaveMatch() {
  parentShown = null;
  wish("match", null, []);
}

function content() {
  const {list, mounts} = robots.get(shownRobot), {chosen} = cameraKeys(list);
  const can = list.some(({key}) => key === stateKey) && mounts.some(({key}) => key === runner);
  cameras = chosen.map((key, i) => key && {key, camera: new Camera((i ? "bottom" : "top") + " camera")}).filter(Boolean);
  wish("match", shownRobot, [stateKey, playerKey, ...cameras.map(({key}) => key)].filter(key => list.some(one => one.key === key)));
  if (can && !robots.get(shownRobot).keys.has(offsetsMount)) {
    robots.get(shownRobot).keys.set(offsetsMount, null);
    act({do: "keys", robot: shownRobot, mount: offsetsMount});
    act({do: "keys", robot: shownRobot, mount: runner});
  }
  parts = {steer: make("div"), progress: make("div"), result: make("div")};
  return [make("div", {class: "split match"}, make("div", {}, can ? parts.steer : empty("This robot does not calibrate itself",
      "It serves no " + stateKey + ": naocal-robot does. Its cameras and values can be seen all the same."), parts.progress, parts.result),
    make("div", {class: "cameras stacked"}, ...cameras.map(({camera, key}) => make("figure", {class: "camera"}, make("b", {}, camera.canvas.getAttribute("aria-label")),
      make("span", {class: "soft"}, " " + key), camera.canvas, camera.caption))))];
}

function draw() {
  if (!parentShown || !parts) return;
  const {state, player} = of(shownRobot), {connected, sentence} = robots.get(shownRobot), phase = state ? state.phase : "idle";
  const isRunning = running(phase);
  when("steer", [connected, isRunning, confirming === "start", sentence], () => steer(connected, isRunning, sentence));
  when("progress", [state, player && player.reason], () => state ? progress(state, player) : [make("p", {class: "soft"}, "Waiting for the robot's first word …")]);
  const {before} = of(shownRobot), now = robots.get(shownRobot).keys.get(offsetsMount), canUndo = connected && state && state.phase === "finished";
  when("result", [state && state.errorAfter, isRunning, before, now, canUndo, confirming === "undo"], () => [...outcome(state, isRunning, before, now),
    canUndo ? make("p", {class: "controls"}, button("Undo …", () => { confirming = "undo"; draw(); })) : "",
    confirming === "undo" ? confirm("Take back what was saved last, offsets and cameras?", "Undo on " + shownRobot, undo) : ""]);
}

// Draws a part anew only when what it shows has changed: nothing is taken from under a finger.
function when(name, shown, made) {
  const words = JSON.stringify(shown);
  if (parts[name].shown === words) return;
  parts[name].shown = words;
  parts[name].replaceChildren(...made());
}

function steer(connected, isRunning, sentence) {
  return [
    make("p", {class: "soft"}, "The robot stands on both feet and sees boards on the floor. It looks around, solves neck and cameras, looks around once " +
      "more elsewhere and keeps what it found only if the error falls by half. Its legs stay where they are."),
    make("p", {class: "controls big"},
      button("Calibrate neck and cameras", () => { confirming = "start"; draw(); }, {class: "main", disabled: !connected || isRunning || confirming === "start"}),
      button("Stop", stop, {class: "stop", disabled: !connected, title: "key s: the robot goes back to its stand"})),
    ...(confirming === "start" ? [confirm("The robot's head will move. Is everybody's hand off it?", "Start", start)] : []),
    ...(connected ? [] : [make("p", {class: "bad"}, shownRobot + " " + sentence + ". It is tried again every second.")])];
}

function progress(state, player) {
  const bar = make("progress", {max: "1", "aria-label": "progress of this round"});
  bar.value = state.poses ? state.pose / state.poses : running(state.phase) ? 0 : 1;
  return [make("h2", {}, state.phase.charAt(0).toUpperCase() + state.phase.slice(1)),
    make("p", {class: state.phase === "failed" ? "bad" : "", role: "status"}, state.sentence || "Ready."),
    state.phase === "idle" ? "" : make("div", {class: "progress"}, bar, make("span", {class: "number"}, state.poses ? "pose " + state.pose + " of " + state.poses : ""),
      make("span", {class: "number"}, state.captures + " pictures"), make("span", {class: "number"}, state.secondsLeft === null ? "" : "about " + Math.ceil(state.secondsLeft) + " s left")),
    player && player.reason ? make("p", {class: "bad"}, player.reason) : ""];
}

function confirm(question, yes, action) {
  return make("div", {class: "confirm", role: "group", "aria-label": "confirm"}, make("p", {}, question), make("p", {class: "controls"},
    button(yes, () => { confirming = null; action(); draw(); }, {class: "main"}), button("Not now", () => { confirming = null; draw(); })));
}

const set = (mp, key, value) => act({do: "set", robot: shownRobot, settings: [{mp, key, value}]});

function start() {
  const entry = robots.get(shownRobot);
  of(shownRobot).before = entry.keys.get(offsetsMount);
  set(runner, "run", ""); // only a change counts
  set(runner, "run", "head");
}

// Whatever runs ends: a value that differs from the one before, then none.
function stop() {
  confirming = null;
  set(runner, "run", "");
}

function undo() {
  for (const mount of [offsetsMount, mountsMount]) set("naocal.configuration", "undo", mount);
  act({do: "keys", robot: shownRobot, mount: offsetsMount});
  notice("Asked " + shownRobot + " to take back what was saved last.");
}

export function matchTold(message, file, isShown) {
  const {kind, robot} = message;
  if (kind === "picture") {
    const seen = isShown && robot === shownRobot && cameras.find(({key}) => key === message.key);
    if (seen) seen.camera.show(file, message);
    return;
  }
  if (kind === "update") {
    for (const {key, value} of message.values) {
      if (key === playerKey) of(robot).player = value;
      if (key === stateKey) {
        const old = of(robot).state;
        of(robot).state = value;
        if (old && running(old.phase) && !running(value.phase)) act({do: "keys", robot, mount: offsetsMount}); // what it has now
      }
    }
    if (isShown && robot === shownRobot) drawSoon();
    return;
  }
  if (isShown && parentShown) kind === "keys" ? draw() : showMatch(parentShown);
}

let due = false;
function drawSoon() {
  if (due) return;
  due = true;
  requestAnimationFrame(() => {
    due = false;
    draw();
  });
}

document.addEventListener("keydown", event => {
  if (event.key === "s" && parentShown && !/^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName)) stop();
});
