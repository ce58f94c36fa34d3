// Next: poses that would best tell what these captures leave open, seen, and played on a robot.
import {make, button, empty, choice, confirmation, renew} from "./elements.js";
import {send, on} from "./connection.js";
import {state, act, say} from "./state.js";
import {standingFigure} from "./standing.js";
import {robots, lookedAt, needKeys, nameOf} from "./robots.js";
import {runner, begin} from "./steer.js";
import {valueOf} from "./values.js";
import {stateKey, running} from "./follow.js";
import {make as ask} from "./files.js";

let count = 4, shown = null, confirming = null, asked = 1e6;
const stands = new Map(); // by number asked for

on("stand", message => {
  const waiting = stands.get(message.number);
  if (!waiting) return;
  Object.assign(waiting, {hull: message.hull, gaze: message.gaze});
  waiting.drawn?.redraw();
});

export function showNext(parent) {
  const {next} = state, again = () => showNext(parent);
  const wanted = choice("How many", [1, 2, 4, 6, 8].map(value => ({value: String(value), text: String(value)})), String(count), value => { count = Number(value); }, "howMany");
  const head = [make("h1", {}, "What to measure next"), make("p", {class: "soft"}, "Stable poses in sight of the boards, chosen so that what this model leaves open would differ most in them."),
    make("p", {class: "controls"}, wanted, button("Suggest poses", () => act({do: "propose", count}), {class: "main", disabled: Boolean(state.work)}))];
  if (!next) renew(parent, ...head, empty("No poses were asked for yet", "This takes some seconds."));
  else if (!next.poses.length) renew(parent, ...head, empty("There are none to suggest", next.whyNone || "Nothing is open: these captures answer what can be asked."));
  else renew(parent, ...head, make("p", {}, "Why these: taking pictures in them ", make("b", {}, next.why), "."), ...playing(next, again),
    make("div", {class: "grid"}, ...next.poses.map(pose => poseFigure(pose, next))));
}

function poseFigure(pose, next) {
  if (shown !== next) { stands.clear(); shown = next; }
  let known = [...stands.values()].find(one => one.pose === pose);
  if (!known) {
    known = {pose, number: ++asked, hull: null};
    stands.set(known.number, known);
    send({do: "stand", number: known.number, angles: pose.joints});
  }
  known.drawn = standingFigure(() => ({now: null, next: known.hull ? known : null}), "pose " + pose.id);
  return make("figure", {}, known.drawn, make("figcaption", {}, make("b", {}, pose.id), " on the " + pose.supportFoot + " foot, sees " + (pose.observes.length ? (pose.observes.length > 1 ? "boards " : "board ") + pose.observes.join(", ") : "no board") +
    (pose.secondsToReach ? ", reached in " + pose.secondsToReach.toFixed(1) + " s" : "")));
}

// Its calibration would end for these poses.
const calibrates = robot => running(valueOf(robot, stateKey)?.phase ?? "idle");
const playOn = (robot, words, action) => button(words, action, {class: "main", "data-plays": robot, disabled: calibrates(robot),
  title: "once " + nameOf(robot) + " does not calibrate"});

export function refreshPlay() {
  for (const play of document.querySelectorAll("[data-plays]")) play.disabled = calibrates(play.dataset.plays);
}

// A robot that takes poses by its socket plays them and records what it sees.
function playing(next, again) {
  const robot = lookedAt(), entry = robot && robots.get(robot);
  if (entry && entry.mounts.some(({key}) => key === runner)) needKeys(robot, runner);
  const can = entry && entry.connected && (entry.keys.get(runner) || []).some(({key}) => key === "poses"); // not every robot takes them
  const save = button("Save poses.json", () => ask("poses.json"));
  if (!can) return [make("p", {class: "controls"}, save, make("span", {class: "soft"}, "A robot that takes poses by its socket plays them: connect to one in Calibrate. Or take the file to it."))];
  if (confirming !== robot) return [make("p", {class: "controls"}, playOn(robot, "Play on " + nameOf(robot) + " …", () => { confirming = robot; again(); }), save)];
  return [confirmation(
    nameOf(robot) + " will take these " + next.poses.length + " poses on one foot before its boards, and record what it sees. They are safe for joint offsets that are known to " + Math.round(180 / Math.PI * 10 * next.assumptions.jointError) / 10 + "°: calibrate its legs first. Is everybody's hand ready to catch it?",
    playOn(robot, "Play", () => {
      confirming = null;
      const poses = {format: "naocal-poses", version: 1, robot: state.set.robot, poses: next.poses, assumptions: next.assumptions};
      if (!act({do: "set", robot, settings: [{mp: runner, key: "poses", value: poses}]}) || !begin(robot, "poses")) return again();
      say("Asked " + nameOf(robot) + " to take these poses: Calibrate shows how it fares.");
      location.hash = "match";
    }), null, () => { confirming = null; again(); })];
}
