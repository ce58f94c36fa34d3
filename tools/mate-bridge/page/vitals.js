// Battery and temperature of every connected robot, in words that fit beside its name.
import {make} from "./elements.js";
import {state} from "./state.js";
import {valueOf} from "./values.js";
import {healthKey} from "./follow.js";

const low = 0.2, hot = 70;

export function vitals(robot) {
  const part = make("span", {class: "vitals number", "data-robot": robot});
  fill(part, robot);
  return part;
}

export function refreshVitals(robot) {
  for (const part of document.querySelectorAll(".vitals")) if (part.dataset.robot === robot) fill(part, robot);
}

function fill(part, robot) {
  const health = state.robots.get(robot)?.connected && valueOf(robot, healthKey);
  if (!health) return;
  const percent = Math.round(100 * health.battery) + " %", heat = Math.round(health.temperature) + " °C";
  const words = percent + heat + health.charging;
  if (part.dataset.words === words) return;
  part.dataset.words = words;
  part.replaceChildren(
    make("span", {class: health.battery < low ? "bad" : "", title: health.charging ? "its battery is being charged" : "its battery"},
      (health.charging ? "⚡ " : "▮ ") + percent + (health.battery < low ? " low" : "")),
    make("span", {class: health.temperature > hot ? "bad" : "", title: "its hottest joint: " + health.joint}, heat + (health.temperature > hot ? " hot: " + health.joint : "")));
}
