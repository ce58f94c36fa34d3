// Battery level and temperature of each connected robot, beside its name.
import {element} from "naocal/lib/dom.js";
import {state, valueOf} from "../core/state.js";
import {want} from "../core/subscriptions.js";

const low = 0.2, hot = 70;

export function health(robot) {
  const part = element("span", {class: "vitals number", "data-robot": robot});
  fill(part, robot);
  return part;
}

export function refreshHealth(robot) {
  for (const part of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll(".vitals"))) if (part.dataset.robot === robot) fill(part, robot);
}

function fill(part, robot) {
  const told = state.robots.get(robot)?.connected && valueOf(robot, healthKey);
  if (!told) return;
  const percent = Math.round(100 * told.battery) + " %", heat = Math.round(told.temperature) + " °C";
  const words = percent + heat + told.charging;
  if (part.dataset.words === words) return;
  part.dataset.words = words;
  part.replaceChildren(
    element("span", {class: told.battery < low ? "bad" : "", title: told.charging ? "its battery is being charged" : "its battery"},
      (told.charging ? "⚡ " : "▮ ") + percent + (told.battery < low ? " low" : "")),
    element("span", {class: told.temperature > hot ? "bad" : "", title: "its hottest joint: " + told.joint}, heat + (told.temperature > hot ? " hot: " + told.joint : "")));
}

// Keys subscribed to for every robot, independent of the view: state, player, health.

export const stateKey = "Brain.calibration";
export const playerKey = "Motion.player";
export const healthKey = "Motion.health"; // {battery: 0..1, charging, joint: hottest joint, temperature [°C]}
/** Whether a calibration has come to its end. @param {string | undefined} phase */
export const over = phase => phase === "finished" || phase === "failed";
export const running = phase => phase !== "idle" && !over(phase);

export function followAll() {
  for (const [robot, {list, connected}] of state.robots) {
    want("all " + robot, connected ? robot : null, [healthKey, stateKey, playerKey].filter(name => list.some(({key}) => key === name)));
  }
}
