// Live: both cameras, and any number of values over time.
import uPlot from "uplot";
import {make, button, csv, download, empty, choice} from "./elements.js";
import {wish} from "./subscriptions.js";
import {Camera, cameraKeys} from "./camera.js";
import {colours} from "./canvas.js";
import {robots, robotBar, lookedAt, whyNothing} from "./robots.js";
import {History} from "./history.js";

const shownSeconds = 20;
const slots = [{key: null, camera: null}, {key: null, camera: null}];
const plotted = new Set(); // keys
let histories = new Map(), figures = new Map(), shownRobot = null, parentShown = null, filter = "";

export function showLive(parent) {
  parentShown = parent;
  const robot = lookedAt(), why = whyNothing();
  if (robot !== shownRobot) forget();
  shownRobot = robot;
  forgetFigures();
  parent.replaceChildren(make("h1", {}, "Live"), robotBar(() => showLive(parent)), ...(why ? [empty(...why)] : content(robot)));
  if (!why) follow();
}

export function leaveLive() {
  parentShown = null;
  follow();
  forgetFigures();
}

// A plot that is only dropped would be kept by what it listens to.
function forgetFigures() {
  for (const {plot} of figures.values()) if (plot) plot.destroy();
  figures.clear();
}

function forget() {
  histories = new Map();
  slots.forEach(slot => { slot.key = null; });
  follow();
}

function content(robot) {
  const {list, connected, sentence} = robots.get(robot);
  const {images, chosen} = cameraKeys(list), values = list.filter(({isImage}) => !isImage);
  slots.forEach((slot, i) => { if (!images.includes(slot.key)) slot.key = chosen[i]; });
  return [connected ? null : make("p", {class: "bad"}, robot + " " + sentence + ". It is tried again every second; below is the last that it told."),
    make("div", {class: "cameras"}, ...slots.map(slot => cameraOf(slot, images))),
    make("div", {class: "split live"}, keyList(values), plots())].filter(Boolean);
}

function cameraOf(slot, images) {
  slot.camera = new Camera("picture of the robot's camera");
  if (!slot.key) slot.camera.caption.textContent = "no picture chosen";
  const options = [{value: "", text: "nothing"}, ...images.map(value => ({value, text: value}))];
  return make("figure", {class: "camera"}, choice("Camera", options, slot.key || "", value => { slot.key = value || null; follow(); }),
    slot.camera.canvas, slot.camera.caption);
}

function keyList(values) {
  const list = make("ul", {class: "keylist"});
  const fill = () => list.replaceChildren(...values.filter(({key}) => key.toLowerCase().includes(filter.toLowerCase())).map(({key}) => {
    const box = make("input", {type: "checkbox"});
    box.checked = plotted.has(key);
    box.addEventListener("change", () => {
      if (box.checked) plotted.add(key); else plotted.delete(key);
      document.querySelector(".plots").replaceWith(plots());
      follow();
    });
    return make("li", {}, make("label", {}, box, " ", key));
  }));
  const search = make("input", {type: "search", placeholder: "filter " + values.length + " values", "aria-label": "filter values", oninput: () => { filter = search.value; fill(); }});
  search.value = filter;
  fill();
  return make("div", {}, make("h2", {}, "Values"), search, list);
}

function plots() {
  const part = make("div", {class: "plots"});
  forgetFigures();
  if (!plotted.size) part.append(empty("Nothing is plotted", "Choose values on the left; any number can be shown at a time."));
  for (const key of plotted) {
    const drawn = make("div", {class: "plot"}), words = make("pre", {class: "value"}, "waiting for its first value");
    part.append(make("figure", {}, make("figcaption", {}, make("b", {}, key), ...savers(key), button("×", () => { plotted.delete(key); showLive(parentShown); }, {class: "small", "aria-label": "stop plotting " + key})), drawn, words));
    figures.set(key, {drawn, words, plot: null, names: "", colours: null});
  }
  return part;
}

// What is drawn as a picture, and all that is remembered of it as a table.
const savers = key => [
  button("PNG", () => { const {plot} = figures.get(key); if (plot) plot.ctx.canvas.toBlob(blob => download(key + ".png", blob)); }, {class: "small", "aria-label": "save as PNG: " + key}),
  button("CSV", () => { const history = histories.get(key); if (history) download(key + ".csv", csv(history.rows()), "text/csv"); }, {class: "small", "aria-label": "save as CSV: " + key})];

const follow = () => wish("live", parentShown && shownRobot, [...plotted, ...slots.map(({key}) => key).filter(Boolean)]);

export function liveTold(message, file, isShown) {
  if (message.kind === "update") return updated(message, isShown);
  if (message.kind === "picture") return pictured(message, file, isShown);
  if (isShown && message.kind !== "keys" && message.kind !== "mounts" && parentShown) showLive(parentShown);
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

const betweenDraws = 100; // eyes see no more, and pictures need the time [ms]
let drawing = false;
function requestDraw() {
  if (drawing) return;
  drawing = true;
  setTimeout(() => requestAnimationFrame(() => {
    drawing = false;
    for (const key of plotted) drawKey(key);
  }), betweenDraws);
}

function drawKey(key) {
  const figure = figures.get(key), history = histories.get(key);
  if (!figure || !history || !figure.drawn.isConnected) return;
  figure.words.textContent = history.text();
  const all = history.names(), names = all.slice(0, 8);
  if (all.length > names.length) figure.words.textContent = "drawn: the first 8 of " + all.length + " numbers\n" + figure.words.textContent;
  if (!names.length) return;
  if (!figure.plot || figure.names !== names.join() || figure.colours !== colours) { // these are others after a change of theme
    if (figure.plot) figure.plot.destroy();
    Object.assign(figure, {plot: plotIn(figure.drawn, names), names: names.join(), colours});
  }
  figure.plot.setData(history.since(shownSeconds, names));
}

// Okabe and Ito's colours, told apart by colour-blind people too; and dashes.
function plotIn(parent, names) {
  const strokes = [colours.blue, colours.orange, colours.pink, colours.good, colours.ink, colours.soft];
  const axis = {stroke: colours.soft, grid: {stroke: colours.line, width: 1}, ticks: {stroke: colours.line}};
  const plot = new uPlot({
    width: parent.clientWidth || 500, height: 190, legend: {show: names.length > 1, live: false}, cursor: {drag: {x: false, y: false}},
    scales: {x: {time: false}},
    series: [{label: "s"}, ...names.map((name, i) => ({label: name || "value", stroke: strokes[i % strokes.length], width: 1.5, points: {show: false}, dash: i >= strokes.length ? [6, 4] : undefined}))],
    axes: [{...axis, label: "seconds since the robot's start [s]", labelSize: 20, size: 34}, {...axis, size: 56}],
  }, [[], ...names.map(() => [])], parent);
  new ResizeObserver(() => plot.setSize({width: parent.clientWidth, height: 190})).observe(parent);
  return plot;
}
