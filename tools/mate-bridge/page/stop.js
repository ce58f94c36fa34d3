// Stop: one button in the header of every view while a robot can be reached that may move. It acts when it is pressed,
// not when it is let go, and so does the key s.
import {robots, nameOf} from "./robots.js";
import {valueOf} from "./values.js";
import {set, runner} from "./steer.js";
import {stateKey, running} from "./follow.js";

const stop = document.getElementById("stop");

const reached = () => [...robots].filter(([, {connected, list}]) => connected && list.some(({key}) => key === stateKey)).map(([robot]) => robot);
const moving = () => reached().filter(robot => running(valueOf(robot, stateKey)?.phase ?? "idle"));

export function refreshStop() {
  const now = moving();
  stop.hidden = !reached().length;
  stop.classList.toggle("moving", now.length > 0);
  stop.title = "key s: " + (now.length ? now.map(nameOf).join(", ") + " ends the calibration" : "ends whatever a calibration does") + " and goes back to its stand";
}

// Whatever runs ends: a value that differs from the one before, then none.
const press = () => reached().forEach(robot => set(robot, runner, "run", ""));

stop.addEventListener("pointerdown", press);
stop.addEventListener("click", ({detail}) => { if (detail === 0) press(); }); // of a keyboard
document.addEventListener("keydown", event => {
  const typing = /^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName) && event.target.type !== "radio" && event.target.type !== "checkbox";
  if (event.key.toLowerCase() === "s" && !event.ctrlKey && !event.metaKey && !event.altKey && !typing && !stop.hidden) press();
});
