// Estimates with their error bars as a drawing, to be saved.
import {download, button} from "./elements.js";
import {colours, svgOf, ticks} from "./canvas.js";
import {number, withError} from "./words.js";

const high = 24, wide = 900, left = 190, right = wide - 250; // a row, the drawing, its axis [px]

function draw(context, width, height, {title, unit, rows}) {
  const ends = rows.flatMap(row => [row.low, row.high, 0]), low = Math.min(...ends), most = Math.max(...ends), margin = 0.04 * (most - low || 1);
  const place = value => left + (value - low + margin) / (most - low + 2 * margin) * (right - left);
  context.fillStyle = colours.paper;
  context.fillRect(0, 0, width, height);
  context.textBaseline = "middle";
  context.textAlign = "center";
  for (const mark of ticks(low - margin, most + margin, 6)) {
    context.fillStyle = mark === 0 ? colours.soft : colours.line;
    context.fillRect(place(mark), 30, 1, height - 56);
    context.fillStyle = colours.soft;
    context.fillText(number(mark), place(mark), height - 14);
  }
  context.textAlign = "left";
  context.fillStyle = colours.ink;
  context.fillText(title + (unit ? " [" + unit + "]" : ""), 8, 14);
  context.fillText("± one standard error", right + 20, 14);
  context.fillText("learned", wide - 60, 14);
  rows.forEach((row, i) => {
    const y = 42 + high * i;
    context.fillStyle = colours.blue;
    context.globalAlpha = 0.5;
    context.fillRect(place(row.low), y - 3, Math.max(2, place(row.high) - place(row.low)), 6);
    context.globalAlpha = 1;
    context.beginPath();
    context.arc(place(row.value), y, 4, 0, 7);
    context.fill();
    context.fillStyle = colours.ink;
    context.fillText(row.name, 8, y);
    context.fillText(withError(row.value, row.sigma, unit), right + 20, y);
    context.fillText(Math.round(100 * Math.max(0, row.learned)) + " %", wide - 60, y);
  });
}

export function savers(group) {
  const height = 68 + high * group.rows.length, name = group.title.replaceAll(" ", "-");
  const picture = () => {
    const canvas = document.createElement("canvas"), context = canvas.getContext("2d");
    Object.assign(canvas, {width: 2 * wide, height: 2 * height});
    context.scale(2, 2);
    context.font = "12px system-ui, sans-serif";
    draw(context, wide, height, group);
    canvas.toBlob(blob => download(name + ".png", blob));
  };
  return [button("PNG", picture, {class: "small", "aria-label": "save as PNG: " + group.title}),
    button("SVG", () => download(name + ".svg", svgOf((context, width, tall) => draw(context, width, tall, group), wide, height), "image/svg+xml"), {class: "small", "aria-label": "save as SVG: " + group.title})];
}
