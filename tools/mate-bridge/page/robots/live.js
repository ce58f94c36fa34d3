// Live view: both cameras, and plots of values over time.
import {button, choice, element, empty, renew} from "naocal/lib/dom.js";
import {want} from "../core/subscriptions.js";
import {cameraAt, cameraKeys} from "./camera.js";
import {entryOf, nameOf, refreshBar, robotBar, robots, selectedRobot, whyNothing} from "./robots.js";
import {History, Plotted} from "./value-plot.js";

/** @type {{camera: any, key?: string | null}[]} */
const slots = [{camera: null}, {camera: null}]; // key: image key; undefined: not selected yet, null: none
const plotted = new Set(); // keys
let histories = new Map(), figures = new Map(), shownRobot = null, parentShown = null, filter = "";

export function showLive(parent) {
  parentShown = parent;
  const robot = selectedRobot(), why = whyNothing();
  if (robot !== shownRobot) forget();
  shownRobot = robot;
  forgetFigures();
  renew(parent, element("div", {class: "heading"}, element("h1", {}, "Live"), robotBar(again)), ...(why ? [empty(...why)] : content(robot)));
  if (!why) follow();
}
const again = () => showLive(parentShown);

export function leaveLive() {
  parentShown = null;
  follow();
  forgetFigures();
}

function forgetFigures() {
  for (const figure of figures.values()) figure.drop();
  figures.clear();
}

function forget() {
  histories = new Map();
  slots.forEach(slot => { slot.key = undefined; });
  follow();
}

function content(robot) {
  const {list, connected, sentence} = entryOf(robot);
  const {images, chosen} = cameraKeys(list), values = list.filter(({isImage}) => !isImage);
  slots.forEach((slot, i) => { if (slot.key === undefined || (slot.key && !images.includes(slot.key))) slot.key = chosen[i]; });
  return [connected ? null : element("p", {class: "bad"}, nameOf(robot) + " " + sentence + ". The panel retries every second; below are its last known values."),
    element("div", {class: "cameras"}, ...slots.map(slot => cameraOf(slot, images))),
    element("div", {class: "split live"}, keyList(values), plots())].filter(Boolean);
}

function cameraOf(slot, images) {
  slot.camera = cameraAt("live\n" + slots.indexOf(slot) + "\n" + shownRobot + "\n" + slot.key, "picture of the robot's camera");
  if (!slot.key) slot.camera.caption.textContent = "no picture chosen";
  else if (!entryOf(shownRobot).connected && slot.camera.times.length) slot.camera.caption.textContent = "last picture received";
  const options = [{value: "", text: "nothing"}, ...images.map(value => ({value, text: value}))];
  return element("figure", {class: "camera"}, choice("Camera", options, slot.key || "", value => { slot.key = value || null; again(); }),
    slot.camera.canvas, slot.camera.caption);
}

function keyList(values) {
  const list = element("ul", {class: "keylist"});
  const fill = () => list.replaceChildren(...values.filter(({key}) => key.toLowerCase().includes(filter.toLowerCase())).map(({key}) => {
    const box = element("input", {type: "checkbox"});
    box.checked = plotted.has(key);
    box.addEventListener("change", () => {
      if (box.checked) plotted.add(key); else plotted.delete(key);
      document.querySelector(".plots")?.replaceWith(plots());
      follow();
    });
    return element("li", {}, element("label", {}, box, " ", key));
  }));
  const search = element("input", {type: "search", id: "valueFilter", placeholder: "filter " + values.length + " values", "aria-label": "filter values", oninput: () => { filter = search.value; fill(); }});
  search.value = filter;
  fill();
  return element("div", {}, element("h2", {}, "Values"), search, list);
}

function plots() {
  const part = element("div", {class: "plots"});
  forgetFigures();
  if (!plotted.size) part.append(empty("Nothing is plotted", "Choose values on the left, as many as you like.", ...usual()));
  for (const key of plotted) {
    const figure = new Plotted(key, () => { plotted.delete(key); again(); });
    part.append(figure.figure);
    figures.set(key, figure);
  }
  requestDraw(); // draws the stored history
  return part;
}

// Button that plots the joints' angles, where the robot lists them.
function usual() {
  const key = "Motion.angles";
  if (!entryOf(shownRobot).list.some(one => one.key === key)) return [];
  return [element("span", {class: "controls next-steps"}, button("Plot the joint angles", () => { plotted.add(key); again(); }, {class: "main"}))];
}

const follow = () => want("live", parentShown && shownRobot, [...plotted, ...slots.map(({key}) => key).filter(Boolean)]);

export function onMessage(message, file, isShown) {
  if (message.kind === "update") return updated(message, isShown);
  if (message.kind === "picture") return pictured(message, file, isShown);
  if (!isShown || !parentShown || !["robot", "robotGone", "list"].includes(message.kind)) return;
  if (message.robot !== shownRobot && robots.has(shownRobot)) refreshBar(parentShown, again);
  else again();
}

function updated({robot, values}, isShown) {
  if (robot !== shownRobot) return;
  for (const {key, timestamp, value} of values) {
    if (!histories.has(key)) histories.set(key, new History(5000));
    histories.get(key).add(timestamp / 1000, value);
  }
  if (isShown) requestDraw();
}

function pictured({robot, key, width, height}, file, isShown) {
  const slot = slots.find(one => one.key === key);
  if (isShown && robot === shownRobot && slot && slot.camera) slot.camera.show(file, {width, height});
}

const betweenDraws = 100; // [ms]; limits plotting to 10 Hz, as pictures need the time
let drawing = false;
function requestDraw() {
  if (drawing) return;
  drawing = true;
  setTimeout(() => requestAnimationFrame(() => {
    drawing = false;
    for (const [key, figure] of figures) figure.draw(histories.get(key));
  }), betweenDraws);
}
