// Canvases that redraw themselves, tell what is under the pointer, and share axes; as in the report.
import {make, showTip, hideTip, download} from "./elements.js";
import {quantile} from "./words.js";

export let colours = {};
const redraws = new Set();

export function readColours() {
  const probe = document.body.appendChild(make("i"));
  colours = {};
  for (const name of ["paper", "panel", "ink", "soft", "line", "blue", "orange", "pink", "good"]) {
    probe.style.color = "var(--" + name + ")";
    colours[name] = getComputedStyle(probe).color;
  }
  probe.remove();
  redraws.forEach(redraw => redraw());
}

// A canvas: draw(context, width, height) paints it and returns what can be pointed at, [{x, y, tip: () => text,
// click?}]. Its `redraw` draws again; it is forgotten once it has left the page.
export function figure({height, draw, label, className = ""}) {
  const canvas = make("canvas", {role: "img", "aria-label": label});
  const ring = make("div", {class: "ring", hidden: true});
  const frame = make("div", {class: "figure " + className}, canvas, ring);
  let targets = [], chosen, wasShown = false;

  frame.redraw = () => {
    if (!frame.isConnected) {
      if (wasShown) redraws.delete(frame.redraw);
      return;
    }
    wasShown = true;
    const width = frame.clientWidth, tall = typeof height === "function" ? height(width) : height;
    if (!width) return;
    const scale = window.devicePixelRatio || 1;
    canvas.width = Math.round(width * scale);
    canvas.height = Math.round(tall * scale);
    canvas.style.height = tall + "px";
    const context = canvas.getContext("2d");
    context.scale(scale, scale);
    context.font = "12px system-ui, sans-serif";
    leave();
    targets = draw(context, width, tall) || [];
  };
  frame.save = name => canvas.toBlob(blob => download(name, blob));
  const leave = () => { chosen = undefined; ring.hidden = true; hideTip(); };
  const point = event => {
    const box = canvas.getBoundingClientRect(), x = event.clientX - box.left, y = event.clientY - box.top;
    let nearest = 18;
    chosen = undefined;
    for (const target of targets) {
      const dx = Math.abs(target.x - x), dy = Math.abs(target.y - y);
      if (dx > nearest || dy > nearest) continue;
      const distance = Math.hypot(dx, dy);
      if (distance < nearest) { nearest = distance; chosen = target; }
    }
    if (!chosen) { leave(); return; }
    ring.hidden = false;
    ring.style.left = chosen.x + "px";
    ring.style.top = chosen.y + "px";
    canvas.style.cursor = chosen.click ? "pointer" : "default";
    showTip(event, chosen.tip());
  };
  canvas.addEventListener("pointermove", point);
  canvas.addEventListener("pointerdown", point);
  canvas.addEventListener("pointerleave", leave);
  canvas.addEventListener("click", () => { if (chosen && chosen.click) chosen.click(); });
  new ResizeObserver(() => requestAnimationFrame(frame.redraw)).observe(frame);
  redraws.add(frame.redraw);
  return frame;
}

// Round numbers from low to high, about `count` of them.
export function ticks(low, high, count) {
  const rough = (high - low) / Math.max(1, count), power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find(factor => factor * power >= 0.7 * rough);
  const result = [];
  for (let i = Math.ceil(low / step); i * step <= high + 1e-9 * step; ++i) result.push(Number((i * step).toPrecision(12)));
  return result;
}

// Grid lines and numbers around `box`; returns the functions from values to pixels.
export function axes(context, box, [xLow, xHigh], [yLow, yHigh], {yLabel, xLabel}) {
  const x = value => box.left + (value - xLow) / (xHigh - xLow) * (box.right - box.left);
  const y = value => box.bottom - (value - yLow) / (yHigh - yLow) * (box.bottom - box.top);
  const line = (x0, y0, x1, y1) => {
    context.beginPath();
    context.moveTo(x0, y0);
    context.lineTo(x1, y1);
    context.stroke();
  };
  const text = value => String(value).replace("-", "−");
  context.fillStyle = colours.soft;
  context.lineWidth = 1;
  context.textAlign = "right";
  context.textBaseline = "middle";
  for (const value of ticks(yLow, yHigh, (box.bottom - box.top) / 45)) {
    context.strokeStyle = value === 0 ? colours.soft : colours.line;
    line(box.left, y(value), box.right, y(value));
    context.fillText(text(value), box.left - 6, y(value));
  }
  context.strokeStyle = colours.line;
  context.textAlign = "center";
  context.textBaseline = "top";
  for (const value of ticks(xLow, xHigh, (box.right - box.left) / 70)) {
    line(x(value), box.bottom, x(value), box.bottom + 4);
    context.fillText(text(value), x(value), box.bottom + 6);
  }
  context.fillStyle = colours.ink;
  context.fillText(xLabel, (box.left + box.right) / 2, box.bottom + 22);
  context.textAlign = "left";
  context.fillText(yLabel, box.left - 40, box.top - 20);
  return {x, y, line};
}

export const enlargement = (lengths, longest) =>
  [200, 100, 50, 20, 10, 5, 2].find(factor => factor * quantile(lengths, 0.9) <= longest) || 1;
export const enlargedWords = factor => factor === 1 ? "not enlarged" : "enlarged " + factor + " times";

export function arrow(context, colour, thick, x, y, dx, dy) {
  const length = Math.hypot(dx, dy), head = Math.min(5 + thick, 0.5 * length), angle = Math.atan2(dy, dx);
  context.strokeStyle = colour;
  context.lineWidth = thick;
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(x + dx, y + dy);
  for (const side of [-2.6, 2.6]) {
    context.moveTo(x + dx, y + dy);
    context.lineTo(x + dx + head * Math.cos(angle + side), y + dy + head * Math.sin(angle + side));
  }
  context.stroke();
}
