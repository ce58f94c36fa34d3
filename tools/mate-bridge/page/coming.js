// The poses of a round, each as the robot will stand in it, before it is played.
import {make} from "./elements.js";
import {send, on} from "./connection.js";
import {standingFigure} from "./standing.js";

const waiting = new Map(); // by the number that the bridge was asked with
let asked = 2e6;

on("stand", message => {
  const pose = waiting.get(message.number);
  if (!pose) return;
  waiting.delete(message.number);
  pose.stand = message.hull ? message : null;
  pose.drawn.redraw();
});

// Poses that follow each other under one name are one pose, come into from several sides.
export function comingPoses({round, poses}) {
  waiting.clear();
  const groups = [];
  poses.forEach(({name, angles}, i) => {
    if (groups.length && groups.at(-1).name === name) groups.at(-1).count += 1;
    else groups.push({name, angles, first: i, count: 1, stand: null});
  });
  if (!groups.length) return [];
  return [make("h2", {}, round ? "Poses of the second round, which checks" : "Poses of the first round"),
    make("ol", {class: "thumbnails poses", "aria-label": "poses in the order in which they are played"}, ...groups.map(pose => {
      pose.drawn = standingFigure(() => ({now: null, next: pose.stand}), "pose " + pose.name, 120);
      waiting.set(++asked, pose);
      send({do: "stand", number: asked, angles: pose.angles});
      return make("li", {"data-first": String(pose.first), "data-count": String(pose.count)}, pose.drawn, make("b", {}, pose.name), make("span", {class: "soft"}));
    }))];
}

export function markStep(part, step) {
  for (const item of part.querySelectorAll("li")) {
    const first = Number(item.dataset.first), count = Number(item.dataset.count);
    const state = step >= first + count ? "taken" : step >= first ? "now" : "to-come", words = state.replace("-", " ") + (count > 1 ? ", from " + count + " sides" : "");
    if (item.className === state) continue;
    item.className = state;
    item.lastChild.textContent = words;
  }
}
