// Canvases that redraw themselves and tell what is under the pointer.

// The style sheet's colours, light or dark.
export let colours = {};
export const redrawAll = () => document.querySelectorAll(".figure").forEach(({redraw}) => redraw());

export function readColours() {
  const probe = document.body.appendChild(document.createElement("i")), read = {};
  for (const name of ["paper", "panel", "ink", "soft", "line", "blue", "orange", "pink", "good"]) {
    probe.style.color = "var(--" + name + ")";
    read[name] = getComputedStyle(probe).color;
  }
  probe.remove();
  colours = read;
  redrawAll();
}

export function showTip(event, text) {
  const tip = document.getElementById("tip");
  tip.hidden = false;
  tip.textContent = text;
  tip.style.left = Math.max(4, Math.min(event.clientX + 14, innerWidth - tip.offsetWidth - 8)) + "px";
  tip.style.top = (event.clientY + 18 + tip.offsetHeight < innerHeight ? event.clientY + 18
                                                                     : event.clientY - tip.offsetHeight - 12) + "px";
}
export const hideTip = () => { document.getElementById("tip").hidden = true; };

export const font = "12px system-ui, sans-serif";

// A frame with a canvas: draw(context, width, height) paints it and returns what can be pointed at,
// [{x, y, tip: () => text, click?}]. `height`: a number, or a function of the width. The frame's `redraw` draws again.
export function figure({height, draw, label, className = ""}) {
  const frame = document.createElement("div"), canvas = document.createElement("canvas"), ring = document.createElement("div");
  frame.className = ("figure " + className).trim();
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", label);
  ring.className = "ring";
  ring.hidden = true;
  frame.append(canvas, ring);
  let targets = [], chosen, drawnWidth = 0;
  const leave = () => {
    chosen = undefined;
    ring.hidden = true;
    hideTip();
  };

  frame.redraw = () => {
    const width = frame.clientWidth, tall = typeof height === "function" ? height(width) : height;
    if (!width) return; // not on the page, or hidden
    const scale = window.devicePixelRatio || 1, context = canvas.getContext("2d");
    canvas.width = Math.round(width * scale);
    canvas.height = Math.round(tall * scale);
    canvas.style.height = tall + "px";
    context.scale(scale, scale);
    context.font = font;
    leave();
    targets = draw(context, width, tall) || [];
  };
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
  new ResizeObserver(() => requestAnimationFrame(() => {
    if (frame.clientWidth !== drawnWidth) {
      drawnWidth = frame.clientWidth;
      frame.redraw();
    }
  })).observe(frame);
  return frame;
}
