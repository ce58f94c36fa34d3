// Calibrate view: calibration kind, upcoming poses, progress, live pictures, outcome, undo.
import {button, element, empty, renew} from "naocal/lib/dom.js";
import {capitalized} from "naocal/lib/format.js";
import {on, send} from "../core/connection.js";
import {act, endNotice, notice, of, valueOf} from "../core/state.js";
import {want} from "../core/subscriptions.js";
import {cameraAt, cameraKeys} from "./camera.js";
import {capturesKey, capturesOf, thumbnails} from "./captures.js";
import {afterwards, ended, mountsMount, offsetsMount, runner, steer} from "./controls.js";
import {floorFigure} from "./floor.js";
import {healthKey, over, playerKey, refreshHealth, running, stateKey} from "./health.js";
import {cameraMounts, offsets, outcome, outcomeKey} from "./outcome.js";
import {displayName, entryOf, nameOf, needKeys, refreshBar, robotBar, robots, selectedRobot, whyNothing} from "./robots.js";
import {standingFigure} from "./stance.js";

const kindsKey = "Brain.calibrationKinds", posesKey = "Brain.calibrationPoses"; // {round, step, poses: [{name, angles}]}

let parentShown = null, shownRobot = null, cameras = [], parts = null, drawings = [];
let isOver = null; // whether the outcome is shown first

export function showCalibrate(parent) {
  const before = shownRobot;
  parentShown = parent;
  shownRobot = selectedRobot();
  if (before && before !== shownRobot) {
    send({do: "unwatch", robot: before});
    tellQuestion(before, false);
  }
  if (shownRobot) tellQuestion(shownRobot, true);
  const why = whyNothing();
  renew(parent, element("div", {class: "heading"}, element("h1", {}, "Calibrate"), robotBar(again)), ...(why ? [empty(...why)] : content()));
  if (why) want("match", null, []);
  else draw();
}

const again = () => showCalibrate(parentShown);

export function leaveCalibrate() {
  parentShown = null;
  if (shownRobot) tellQuestion(shownRobot, false);
  restWhenDone();
}

// Ends picture streaming after the calibration; until then captures get pictures whichever view is shown.
function restWhenDone() {
  if (parentShown || !shownRobot || running(valueOf(shownRobot, stateKey)?.phase ?? "idle")) return;
  send({do: "unwatch", robot: shownRobot});
  want("match", null, []);
}

function content() {
  const {list, mounts, connected} = entryOf(shownRobot), {chosen} = cameraKeys(list);
  const can = list.some(({key}) => key === stateKey) && mounts.some(({key}) => key === runner);
  cameras = chosen.map((key, i) => key && {key, camera: cameraAt(shownRobot + "\n" + key, (i ? "bottom" : "top") + " camera")}).filter(Boolean);
  want("match", shownRobot, [kindsKey, posesKey, capturesKey, outcomeKey, ...cameras.map(({key}) => key)].filter(key => list.some(one => one.key === key)));
  send({do: "watch", robot: shownRobot});
  if (!connected) cameras.filter(({camera}) => camera.times.length).forEach(({camera}) => { camera.caption.textContent = "last picture received"; });
  if (can) [offsetsMount, mountsMount].forEach(mount => needKeys(shownRobot, mount));
  const stance = standingFigure(() => ({now: of(shownRobot).scene, next: of(shownRobot).next}), "posture of the robot, and its next pose", 215);
  const floor = floorFigure(() => of(shownRobot).scene);
  drawings = [stance, floor];
  parts = Object.fromEntries(["steer", "progress", "after", "outcome", "offsets", "captures", "nextWords", "poses"].map(name => [name, element("div")]));
  const none = can ? [] : [empty("This robot does not calibrate itself", "It serves no " + stateKey + "; naocal-robot does. Its cameras and values can still be seen.",
    element("span", {class: "controls next-steps"}, button("See it live", () => { location.hash = "live"; }, {class: "main"})))];
  isOver = null;
  parts.left = element("div", {}, ...none, ...(can ? inOrder(false) : [parts.outcome, parts.after, parts.offsets]));
  return [element("div", {class: "split match"}, parts.left,
    element("div", {}, element("div", {class: "cameras beside"}, ...cameras.map(({camera}) => element("figure", {class: "camera"}, element("b", {}, camera.canvas.getAttribute("aria-label")), camera.canvas, camera.caption, camera.rests))),
      element("p", {class: "keys soft"}, element("span", {class: "key measured"}), " corner, ", element("span", {class: "key predicted"}), " where the current calibration predicts it"),
      element("div", {class: "cameras beside"}, element("div", {}, element("h2", {}, "Posture"), parts.nextWords, stance),
        element("div", {}, element("h2", {}, "The floor"), floor, element("p", {class: "keys soft"}, element("span", {class: "key topView"}), " view of the top camera, ",
          element("span", {class: "key bottomView"}), " of the bottom camera; ", element("span", {class: "key weight"}), " centre of mass; boards that a camera sees now"))))), parts.captures];
}

// Parts of the left column: after a run its outcome comes first, otherwise what to do.
const inOrder = hasEnded => [...(hasEnded ? ["progress", "outcome", "after", "offsets", "steer", "poses"] : ["steer", "progress", "poses", "outcome", "after", "offsets"])].map(name => parts[name]);

function putInOrder(state) {
  const hasEnded = over(state?.phase);
  if (hasEnded === isOver || !parts.left.contains(parts.steer)) return;
  if (hasEnded && isOver !== null) scrollTo(0, 0); // the run has just ended
  isOver = hasEnded;
  parts.left.append(...inOrder(hasEnded));
}

function draw() {
  if (!parentShown || !parts) return;
  const entry = entryOf(shownRobot), state = valueOf(shownRobot, stateKey), player = valueOf(shownRobot, playerKey);
  const told = valueOf(shownRobot, outcomeKey), isRunning = running(state ? state.phase : "idle");
  const {before, mountsBefore} = of(shownRobot), captures = capturesOf(shownRobot), now = entry.keys.get(offsetsMount), mounts = entry.keys.get(mountsMount);
  putInOrder(state);
  steer({robot: shownRobot, entry, state, player, isRunning, kinds: valueOf(shownRobot, kindsKey), draw, when});
  when("progress", [state, player && player.reason, player && player.held], () => state ? progress(state, player) : [element("p", {class: "soft"}, "Waiting for the robot's state …")]);
  const [offsetsBefore, cameraBefore] = [beforeIn(told, offsetsMount, before), beforeIn(told, mountsMount, mountsBefore)];
  when("outcome", [state && state.errorAfter, isRunning, told], () => outcome(state, isRunning, told));
  when("offsets", [told, offsetsBefore, now, cameraBefore, mounts], () => [...offsets(told, offsetsBefore, now), ...cameraMounts(cameraBefore, mounts)]);
  const round = valueOf(shownRobot, posesKey);
  when("poses", round && isRunning && [round.round, round.poses.map(({name}) => name)], () => round && isRunning ? upcomingPoses(round) : []);
  if (round) markStep(parts.poses, round.step);
  when("captures", captures, () => thumbnails(shownRobot));
  afterwards({robot: shownRobot, entry, state, isRunning, draw, when});
  next();
}

// Values before the calibration: from the robot if available, else as recorded by this page.
const beforeIn = (told, mount, seen) => told?.before?.[mount] ? Object.entries(told.before[mount]).map(([key, value]) => ({key, value})) : seen;

// Redraws a part only if its data change: replacing a button would lose the click in progress.
function when(name, shown, made) {
  const words = JSON.stringify(shown);
  if (parts[name].shown === words) return;
  parts[name].shown = words;
  parts[name].replaceChildren(...made());
}

// Requests forward kinematics of the next pose.
let asked = 0; // number of the last request
function next() {
  const state = valueOf(shownRobot, stateKey), told = valueOf(shownRobot, posesKey), known = of(shownRobot), pose = told && state && running(state.phase) && told.poses[told.step];
  const words = JSON.stringify(pose || null);
  if (known.nextShown !== words) {
    known.nextShown = words;
    known.next = null;
    if (pose) send({do: "stand", number: known.nextNumber = ++asked, angles: pose.angles});
  }
  when("nextWords", [pose && pose.name, told && told.step, told && told.poses.length], () => [element("p", {class: "soft"},
    pose ? element("span", {}, element("span", {class: "key outline"}), " " + pose.name + ", " + (told.step + 1) + " of " + told.poses.length + " of this round; grey: present posture")
      : "Grey: present posture.")]);
}

function progress(state, player) {
  const bar = element("progress", {max: "1", "aria-label": "progress of this round"});
  bar.value = state.poses ? state.pose / state.poses : running(state.phase) ? 0 : 1;
  return [element("h2", {}, capitalized(state.phase)),
    state.question ? "" : element("p", {class: state.phase === "failed" ? "bad" : "", role: "status"}, state.sentence || "Ready."),
    state.phase === "idle" ? "" : element("div", {class: "progress"}, bar, element("span", {class: "number"}, state.poses ? "pose " + state.pose + " of " + state.poses : ""),
      element("span", {class: "number"}, state.captures + " pictures"), element("span", {class: "number"}, state.secondsLeft === null ? "" : "about " + Math.ceil(state.secondsLeft) + " s left")),
    player && player.reason && !player.held && !(state.sentence || "").includes(player.reason) ? element("p", {class: "bad"}, player.reason) : ""];
}

export function onMessage(message, file, isShown) {
  const {kind, robot} = message, here = isShown && parentShown && robot === shownRobot;
  if (kind === "robotGone") ["hold ", "question "].forEach(cause => endNotice(cause + robot));
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
    if (key === healthKey) refreshHealth(robot);
    if (key === stateKey) {
      ended(robot, old, value, running);
      if (robot === shownRobot && old && running(old.phase)) restWhenDone();
      if (old && old.sentence !== value.sentence && !running(value.phase)) readBack(robot);
      tellQuestion(robot, isShown);
    }
    if (key === outcomeKey && JSON.stringify(old) !== JSON.stringify(value)) readBack(robot);
    if (key === playerKey && value.held && !(old && old.held) && !isShown) notice(nameOf(robot) + ": " + (value.reason || "Hold it by its trunk: its eyes are yellow."), "hold " + robot);
    if (key === playerKey && !value.held) endNotice("hold " + robot);
  }
}

// Reads the values back that the robot has now.
const readBack = robot => [offsetsMount, mountsMount].forEach(mount => act({do: "keys", robot, mount}));

// A robot waits for its answer without limit, so other views tell of its question.
function tellQuestion(robot, isShown) {
  const question = valueOf(robot, stateKey)?.question;
  if (question && !isShown) notice(nameOf(robot) + " waits in Calibrate: " + question, "question " + robot);
  else endNotice("question " + robot);
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

// For the session export: all robots that have calibrated.
const calibrated = () => [...robots.keys()].filter(robot => valueOf(robot, stateKey) && valueOf(robot, stateKey).phase !== "idle");
export const hasCalibration = () => calibrated().length > 0;
export function calibrationSummary(parent) {
  for (const robot of calibrated()) {
    const state = valueOf(robot, stateKey), told = valueOf(robot, outcomeKey), {before, mountsBefore, scene} = of(robot), {keys} = entryOf(robot);
    parent.append(element("h1", {}, "Calibration of " + displayName(robot)), ...progress(state, null), ...outcome(state, running(state.phase), told),
      ...offsets(told, beforeIn(told, offsetsMount, before), keys.get(offsetsMount)), ...cameraMounts(beforeIn(told, mountsMount, mountsBefore), keys.get(mountsMount)), standingFigure(() => ({now: scene, next: null}), "posture of the robot"), floorFigure(() => scene), ...thumbnails(robot));
  }
}

// Upcoming poses of a round.

const waiting = new Map(); // by request number

on("stand", message => {
  const pose = waiting.get(message.number);
  if (!pose) return;
  waiting.delete(message.number);
  pose.stand = message.hull ? message : null;
  pose.drawn.redraw();
});

// Consecutive poses of equal name are one pose approached from several sides.
function upcomingPoses({round, poses}) {
  waiting.clear();
  const groups = [];
  poses.forEach(({name, angles}, i) => {
    if (groups.length && groups.at(-1).name === name) groups.at(-1).count += 1;
    else groups.push({name, angles, first: i, count: 1, stand: null});
  });
  if (!groups.length) return [];
  return [element("h2", {}, round ? "Poses of the second round (validation)" : "Poses of the first round"),
    element("ol", {class: "thumbnails poses", "aria-label": "poses in playing order"}, ...groups.map(pose => {
      pose.drawn = standingFigure(() => ({now: null, next: pose.stand}), "pose " + pose.name, 120);
      waiting.set(++asked, pose);
      send({do: "stand", number: asked, angles: pose.angles});
      return element("li", {"data-first": String(pose.first), "data-count": String(pose.count)}, pose.drawn, element("b", {}, pose.name), element("span", {class: "soft"}));
    }))];
}

function markStep(part, step) {
  for (const item of part.querySelectorAll("li")) {
    const first = Number(item.dataset.first), count = Number(item.dataset.count);
    const state = step >= first + count ? "taken" : step >= first ? "now" : "to-come", words = state.replace("-", " ") + (count > 1 ? ", from " + count + " sides" : "");
    if (item.className === state) continue;
    item.className = state;
    item.lastChild.textContent = words;
  }
}
