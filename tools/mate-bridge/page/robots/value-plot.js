// Plot of one value over time: selection of its numbers, and export.
import uPlot from "uplot";
import {axes} from "naocal/lib/axes.js";
import {button, csv, download, element} from "naocal/lib/dom.js";
import {colours} from "naocal/lib/figure.js";
import {on} from "../core/connection.js";
import {svgOf} from "../core/figure-export.js";

const shownSeconds = 20, atFirst = 6, tall = 190;
const chosen = new Map(); // by key: names of the selected numbers; absent: the first six

const unitOf = key => /angles|position/i.test(key) ? " [rad]" : "";
// Okabe and Ito's colour-blind safe palette; dashed from the seventh line on.
const strokes = () => [colours.blue, colours.orange, colours.pink, colours.good, colours.ink, colours.soft];
const styleOf = i => ({stroke: strokes()[i % 6], dash: i >= 6 ? [6, 4] : undefined});

export class Plotted {
  constructor(key, stop) {
    this.key = key;
    this.history = null;
    this.plot = null;
    this.shown = "";
    this.colours = colours;
    this.drawn = element("div", {class: "plot"});
    this.chips = element("div", {class: "chips"});
    this.words = element("pre", {class: "value"}, "waiting for its first value");
    this.figure = element("figure", {}, element("figcaption", {}, element("b", {}, key + unitOf(key)), ...this.savers(),
      button("×", stop, {class: "small", "aria-label": "stop plotting " + key})), this.drawn, this.chips, this.words);
  }

  names() {
    const all = this.history.names();
    return chosen.has(this.key) ? all.filter(name => chosen.get(this.key).has(name)) : all.slice(0, atFirst);
  }

  // Buttons: the plot as PNG or SVG, the whole history as CSV.
  savers() {
    const {key} = this, saver = (kind, save) => button(kind, () => { if (this.history) save(); }, {class: "small", "aria-label": "save as " + kind + ": " + key});
    return [saver("PNG", () => this.plot && this.plot.ctx.canvas.toBlob(blob => blob && download(key + ".png", blob))),
      saver("SVG", () => download(key + ".svg", svgOf((context, width, height) => this.drawOn(context, width, height), 900, 320), "image/svg+xml")),
      saver("CSV", () => download(key + ".csv", csv(this.history.rows()), "text/csv"))];
  }

  draw(history) {
    this.history = history;
    if (!history || !this.drawn.isConnected) return;
    this.words.textContent = history.text();
    const names = this.names(), shown = history.names().join("\n") + "\n\n" + names.join("\n");
    if (this.shown !== shown || this.colours !== colours) { // `colours` is replaced when the theme changes
      Object.assign(this, {shown, colours});
      this.showChips(names);
      this.drop();
      if (names.length) this.plot = plotIn(this.drawn, names);
    }
    if (this.plot) this.plot.setData(history.since(shownSeconds, names));
  }

  // One button per number: legend and selection.
  showChips(names) {
    const all = this.history.names();
    if (all.length < 2) return this.chips.replaceChildren();
    this.chips.replaceChildren(...all.map(name => {
      const i = names.indexOf(name), swatch = element("span", {class: "swatch"});
      if (i >= 0) Object.assign(swatch.style, {borderTopColor: styleOf(i).stroke, borderTopStyle: i >= 6 ? "dashed" : "solid"});
      return element("button", {type: "button", class: "small", "aria-pressed": String(i >= 0), onclick: () => {
        chosen.set(this.key, new Set(i >= 0 ? names.filter(one => one !== name) : [...names, name]));
        this.draw(this.history);
      }}, swatch, name);
    }));
  }

  drawOn(context, width, height) {
    const names = this.names(), [times, ...series] = this.history.since(shownSeconds, names);
    const values = series.flat().filter(value => value !== null), low = Math.min(...values), high = Math.max(...values), margin = 0.05 * (high - low) || 1;
    const {x, y} = axes(context, {left: 60, right: width - 130, top: 30, bottom: height - 44}, [times[0], times[times.length - 1]], [low - margin, high + margin],
      {title: this.key + unitOf(this.key), xLabel: "seconds since the robot's start [s]"});
    series.forEach((list, i) => {
      context.strokeStyle = context.fillStyle = styleOf(i).stroke;
      context.lineWidth = 1.5;
      context.setLineDash(styleOf(i).dash || []);
      context.beginPath();
      list.forEach((value, at) => { if (value !== null) at ? context.lineTo(x(times[at]), y(value)) : context.moveTo(x(times[at]), y(value)); });
      context.stroke();
      context.fillText(names[i] || "value", width - 120, 34 + 18 * i);
    });
    context.setLineDash([]);
  }

  // Without destroy(), the plot's listeners would keep it alive.
  drop() {
    if (this.plot) this.plot.destroy();
    this.plot = null;
  }
}

function plotIn(parent, names) {
  const axis = {stroke: colours.soft, grid: {stroke: colours.line, width: 1}, ticks: {stroke: colours.line}};
  const plot = new uPlot({
    width: parent.clientWidth || 500, height: tall, legend: {show: false}, cursor: {drag: {x: false, y: false}}, scales: {x: {time: false}},
    series: [{label: "s"}, ...names.map((name, i) => ({label: name || "value", ...styleOf(i), width: 1.5, points: {show: false}}))],
    axes: [{...axis, label: "seconds since the robot's start [s]", labelSize: 20, size: 34}, {...axis, size: 56}],
  }, [[], ...names.map(() => [])], parent);
  new ResizeObserver(() => plot.setSize({width: parent.clientWidth, height: tall})).observe(parent);
  return plot;
}

// Joint order of per-joint arrays, from the bridge.
/** @type {string[]} */
let joints = [];
on("hello", message => { joints = message.joints; });

// History of one key: time series by number's name, about `most` entries at most.
export class History {
  constructor(most) {
    this.most = most;
    this.times = [];
    this.series = new Map(); // by name: one number or null per timestamp
    this.last = undefined;
  }

  add(time, value) {
    this.last = value;
    const found = new Map();
    numbersIn(value, "", found);
    if (this.times.length && time <= this.times[this.times.length - 1]) {
      if (time < this.times[this.times.length - 1] - 1) { this.times = []; this.series.clear(); } // the robot was restarted
      else return;
    }
    this.times.push(time);
    for (const name of found.keys()) if (!this.series.has(name)) this.series.set(name, new Array(this.times.length - 1).fill(null));
    for (const [name, values] of this.series) values.push(found.has(name) ? found.get(name) : null);
    if (this.times.length > 1.2 * this.most) {
      this.times = this.times.slice(-this.most);
      for (const [name, values] of this.series) this.series.set(name, values.slice(-this.most));
    }
  }

  names() { return [...this.series.keys()]; }

  // The last seconds as uPlot columns, thinned to about 600 entries.
  since(seconds, names) {
    const begin = this.times[this.times.length - 1] - seconds, most = 600;
    let first = 0;
    while (this.times[first] < begin) ++first;
    const every = Math.max(1, Math.ceil((this.times.length - first) / most));
    const part = list => list.filter((_, i) => i >= first && (i - first) % every === 0);
    return [part(this.times), ...names.map(name => part(this.series.get(name)))];
  }

  // The whole history as rows, header first.
  rows() {
    return [["time [s]", ...this.names().map(name => name || "value")], ...this.times.map((time, i) => [time, ...[...this.series.values()].map(values => values[i])])];
  }

  // The last value as text, at most 400 characters.
  text() {
    const text = JSON.stringify(this.last, (key, value) => typeof value === "number" && !Number.isInteger(value) ? Number(value.toPrecision(6)) : value);
    return text === undefined ? "" : text.length > 400 ? text.slice(0, 400) + " …" : text;
  }
}

// Collects up to 64 numbers of a value by path ("[2]", "a.x"); booleans count as 0 and 1.
function numbersIn(value, name, found) {
  if (found.size >= 64) return;
  if (typeof value === "number") found.set(name, value);
  else if (typeof value === "boolean") found.set(name, Number(value));
  else if (Array.isArray(value)) value.forEach((one, i) => numbersIn(one, name + (value.length === joints.length ? (name ? "." : "") + joints[i] : "[" + i + "]"), found));
  else if (value && typeof value === "object") for (const key of Object.keys(value)) numbersIn(value[key], name ? name + "." + key : key, found);
}
