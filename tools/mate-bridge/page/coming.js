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

export function comingPoses({round, poses}) {
  waiting.clear();
  if (!poses.length) return [];
  return [make("h2", {}, round ? "Poses of the second round, which checks" : "Poses of the first round"),
    make("ol", {class: "thumbnails poses", "aria-label": "poses in the order in which they are played"}, ...poses.map(({name, angles}) => {
      const pose = {stand: null};
      pose.drawn = standingFigure(() => ({now: null, next: pose.stand}), "pose " + name, 120);
      waiting.set(++asked, pose);
      send({do: "stand", number: asked, angles});
      return make("li", {}, pose.drawn, make("b", {}, name), make("span", {class: "soft"}));
    }))];
}

export function markStep(part, step) {
  part.querySelectorAll("li").forEach((item, i) => {
    const words = i < step ? "taken" : i === step ? "now" : "to come";
    if (item.className === words.replace(" ", "-")) return;
    item.className = words.replace(" ", "-");
    item.lastChild.textContent = words;
  });
}
