// Calibrate: beside the field. Choose what to calibrate, see each pose before it is played, what the robot does, waits
// for and sees, stop at any moment, see what it brought, take it back.
import {make, empty, renew} from "./elements.js";
import {send} from "./connection.js";
import {act, notice} from "./state.js";
import {robots, robotBar, refreshBar, lookedAt, needKeys, nameOf, calledBy, whyNothing} from "./robots.js";
import {wish} from "./subscriptions.js";
import {cameraAt, cameraKeys} from "./camera.js";
import {of, valueOf} from "./values.js";
import {standingFigure} from "./standing.js";
import {floorFigure} from "./floor.js";
import {comingPoses, markStep} from "./coming.js";
import {capturesKey, capturesOf, thumbnails} from "./taken.js";
import {outcome, offsets, cameraMounts, outcomeKey} from "./outcome.js";
import {refreshVitals} from "./vitals.js";
import {stateKey, playerKey, healthKey, running} from "./follow.js";
import {steer, afterwards, ended, runner, offsetsMount, mountsMount} from "./steer.js";

const kindsKey = "Brain.calibrationKinds", posesKey = "Brain.calibrationPoses"; // {round, step, poses: [{name, angles}]}

let parentShown = null, shownRobot = null, cameras = [], parts = null, drawings = [];

export function showMatch(parent) {
  const before = shownRobot;
  parentShown = parent;
  shownRobot = lookedAt();
  if (before && before !== shownRobot) send({do: "unwatch", robot: before});
  const why = whyNothing();
  renew(parent, make("div", {class: "heading"}, make("h1", {}, "Calibrate"), robotBar(again)), ...(why ? [empty(...why)] : content()));
  if (why) wish("match", null, []);
  else draw();
}

const again = () => showMatch(parentShown);

export function leaveMatch() {
  parentShown = null;
  restWhenDone();
}

// While it calibrates, the bridge watches on for the pictures of its captures, whichever view is shown.
function restWhenDone() {
  if (parentShown || !shownRobot || running(valueOf(shownRobot, stateKey)?.phase ?? "idle")) return;
  send({do: "unwatch", robot: shownRobot});
  wish("match", null, []);
}

function content() {
  const {list, mounts, connected} = robots.get(shownRobot), {chosen} = cameraKeys(list);
  const can = list.some(({key}) => key === stateKey) && mounts.some(({key}) => key === runner);
  cameras = chosen.map((key, i) => key && {key, camera: cameraAt(shownRobot + "\n" + key, (i ? "bottom" : "top") + " camera")}).filter(Boolean);
  wish("match", shownRobot, [kindsKey, posesKey, capturesKey, outcomeKey, ...cameras.map(({key}) => key)].filter(key => list.some(one => one.key === key)));
  send({do: "watch", robot: shownRobot});
  if (!connected) cameras.filter(({camera}) => camera.times.length).forEach(({camera}) => { camera.caption.textContent = "the last picture that came"; });
  if (can) [offsetsMount, mountsMount].forEach(mount => needKeys(shownRobot, mount));
  const stance = standingFigure(() => ({now: of(shownRobot).scene, next: of(shownRobot).next}), "how the robot stands, and its next pose", 215);
  const floor = floorFigure(() => of(shownRobot).scene);
  drawings = [stance, floor];
  parts = Object.fromEntries(["steer", "progress", "after", "outcome", "offsets", "captures", "nextWords", "poses"].map(name => [name, make("div")]));
  const left = can ? [parts.steer, parts.progress, parts.poses] : [empty("This robot does not calibrate itself",
    "It serves no " + stateKey + ": naocal-robot does. Its cameras and values can be seen all the same.")];
  return [make("div", {class: "split match"}, make("div", {}, ...left, parts.outcome, parts.after, parts.offsets),
    make("div", {}, make("div", {class: "cameras beside"}, ...cameras.map(({camera}) => make("figure", {class: "camera"}, make("b", {}, camera.canvas.getAttribute("aria-label")), camera.canvas, camera.caption, camera.rests))),
      make("p", {class: "keys soft"}, make("span", {class: "key measured"}), " corner, ", make("span", {class: "key predicted"}), " where the current calibration predicts it"),
      make("div", {class: "cameras beside"}, make("div", {}, make("h2", {}, "Posture"), parts.nextWords, stance),
        make("div", {}, make("h2", {}, "The floor"), floor, make("p", {class: "keys soft"}, make("span", {class: "key topView"}), " what the top camera sees, ",
          make("span", {class: "key bottomView"}), " the bottom one; ", make("span", {class: "key weight"}), " centre of mass"))))), parts.captures];
}

function draw() {
  if (!parentShown || !parts) return;
  const entry = robots.get(shownRobot), state = valueOf(shownRobot, stateKey), player = valueOf(shownRobot, playerKey);
  const told = valueOf(shownRobot, outcomeKey), isRunning = running(state ? state.phase : "idle");
  const {before, mountsBefore} = of(shownRobot), captures = capturesOf(shownRobot), now = entry.keys.get(offsetsMount), mounts = entry.keys.get(mountsMount);
  steer({robot: shownRobot, entry, state, player, isRunning, kinds: valueOf(shownRobot, kindsKey), draw, when});
  when("progress", [state, player && player.reason, player && player.held], () => state ? progress(state, player) : [make("p", {class: "soft"}, "Waiting for the robot's first word …")]);
  const [offsetsBefore, cameraBefore] = [beforeIn(told, offsetsMount, before), beforeIn(told, mountsMount, mountsBefore)];
  when("outcome", [state && state.errorAfter, isRunning, told], () => outcome(state, isRunning, told));
  when("offsets", [told, offsetsBefore, now, cameraBefore, mounts], () => [...offsets(told, offsetsBefore, now), ...cameraMounts(cameraBefore, mounts)]);
  const round = valueOf(shownRobot, posesKey);
  when("poses", round && isRunning && [round.round, round.poses.map(({name}) => name)], () => round && isRunning ? comingPoses(round) : []);
  if (round) markStep(parts.poses, round.step);
  when("captures", captures, () => thumbnails(shownRobot));
  afterwards({robot: shownRobot, entry, state, isRunning, draw, when});
  next();
}

// What was set before the calibration: as the robot tells, else as this page saw it.
const beforeIn = (told, mount, seen) => told?.before?.[mount] ? Object.entries(told.before[mount]).map(([key, value]) => ({key, value})) : seen;

// Draws a part anew only when what it shows has changed: nothing is taken from under a finger.
function when(name, shown, made) {
  const words = JSON.stringify(shown);
  if (parts[name].shown === words) return;
  parts[name].shown = words;
  parts[name].replaceChildren(...made());
}

// The pose that comes next, worked out by the bridge once it is known.
let asked = 0;
function next() {
  const state = valueOf(shownRobot, stateKey), told = valueOf(shownRobot, posesKey), known = of(shownRobot), pose = told && state && running(state.phase) && told.poses[told.step];
  const words = JSON.stringify(pose || null);
  if (known.nextShown !== words) {
    known.nextShown = words;
    known.next = null;
    if (pose) send({do: "stand", number: known.nextNumber = ++asked, angles: pose.angles});
  }
  when("nextWords", [pose && pose.name, told && told.step, told && told.poses.length], () => [make("p", {class: "soft"},
    pose ? make("span", {}, make("span", {class: "key outline"}), " " + pose.name + ", " + (told.step + 1) + " of " + told.poses.length + " of this round; grey: as it stands now")
      : "Grey: as it stands now.")]);
}

function progress(state, player) {
  const bar = make("progress", {max: "1", "aria-label": "progress of this round"});
  bar.value = state.poses ? state.pose / state.poses : running(state.phase) ? 0 : 1;
  return [make("h2", {}, state.phase.charAt(0).toUpperCase() + state.phase.slice(1)),
    state.question ? "" : make("p", {class: state.phase === "failed" ? "bad" : "", role: "status"}, state.sentence || "Ready."),
    state.phase === "idle" ? "" : make("div", {class: "progress"}, bar, make("span", {class: "number"}, state.poses ? "pose " + state.pose + " of " + state.poses : ""),
      make("span", {class: "number"}, state.captures + " pictures"), make("span", {class: "number"}, state.secondsLeft === null ? "" : "about " + Math.ceil(state.secondsLeft) + " s left")),
    player && player.reason && !player.held && !(state.sentence || "").includes(player.reason) ? make("p", {class: "bad"}, player.reason) : ""];
}

export function matchTold(message, file, isShown) {
  const {kind, robot} = message, here = isShown && parentShown && robot === shownRobot;
  if (kind === "picture") {
    const seen = robot === shownRobot && cameras.find(({key}) => key === message.key);
    if (seen && here) seen.camera.show(file, message);
  } else if (kind === "seen") {
    const seen = here && cameras.find(({key}) => key === message.key);
    if (seen) seen.camera.found = message;
  } else if (kind === "taken") {
    of(robot).pictures = message;
    if (here) drawSoon();
  } else if (kind === "scene") {
    of(robot).scene = message;
    if (here) drawings.forEach(drawing => drawing.redraw());
  } else if (kind === "stand") {
    const known = shownRobot && of(shownRobot);
    if (known && message.number === known.nextNumber) {
      known.next = message.hull ? message : null;
      if (parentShown) drawings[0].redraw();
    }
  } else if (kind === "update") {
    updated(robot, message.values, here);
    if (here) drawSoon();
  } else if (isShown && parentShown) {
    if (robot !== shownRobot && shownRobot && robots.has(shownRobot)) refreshBar(parentShown, again);
    else kind === "keys" ? draw() : again();
  }
}

function updated(robot, values, isShown) {
  for (const {key, value} of values) {
    const old = valueOf(robot, key);
    of(robot).values.set(key, value);
    if (key === healthKey) refreshVitals(robot);
    if (key === stateKey) {
      ended(robot, old, value, running);
      if (robot === shownRobot && old && running(old.phase)) restWhenDone();
      if (old && old.sentence !== value.sentence && !running(value.phase)) [offsetsMount, mountsMount].forEach(mount => act({do: "keys", robot, mount})); // what it has now
    }
    if (key === playerKey && value.held && !(old && old.held) && !isShown) notice(nameOf(robot) + ": " + (value.reason || "Hold it by its trunk: its eyes are yellow."));
  }
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

// Of every robot that calibrated: for the session's page.
const calibrated = () => [...robots.keys()].filter(robot => valueOf(robot, stateKey) && valueOf(robot, stateKey).phase !== "idle");
export const hasMatch = () => calibrated().length > 0;
export function matchSummary(parent) {
  for (const robot of calibrated()) {
    const state = valueOf(robot, stateKey), told = valueOf(robot, outcomeKey), {before, mountsBefore, scene} = of(robot), {keys} = robots.get(robot);
    parent.append(make("h1", {}, "Calibration of " + calledBy(robot)), ...progress(state, null), ...outcome(state, running(state.phase), told),
      ...offsets(told, beforeIn(told, offsetsMount, before), keys.get(offsetsMount)), ...cameraMounts(beforeIn(told, mountsMount, mountsBefore), keys.get(mountsMount)), standingFigure(() => ({now: scene, next: null}), "how the robot stands"), floorFigure(() => scene), ...thumbnails(robot));
  }
}
