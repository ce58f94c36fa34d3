// Canvas figures: redrawn on resize, with a tooltip for the target under the pointer.
import {contextOf, element, showTip, hideTip} from "naocal/lib/dom.js";

/** @import {Target, Draw} from "naocal/lib/types.js" */

/** Colours of the style sheet, for the present theme. @type {Record<string, string>} */
export let colours = {};
export const redrawAll = () => document.querySelectorAll(".figure").forEach(frame => /** @type {Figure} */ (frame).redraw());

export function readColours() {
  const probe = document.body.appendChild(element("i"));
  /** @type {Record<string, string>} */
  const read = {};
  for (const name of ["paper", "panel", "ink", "soft", "line", "blue", "orange", "pink", "good"]) {
    probe.style.color = "var(--" + name + ")";
    read[name] = getComputedStyle(probe).color;
  }
  probe.remove();
  colours = read;
  redrawAll();
}

export const font = "12px system-ui, sans-serif";

/** @typedef {HTMLDivElement & {redraw: () => void}} Figure */

/**
 * @typedef {object} FigureOptions
 * @property {string} label accessible name
 * @property {number | ((width: number) => number)} height
 * @property {Draw} draw paints the figure; returns the targets of the pointer
 * @property {string} [className]
 * @property {(picture: any) => void} [open] opens the picture of a clicked target
 */

/** Observers of new figures. @type {((frame: Figure, options: FigureOptions) => void)[]} */
const listeners = [];
/** @param {(frame: Figure, options: FigureOptions) => void} listener */
export const onNewFigure = listener => { listeners.push(listener); };

/**
 * Resizes a canvas to `width` x `height` CSS pixels; returns its context, cleared and scaled to the screen's pixels.
 * @param {HTMLCanvasElement} canvas
 * @param {number} width
 * @param {number} height
 */
function resizeCanvas(canvas, width, height) {
  const scale = window.devicePixelRatio || 1, context = contextOf(canvas);
  canvas.width = Math.round(width * scale);
  canvas.height = Math.round(height * scale);
  canvas.style.height = height + "px";
  context.scale(scale, scale);
  context.font = font;
  return context;
}

/**
 * The target nearest to a point, at most 18 px away.
 * @param {Target[]} targets
 * @param {number} x
 * @param {number} y
 */
function nearestTarget(targets, x, y) {
  let nearest = 18;
  /** @type {Target | undefined} */
  let found;
  for (const target of targets) {
    const dx = Math.abs(target.x - x), dy = Math.abs(target.y - y);
    if (dx > nearest || dy > nearest) continue;
    const distance = Math.hypot(dx, dy);
    if (distance < nearest) { nearest = distance; found = target; }
  }
  return found;
}

/**
 * A frame with a canvas; `redraw` repaints it.
 * @param {FigureOptions} options
 * @returns {Figure}
 */
export function figure(options) {
  const {height, draw, label, className = "", open} = options;
  const canvas = element("canvas", {role: "img", "aria-label": label}), ring = element("div", {class: "ring", hidden: true});
  const frame = /** @type {Figure} */ (element("div", {class: ("figure " + className).trim()}, canvas, ring));
  /** @type {Target[]} */
  let targets = [];
  /** @type {Target | undefined} */
  let chosen;
  let drawnWidth = 0;
  const leave = () => {
    chosen = undefined;
    ring.hidden = true;
    hideTip();
  };

  frame.redraw = () => {
    const width = frame.clientWidth, tall = typeof height === "function" ? height(width) : height;
    if (!width) return; // not on the page, or hidden
    const context = resizeCanvas(canvas, width, tall);
    leave();
    targets = draw(context, width, tall) || [];
  };
  const clickOf = (/** @type {Target} */ {click, picture}) => click ?? (open && picture !== undefined ? () => open(picture) : undefined);
  const point = (/** @type {PointerEvent} */ event) => {
    const box = canvas.getBoundingClientRect();
    chosen = nearestTarget(targets, event.clientX - box.left, event.clientY - box.top);
    if (!chosen) { leave(); return; }
    ring.hidden = false;
    ring.style.left = chosen.x + "px";
    ring.style.top = chosen.y + "px";
    canvas.style.cursor = clickOf(chosen) ? "pointer" : "default";
    showTip(event, chosen.tip());
  };
  canvas.addEventListener("pointermove", point);
  canvas.addEventListener("pointerdown", point);
  canvas.addEventListener("pointerleave", leave);
  canvas.addEventListener("click", () => { if (chosen) clickOf(chosen)?.(); });
  new ResizeObserver(() => requestAnimationFrame(() => {
    if (frame.clientWidth !== drawnWidth) {
      drawnWidth = frame.clientWidth;
      frame.redraw();
    }
  })).observe(frame);
  for (const listener of listeners) listener(frame, options);
  return frame;
}

/**
 * A figure with a caption that `draw` fills.
 * @param {Omit<FigureOptions, "draw"> & {draw: (context: CanvasRenderingContext2D, width: number, height: number, caption: HTMLElement) => Target[] | void}} options
 */
export function captioned({draw, ...options}) {
  const caption = element("figcaption");
  return element("figure", {}, figure({...options, draw: (context, width, height) => draw(context, width, height, caption)}), caption);
}

/** Figure height that keeps the aspect ratio of a picture. @param {{width: number, height: number}} size */
export const inProportion = ({width, height}) => (/** @type {number} */ shown) => shown * height / width;
