// Canvases that redraw themselves, tell what is under the pointer, and share axes.

const redraws = new Set();
const redrawAll = () => redraws.forEach(redraw => redraw());

// The style sheet's colours, light or dark.
let colours = {};
function readColours() {
  const style = getComputedStyle(document.documentElement);
  for (const name of ["paper", "panel", "soft", "line", "blue", "orange", "pink"]) {
    colours[name] = style.getPropertyValue("--" + name).trim();
  }
}
readColours();
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { readColours(); redrawAll(); });

// A canvas in `parent`. draw(context, width, height) paints it and returns what can be pointed at:
// a list of {x, y, tip: () => text} and, where a click shows one, its picture.
function canvasFigure(parent, heightOf, draw, label) {
  const frame = parent.appendChild(element("div", "figure"));
  const canvas = frame.appendChild(element("canvas"));
  const ring = frame.appendChild(element("div", "ring"));
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", label);
  ring.hidden = true;
  let targets = [], chosen;

  function redraw() {
    const width = frame.clientWidth, height = heightOf(width), scale = window.devicePixelRatio || 1;
    if (!width) return;
    canvas.width = Math.round(width * scale);
    canvas.height = Math.round(height * scale);
    canvas.style.height = height + "px";
    const context = canvas.getContext("2d");
    context.scale(scale, scale);
    context.font = "12px system-ui, sans-serif";
    leave();
    targets = draw(context, width, height);
  }
  function leave() {
    chosen = undefined;
    ring.hidden = true;
    hideTip();
  }
  function point(event) {
    const box = canvas.getBoundingClientRect();
    const x = event.clientX - box.left, y = event.clientY - box.top;
    let nearest = 18;
    chosen = undefined;
    for (const target of targets) {
      const distance = Math.hypot(target.x - x, target.y - y);
      if (distance < nearest) { nearest = distance; chosen = target; }
    }
    if (!chosen) { leave(); return; }
    ring.hidden = false;
    ring.style.left = chosen.x + "px";
    ring.style.top = chosen.y + "px";
    showTip(event, chosen.tip());
  }
  canvas.addEventListener("pointermove", point);
  canvas.addEventListener("pointerdown", point);
  canvas.addEventListener("pointerleave", leave);
  canvas.addEventListener("click", () => { if (chosen && chosen.picture) showPicture(chosen.picture); });
  let drawnWidth = 0;
  new ResizeObserver(() => requestAnimationFrame(() => {
    if (frame.clientWidth !== drawnWidth) {
      drawnWidth = frame.clientWidth;
      redraw();
    }
  })).observe(frame);
  redraws.add(redraw);
  return redraw;
}

// A point beyond an axis lies at its end and points outwards (sign -1: up).
function dot(context, {x, y, beyond}) {
  context.beginPath();
  if (beyond) {
    context.moveTo(x - 4, y - 2 * beyond);
    context.lineTo(x + 4, y - 2 * beyond);
    context.lineTo(x, y + 5 * beyond);
  } else {
    context.arc(x, y, 2.5, 0, 7);
  }
  context.fill();
}

// Round numbers from low to high, about `count` of them.
function ticks(low, high, count) {
  const rough = (high - low) / count, power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find(factor => factor * power >= 0.7 * rough);
  const result = [];
  for (let i = Math.ceil(low / step); i * step <= high + 1e-9 * step; ++i) {
    result.push(Number((i * step).toPrecision(12)));
  }
  return result;
}

// Grid lines and numbers around `box`; returns the functions from values to pixels. Without xLabel no x numbers.
function axes(context, box, [xLow, xHigh], [yLow, yHigh], {title, xLabel}) {
  const x = value => box.left + (value - xLow) / (xHigh - xLow) * (box.right - box.left);
  const y = value => box.bottom - (value - yLow) / (yHigh - yLow) * (box.bottom - box.top);
  context.strokeStyle = colours.line;
  context.fillStyle = colours.soft;
  context.lineWidth = 1;
  const line = (x0, y0, x1, y1) => {
    context.beginPath();
    context.moveTo(x0, y0);
    context.lineTo(x1, y1);
    context.stroke();
  };
  context.textAlign = "right";
  context.textBaseline = "middle";
  for (const value of ticks(yLow, yHigh, 5)) {
    context.strokeStyle = value === 0 ? colours.soft : colours.line;
    line(box.left, y(value), box.right, y(value));
    context.fillText(String(value).replace("-", "−"), box.left - 6, y(value));
  }
  context.textAlign = "center";
  context.textBaseline = "top";
  if (xLabel) {
    for (const value of ticks(xLow, xHigh, (box.right - box.left) / 70)) {
      line(x(value), box.bottom, x(value), box.bottom + 4);
      context.fillText(String(value).replace("-", "−"), x(value), box.bottom + 6);
    }
    context.fillText(xLabel, (box.left + box.right) / 2, box.bottom + 22);
  }
  context.textAlign = "left";
  context.fillText(title, box.left - 30, box.top - 20);
  return {x, y, line};
}

// How often errors are enlarged so that most of them stay shorter than `longest`.
const enlargement = (lengths, longest) =>
  [100, 50, 20, 10, 5, 2].find(factor => factor * quantile(lengths, 0.9) <= longest) || 1;
const enlargedWords = factor => factor === 1 ? "not enlarged" : "enlarged " + factor + " times";

function arrow(context, colour, thick, x, y, dx, dy) {
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
