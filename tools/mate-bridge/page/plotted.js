// One value over time: which of its numbers are drawn, by name, and saving them.
import uPlot from "uplot";
import {make, button, csv, download} from "./elements.js";
import {axes, colours, svgOf} from "./canvas.js";

const shownSeconds = 20, atFirst = 6, tall = 190;
const chosen = new Map(); // by key: the names of the numbers that a person wants; else the first ones

const unitOf = key => /angles|position/i.test(key) ? " [rad]" : "";
// Okabe and Ito's colours, told apart by colour-blind people too; beyond them dashes.
const strokes = () => [colours.blue, colours.orange, colours.pink, colours.good, colours.ink, colours.soft];
const styleOf = i => ({stroke: strokes()[i % 6], dash: i >= 6 ? [6, 4] : undefined});

export class Plotted {
  constructor(key, stop) {
    Object.assign(this, {key, history: null, plot: null, drawn: make("div", {class: "plot"}), chips: make("div", {class: "chips"})});
    this.words = make("pre", {class: "value"}, "waiting for its first value");
    this.figure = make("figure", {}, make("figcaption", {}, make("b", {}, key + unitOf(key)), ...this.savers(),
      button("×", stop, {class: "small", "aria-label": "stop plotting " + key})), this.drawn, this.chips, this.words);
  }

  names() {
    const all = this.history.names();
    return chosen.has(this.key) ? all.filter(name => chosen.get(this.key).has(name)) : all.slice(0, atFirst);
  }

  // What is drawn as a picture or as strokes, and all that is remembered of it as a table.
  savers() {
    const {key} = this, saver = (kind, save) => button(kind, () => { if (this.history) save(); }, {class: "small", "aria-label": "save as " + kind + ": " + key});
    return [saver("PNG", () => this.plot && this.plot.ctx.canvas.toBlob(blob => download(key + ".png", blob))),
      saver("SVG", () => download(key + ".svg", svgOf((context, width, height) => this.drawOn(context, width, height), 900, 320), "image/svg+xml")),
      saver("CSV", () => download(key + ".csv", csv(this.history.rows()), "text/csv"))];
  }

  draw(history) {
    this.history = history;
    if (!history || !this.drawn.isConnected) return;
    this.words.textContent = history.text();
    const names = this.names(), shown = history.names().join("\n") + "\n\n" + names.join("\n");
    if (this.shown !== shown || this.colours !== colours) { // these are others after a change of theme
      Object.assign(this, {shown, colours});
      this.showChips(names);
      this.drop();
      if (names.length) this.plot = plotIn(this.drawn, names);
    }
    if (this.plot) this.plot.setData(history.since(shownSeconds, names));
  }

  // The numbers by name: legend and choice at once.
  showChips(names) {
    const all = this.history.names();
    if (all.length < 2) return this.chips.replaceChildren();
    this.chips.replaceChildren(...all.map(name => {
      const i = names.indexOf(name), swatch = make("span", {class: "swatch"});
      if (i >= 0) Object.assign(swatch.style, {borderTopColor: styleOf(i).stroke, borderTopStyle: i >= 6 ? "dashed" : "solid"});
      return make("button", {type: "button", class: "small", "aria-pressed": String(i >= 0), onclick: () => {
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

  // A plot that is only dropped would be kept by what it listens to.
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
