// What a person tells the robot: start one of its calibrations, answer what it asks, take back, save, export.
import {make, button, confirmation} from "./elements.js";
import {act} from "./state.js";
import {of} from "./values.js";
import {calledBy, nameOf} from "./robots.js";
import {savingOn} from "./save.js";
import {saveSession} from "./session.js";

export const runner = "Brain.CalibrationRunner", offsetsMount = "Motion.JointCalibrationProvider", mountsMount = "Brain.Projection";
let confirming = null; // what waits for the person's yes, and of which robot: {what, robot}

export const set = (robot, mp, key, value) => act({do: "set", robot, settings: [{mp, key, value}]});
const waits = (what, robot) => Boolean(confirming) && confirming.what === what && confirming.robot === robot;

export function steer({robot, entry, state, player, isRunning, kinds, draw, when}) {
  const {connected, sentence} = entry, question = state && state.question, known = of(robot);
  const asks = what => () => { confirming = what && {what, robot}; draw(); };
  if (kinds && kinds.length && !kinds.some(({run}) => run === known.chosen)) known.chosen = kinds[0].run;
  const {chosen} = known, held = player && player.held && !question && (player.reason || "Hold the robot by its trunk: its eyes are yellow.");
  when("steer", [robot, connected, isRunning, confirming, sentence, kinds, chosen, question, held, state && state.kind], () => [
    held ? make("div", {class: "confirm asks", role: "alert"}, make("p", {class: "hold"}, make("span", {class: "eyes"}), held)) : "",
    isRunning ? make("p", {}, make("b", {}, titleOf(kinds, state.kind)), " is under way. Stop is at the top, or the key s.")
      : choice(kinds, known, connected, asks(null)),
    question ? ask(robot, state) : "",
    isRunning || waits("start", robot) ? ""
      : make("p", {class: "controls big"}, button("Calibrate …", asks("start"), {class: "main", disabled: !connected || !chosen})),
    waits("start", robot) && !isRunning ? confirmation(["Calibrate " + calledBy(robot) + ": " + titleOf(kinds, chosen) + "?", ...whatHappens(chosen)], "Start", () => {
      confirming = null;
      start(robot, entry);
      draw();
    }, asks(null)) : "",
    connected ? "" : make("p", {class: "bad"}, nameOf(robot) + " " + sentence + ". It is tried again every second; a robot that was started " +
      "from here ends what it does and goes to its stand, one that loses power holds nothing.")]);
}

const others = {poses: "Playing the poses that were asked for", undo: "Taking back what was saved"};
const titleOf = (kinds, run) => (kinds || []).find(one => one.run === run)?.title || others[run] || run || "";

const whatHappens = run => [
  /leg/.test(run) ? "It will stand on one foot and may fall: somebody must stay beside it, hold it by its trunk whenever it asks or its " +
    "eyes are yellow, and be ready to catch it." : "It stands on both feet and turns its head. Is everybody's hand off it?",
  "If a second round of pictures shows that it is better, its joint offsets and camera mounts are saved on it (Undo takes that back); " +
    "else it keeps what it has."];

function choice(kinds, known, connected, changed) {
  if (!kinds) return connected ? make("p", {class: "soft"}, "Asking the robot what it can calibrate …") : "";
  return make("fieldset", {class: "kinds"}, make("legend", {}, "What to calibrate"), ...kinds.map(({run, title, sentence}) => {
    const dot = make("input", {type: "radio", name: "kind", value: run, onchange: () => { known.chosen = run; changed(); }});
    dot.checked = run === known.chosen;
    return make("label", {class: dot.checked ? "is-looked" : ""}, dot, make("span", {}, make("b", {}, title), make("span", {class: "soft"}, sentence)));
  }));
}

// What the robot waits for.
const ask = (robot, {question, questionNumber}) => make("div", {class: "confirm asks", role: "alert"},
  make("p", {}, make("b", {}, "The robot asks: "), question),
  make("p", {class: "controls"}, button("Confirm", () => set(robot, runner, "confirmed", questionNumber), {class: "main"}),
    make("span", {class: "soft"}, "or press its chest button")));

// Has a robot begin, and end what it does when it loses its panel: no stop would reach it. False: nothing was sent.
export function begin(robot, run) {
  of(robot).begun = {sentence: of(robot).values.get("Brain.calibration")?.sentence};
  return set(robot, runner, "run", "") // only a change counts
    && set(robot, "naocal.configuration", "lastWill", [{mp: runner, key: "run", value: ""}]) && set(robot, runner, "run", run);
}

// The last will ends with what it was made for: once that has run, or was refused.
export function ended(robot, old, now, running) {
  const {begun} = of(robot);
  if (running(now.phase) || !((old && running(old.phase)) || (begun && now.sentence !== begun.sentence))) return;
  of(robot).begun = null;
  set(robot, "naocal.configuration", "lastWill", []);
}

function start(robot, entry) {
  of(robot).before = entry.keys.get(offsetsMount);
  of(robot).mountsBefore = entry.keys.get(mountsMount);
  begin(robot, of(robot).chosen);
}

// What a calibration saved can be taken back once, however many were ended since: the robot knows whether there is any.
const canUndo = ({sentence}) => !/saved was taken back/.test(sentence);

export function afterwards({robot, entry, state, isRunning, draw, when}) {
  const can = entry.connected && Boolean(state) && !isRunning, undoable = can && canUndo(state);
  const asks = what => () => { confirming = what && {what, robot}; draw(); };
  when("after", [robot, can, undoable, confirming], () => [
    make("p", {class: "controls"},
      button("Undo …", asks("undo"), {disabled: !undoable, title: "takes back what the last calibration saved"}),
      button("Save …", asks("save"), {disabled: !can, title: "writes what was set by hand into the robot's files"}),
      button("Export", saveSession, {title: "all that is shown, as one HTML file"})),
    waits("undo", robot) && undoable ? confirmation("Take back what the last calibration saved on " + nameOf(robot) + ", offsets and cameras?", "Undo on " + nameOf(robot), () => {
      confirming = null;
      if (set(robot, runner, "run", "")) set(robot, runner, "run", "undo");
      draw();
    }, asks(null)) : "",
    waits("save", robot) && can ? savingOn(robot, ["What a calibration found is saved already."], asks(null)) : ""]);
}
