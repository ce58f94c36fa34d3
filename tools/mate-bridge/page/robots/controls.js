// Controls of a calibration: start, confirm, undo, save, export, stop.
import {at, button, confirmation, element, question as dialog} from "naocal/lib/dom.js";
import {saveSession} from "../core/session-export.js";
import {act, of, say, valueOf} from "../core/state.js";
import {newestRun, openRun} from "../history/history.js";
import {over, running, stateKey} from "./health.js";
import {displayName, headName, nameOf, robots} from "./robots.js";

export const runner = "Brain.CalibrationRunner";
export const offsetsMount = "Motion.JointCalibrationProvider";
export const mountsMount = "Brain.Projection";
let confirming = null; // the action that awaits confirmation, {what, robot}

export const set = (robot, mp, key, value) => act({do: "set", robot, settings: [{mp, key, value}]});
const waits = (what, robot) => Boolean(confirming) && confirming.what === what && confirming.robot === robot;

export function steer({robot, entry, state, player, isRunning, kinds, draw, when}) {
  const {connected, sentence} = entry, question = state && state.question, known = of(robot);
  const asks = what => () => { confirming = what && {what, robot}; draw(); };
  if (kinds && kinds.length && !kinds.some(({run}) => run === known.chosen)) known.chosen = kinds[0].run;
  const {chosen} = known, held = player && player.held && !question && (player.reason || "Hold the robot by its trunk: its eyes are yellow.");
  when("steer", [robot, connected, isRunning, confirming, sentence, kinds, chosen, question, state && state.questionNumber, held, state && state.kind], () => [
    held ? element("div", {class: "confirm asks", role: "alert"}, element("p", {class: "hold"}, element("span", {class: "eyes"}), held)) : "",
    isRunning ? element("p", {}, element("b", {}, titleOf(kinds, state.kind)), " is under way. Stop is at the top, or the key s.")
      : choice(kinds, known, connected, asks(null)),
    question ? ask(robot, state) : "",
    isRunning || waits("start", robot) ? ""
      : element("p", {class: "controls big"}, button("Calibrate …", asks("start"), {class: "main", disabled: !connected || !chosen})),
    waits("start", robot) && !isRunning ? confirmation(["Calibrate " + displayName(robot) + ": " + titleOf(kinds, chosen) + "?", ...whatHappens(chosen)], "Start", () => {
      confirming = null;
      start(robot, entry);
      draw();
    }, asks(null)) : "",
    connected ? "" : element("p", {class: "bad"}, nameOf(robot) + " " + sentence + ". The panel retries every second. A calibration started from here ends, and the robot goes to its stand; " +
      "a robot without power cannot hold itself.")]);
}

const others = {poses: "Playing the requested poses", undo: "Restoring the old values"};
const titleOf = (kinds, run) => (kinds || []).find(one => one.run === run)?.title || others[run] || run || "";

const whatHappens = run => [
  /leg/.test(run) ? "It will stand on one foot and may fall: stay beside it, hold it by its trunk whenever it asks or its eyes are yellow, " +
    "and be ready to catch it." : "It stands on both feet and turns its head. Hands off? Nobody may touch the robot.",
  "If a second round of pictures confirms an improvement, the robot saves its joint offsets and camera mounts (Undo restores the old " +
    "ones); otherwise it keeps its present values."];

function choice(kinds, known, connected, changed) {
  if (!kinds) return connected ? element("p", {class: "soft"}, "Waiting for the list of calibrations …") : "";
  return element("fieldset", {class: "kinds"}, element("legend", {}, "What to calibrate"), ...kinds.map(({run, title, sentence}) => {
    const dot = element("input", {type: "radio", name: "kind", value: run, onchange: () => { known.chosen = run; changed(); }});
    dot.checked = run === known.chosen;
    return element("label", {class: dot.checked ? "is-looked" : ""}, dot, element("span", {}, element("b", {}, title), element("span", {class: "soft"}, sentence)));
  }));
}

// Shows the robot's question with a Confirm button. The text takes the focus: a key that is just being pressed must not confirm.
const ask = (robot, {question, questionNumber}) => dialog({class: "confirm asks", role: "alertdialog", "aria-label": "question of the robot"}, null,
  element("p", {tabindex: "-1", autofocus: true}, element("b", {}, "The robot asks: "), question),
  element("p", {class: "controls"}, button("Confirm", () => set(robot, runner, "confirmed", questionNumber), {class: "main"}),
    element("span", {class: "soft"}, "or press its chest button")));

// Starts a run, with a last will that ends it if the connection is lost. Returns false if nothing was sent.
export function begin(robot, run) {
  of(robot).begun = {sentence: of(robot).values.get("Brain.calibration")?.sentence};
  return set(robot, runner, "run", "") // resets the key first: the robot reacts to changes only
    && set(robot, "naocal.configuration", "lastWill", [{mp: runner, key: "run", value: ""}]) && set(robot, runner, "run", run);
}

// Clears the last will after the run has ended or was refused.
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

// Undo works once per saved calibration; the robot's sentence says if it was used.
const canUndo = ({sentence}) => !/saved was taken back/.test(sentence);

export function afterwards({robot, entry, state, isRunning, draw, when}) {
  const can = entry.connected && Boolean(state) && !isRunning, undoable = can && canUndo(state);
  const asks = what => () => { confirming = what && {what, robot}; draw(); };
  const run = isRunning ? undefined : newestRun(headName(robot)), isOver = over(state?.phase);
  when("after", [robot, can, undoable, confirming, run?.id, isOver], () => [
    element("p", {class: "controls"},
      run ? button("Open its captures", () => openRun(run.id), {class: isOver ? "main" : "", title: "opens the captures of this robot's last calibration: where the prediction fails, what is missing, its result"}) : null,
      button("Undo …", asks("undo"), {disabled: !undoable, title: "restores the values from before the last calibration"}),
      button("Save …", asks("save"), {disabled: !can, title: "writes values set by hand to the robot's files"}),
      button("Save as page", saveSession, {title: "everything that this panel shows, as one HTML file"})),
    waits("undo", robot) && undoable ? confirmation("Take back what the last calibration saved on " + nameOf(robot) + ", offsets and cameras?", "Undo on " + nameOf(robot), () => {
      confirming = null;
      if (set(robot, runner, "run", "")) set(robot, runner, "run", "undo");
      draw();
    }, asks(null)) : "",
    waits("save", robot) && can ? savingOn(robot, ["Results of a calibration are saved already."], asks(null)) : ""]);
}

// Saving on a robot, after a confirmation; HULKs' protocol sends no reply.

// `more`: further text; `leave`: closes the confirmation; `asked`: called after the request.
export const savingOn = (robot, more, leave, asked = () => {}) =>
  confirmation(["Write all values set on " + nameOf(robot) + " to its configuration files?", ...more], "Save on " + nameOf(robot), () => {
    if (act({do: "save", robot})) {
      asked();
      say("Asked " + nameOf(robot) + " to save. (HULKs' protocol does not confirm this.)");
    }
    leave();
  }, leave);

// Stop button in the header, shown while a connected robot may move. Acts on press, not on release, as does the key s.

const stop = at("stop");

const reached = () => [...robots].filter(([, {connected, list}]) => connected && list.some(({key}) => key === stateKey)).map(([robot]) => robot);
const moving = () => reached().filter(robot => running(valueOf(robot, stateKey)?.phase ?? "idle"));

export function refreshStop() {
  const now = moving();
  stop.hidden = !reached().length;
  stop.classList.toggle("moving", now.length > 0);
  stop.title = "key s: " + (now.length ? now.map(nameOf).join(", ") + " ends the calibration" : "ends whatever a calibration does") + " and goes back to its stand";
}

// Ends the run on every robot that can be reached.
const press = () => reached().forEach(robot => set(robot, runner, "run", ""));

stop.addEventListener("pointerdown", press);
stop.addEventListener("click", ({detail}) => { if (detail === 0) press(); }); // activated by keyboard
document.addEventListener("keydown", event => {
  const {tagName, type} = /** @type {HTMLInputElement} */ (event.target);
  const typing = /^(INPUT|SELECT|TEXTAREA)$/.test(tagName) && type !== "radio" && type !== "checkbox";
  if (event.key.toLowerCase() === "s" && !event.ctrlKey && !event.metaKey && !event.altKey && !typing && !stop.hidden) press();
});
