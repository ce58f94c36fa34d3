// Next poses view: suggested poses are drawn, saved or played on a robot.
import {button, choice, confirmation, csvTable, element, empty, renew} from "naocal/lib/dom.js";
import {sized} from "naocal/lib/format.js";
import {on, send} from "../core/connection.js";
import {act, say, state, valueOf} from "../core/state.js";
import {begin, runner} from "../robots/controls.js";
import {running, stateKey} from "../robots/health.js";
import {selectedRobot, nameOf, needKeys, robots} from "../robots/robots.js";
import {standingFigure} from "../robots/stance.js";
import {requestFile} from "./files.js";

let count = 4, shown = null, confirming = null, asked = 1e6;
const stands = new Map(); // by request number

on("stand", message => {
  const waiting = stands.get(message.number);
  if (!waiting) return;
  Object.assign(waiting, {hull: message.hull, gaze: message.gaze});
  waiting.drawn?.redraw();
});

export function showNext(parent) {
  const {next} = state, again = () => showNext(parent);
  const wanted = choice("How many", [1, 2, 4, 6, 8].map(value => ({value: String(value), text: String(value)})), String(count), value => { count = Number(value); }, "howMany");
  const suggest = () => button("Suggest poses", () => act({do: "propose", count}), {class: "main", disabled: Boolean(state.work)});
  const head = [element("h1", {}, "What to measure next"), element("p", {class: "soft"}, (state.set.isNao ? "Stable poses in sight of the boards" : "Poses in which the robot is measured as before") + ", chosen to answer best what this model leaves open."),
    element("p", {class: "controls"}, wanted, next ? suggest() : null)];
  if (!next) renew(parent, ...head, empty("No poses suggested yet", "They are compared by what they would tell, which takes some seconds.", element("span", {class: "controls next-steps"}, suggest())));
  else if (!next.poses.length) renew(parent, ...head, empty("There are none to suggest", next.whyNone || "These captures leave no question open."));
  else renew(parent, ...head, element("p", {}, "Why these: measuring in them ", element("b", {}, next.why), ". " + next.whatTheyTell), ...playing(next, again),
    element("div", {class: "grid"}, ...next.poses.map(pose => poseFigure(pose, next))));
}

const poseFigure = (pose, next) => state.set.isNao ? drawnPose(pose, next) : listedPose(pose);

/** A pose of a robot that the panel cannot draw. */
const listedPose = ({id, supportFoot, observes, angles}) => element("figure", {}, element("figcaption", {}, element("b", {}, id), supportFoot === "none" ? "" : " on the " + supportFoot + " foot", ", measures " + observes.join(", ")),
  csvTable(element("table", {class: "narrow"}, element("thead", {}, element("tr", {}, element("th", {scope: "col"}, "joint"), element("th", {scope: "col", class: "number"}, "angle"))),
    element("tbody", {}, ...angles.map(({joint, value, unit}) => element("tr", {}, element("td", {}, element("code", {}, joint)), element("td", {class: "number"}, sized(value, unit)))))), "pose-" + id));

function drawnPose(pose, next) {
  if (shown !== next) { stands.clear(); shown = next; }
  let known = [...stands.values()].find(one => one.pose === pose);
  if (!known) {
    known = {pose, number: ++asked, hull: null};
    stands.set(known.number, known);
    send({do: "stand", number: known.number, angles: pose.joints});
  }
  known.drawn = standingFigure(() => ({now: null, next: known.hull ? known : null}), "pose " + pose.id);
  return element("figure", {}, known.drawn, element("figcaption", {}, element("b", {}, pose.id), " on the " + pose.supportFoot + " foot, sees " + (pose.observes.length ? (pose.observes.length > 1 ? "boards " : "board ") + pose.observes.join(", ") : "no board") +
    (pose.secondsToReach ? ", reached in " + pose.secondsToReach.toFixed(1) + " s" : "")));
}

// Playing is disabled during a calibration, which it would end.
const calibrates = robot => running(valueOf(robot, stateKey)?.phase ?? "idle");
const playOn = (robot, words, action) => button(words, action, {class: "main", "data-plays": robot, disabled: calibrates(robot),
  title: "not while " + nameOf(robot) + " calibrates"});

export function refreshPlay() {
  for (const play of /** @type {NodeListOf<HTMLButtonElement>} */ (document.querySelectorAll("[data-plays]"))) play.disabled = calibrates(play.dataset.plays);
}

// A connected robot plays the poses and records captures.
function playing(next, again) {
  const robot = selectedRobot(), entry = robot && robots.get(robot);
  if (entry && entry.mounts.some(({key}) => key === runner)) needKeys(robot, runner);
  const can = entry && entry.connected && (entry.keys.get(runner) || []).some(({key}) => key === "poses"); // optional key of the runner
  const save = button("Save poses.json", () => requestFile("poses.json"));
  if (!state.set.isNao) return [element("p", {class: "controls"}, save, element("span", {class: "soft"}, next.howToTake + "."))];
  if (!can) return [element("p", {class: "controls"}, save, element("span", {class: "soft"}, "Connect a robot in Calibrate to play these poses, or copy the file to it."))];
  if (confirming !== robot) return [element("p", {class: "controls"}, playOn(robot, "Play on " + nameOf(robot) + " …", () => { confirming = robot; again(); }), save)];
  return [confirmation(
    nameOf(robot) + " will take these " + next.poses.length + " poses on one foot in front of its boards, and record what it sees. They are safe where joint offsets are known to " + Math.round(180 / Math.PI * 10 * next.assumptions.jointError) / 10 + "°: calibrate its legs first. Stay beside it, ready to catch it.",
    playOn(robot, "Play", () => {
      confirming = null;
      const poses = {format: "naocal-poses", version: 1, robot: state.set.robot, poses: next.poses, assumptions: next.assumptions};
      if (!act({do: "set", robot, settings: [{mp: runner, key: "poses", value: poses}]}) || !begin(robot, "poses")) return again();
      say("Asked " + nameOf(robot) + " to take these poses: Calibrate shows its progress.");
      location.hash = "match";
    }), null, () => { confirming = null; again(); })];
}
