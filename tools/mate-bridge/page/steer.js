// What a person tells the robot: start one of its calibrations, answer what it asks, stop, take back, save, export.
import {make, button} from "./elements.js";
import {act, notice} from "./state.js";
import {of} from "./values.js";
import {saveSession} from "./session.js";

export const runner = "Brain.CalibrationRunner", offsetsMount = "Motion.JointCalibrationProvider", mountsMount = "Brain.Projection";
let chosen = null, confirming = null; // the kind of calibration; what waits for the person's yes

const set = (robot, mp, key, value) => act({do: "set", robot, settings: [{mp, key, value}]});

export function steer({robot, entry, state, isRunning, kinds, draw, when}) {
  const {connected, sentence} = entry, question = state && state.question;
  if (kinds && kinds.length && !kinds.some(({run}) => run === chosen)) chosen = kinds[0].run;
  when("steer", [connected, isRunning, confirming, sentence, kinds, chosen, question, state && state.kind], () => [
    isRunning ? make("p", {}, make("b", {}, titleOf(kinds, state.kind)), " is under way.") : choice(kinds, isRunning, draw),
    question ? ask(robot, state) : "",
    make("p", {class: "controls big"},
      button("Calibrate …", () => { confirming = "start"; draw(); }, {class: "main", disabled: !connected || isRunning || !chosen || confirming === "start"}),
      button("Stop", () => stop(robot, draw), {class: "stop", disabled: !connected, title: "key s: the robot goes back to its stand"})),
    confirming === "start" ? confirm("The robot will move: " + titleOf(kinds, chosen) + ". Is everybody's hand off it?", "Start", () => start(robot, entry), draw) : "",
    connected ? "" : make("p", {class: "bad"}, robot + " " + sentence + ". It is tried again every second; a robot that was started from here ends what it does and goes to its stand, one that loses power holds nothing.")]);
}

const titleOf = (kinds, run) => (kinds || []).find(one => one.run === run)?.title || run || "";

function choice(kinds, isRunning, draw) {
  if (!kinds) return make("p", {class: "soft"}, "Asking the robot what it can calibrate …");
  return make("fieldset", {class: "kinds"}, make("legend", {}, "What to calibrate"), ...kinds.map(({run, title, sentence}) => {
    const dot = make("input", {type: "radio", name: "kind", value: run, onchange: () => { chosen = run; confirming = null; draw(); }});
    dot.checked = run === chosen;
    return make("label", {class: run === chosen ? "is-looked" : ""}, dot, make("span", {}, make("b", {}, title), make("span", {class: "soft"}, sentence)));
  }));
}

// What the robot waits for.
const ask = (robot, {question, questionNumber}) => make("div", {class: "confirm asks", role: "alert"}, make("p", {}, make("b", {}, "The robot asks: "), question),
  make("p", {class: "controls"}, button("Confirm", () => set(robot, runner, "confirmed", questionNumber), {class: "main"})));

function confirm(question, yes, action, draw) {
  return make("div", {class: "confirm", role: "group", "aria-label": "confirm"}, make("p", {}, question), make("p", {class: "controls"},
    button(yes, () => { confirming = null; action(); draw(); }, {class: "main"}), button("Not now", () => { confirming = null; draw(); })));
}

// Has a robot begin, and end what it does when it loses its panel: no stop would reach it.
export function begin(robot, run) {
  set(robot, runner, "run", ""); // only a change counts
  set(robot, "naocal.configuration", "lastWill", [{mp: runner, key: "run", value: ""}]);
  set(robot, runner, "run", run);
}

function start(robot, entry) {
  of(robot).before = entry.keys.get(offsetsMount);
  begin(robot, chosen);
}

// Whatever runs ends: a value that differs from the one before, then none.
export function stop(robot, draw) {
  confirming = null;
  set(robot, runner, "run", "");
  draw();
}

export function afterwards({robot, entry, state, isRunning, draw, when}) {
  const can = entry.connected && state && !isRunning;
  when("after", [can, confirming, state && state.phase], () => [
    make("p", {class: "controls"},
      button("Undo …", () => { confirming = "undo"; draw(); }, {disabled: !can, title: "takes back what the last calibration saved"}),
      button("Save …", () => { confirming = "save"; draw(); }, {disabled: !can, title: "writes what was set by hand into the robot's files"}),
      button("Export", saveSession, {title: "all that is shown, as one HTML file"})),
    confirming === "undo" ? confirm("Take back what the last calibration saved, offsets and cameras?", "Undo on " + robot, () => {
      set(robot, runner, "run", "");
      set(robot, runner, "run", "undo");
    }, draw) : "",
    confirming === "save" ? confirm("Write everything that was set on " + robot + " into its own configuration files? (What a calibration found is saved already.)", "Save on " + robot, () => {
      act({do: "save", robot});
      notice("Asked " + robot + " to save. (HULKs' protocol has no answer to this.)");
    }, draw) : ""]);
}
