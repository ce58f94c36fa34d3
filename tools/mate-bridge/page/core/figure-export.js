// Saves figures as PNG and SVG.
import {Context} from "svgcanvas";
import {button, contextOf, download, element} from "naocal/lib/dom.js";
import {font, onNewFigure} from "naocal/lib/figure.js";

const fileName = label => label.toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "").slice(0, 60);

// Renders a drawing to SVG through a recording context.
export function svgOf(draw, width, height) {
  const context = new Context({width, height, document});
  context.isVector = true;
  context.font = font;
  context.__applyText = applyText;
  draw(context, width, height);
  return context.getSerializedSvg();
}

// Replaces svgcanvas's method, which reads the font from an inline style: the page's CSP forbids those.
/** @this {any} */
function applyText(text, x, y, action) {
  const parent = this.__closestGroupOrSvg(), [, weight, size, family] = this.font.match(/^(?:(bold) )?([\d.]+px) (.+)$/);
  const drawn = this.__createElement("text", {"font-family": family, "font-size": size, "font-weight": weight || "normal", x, y,
    "text-anchor": {center: "middle", right: "end"}[this.textAlign] || "start",
    "dominant-baseline": {middle: "central", top: "hanging", bottom: "text-after-edge"}[this.textBaseline] || "alphabetic"}, true);
  drawn.append(text);
  this.__currentElement = drawn;
  this.__applyTransformation(drawn);
  this.__applyStyleToCurrentElement(action);
  parent.append(drawn);
}

// PNG and SVG buttons; `canvasOf` returns the canvas, `sizeOf` the size of the SVG.
function saveButtons(label, draw, canvasOf, sizeOf) {
  const name = fileName(label);
  return [button("PNG", () => canvasOf().toBlob(blob => download(name + ".png", blob)), {class: "small", "aria-label": "save as PNG: " + label}),
    button("SVG", () => {
      const {width, height} = sizeOf();
      download(name + ".svg", svgOf(draw, width, height), "image/svg+xml");
    }, {class: "small", "aria-label": "save as SVG: " + label})];
}

// Save buttons for a drawing that is not on the page.
export const offscreenButtons = (label, draw, {width, height}) => saveButtons(label, draw, () => {
  const canvas = element("canvas", {width: 2 * width, height: 2 * height}), context = contextOf(canvas);
  context.scale(2, 2);
  context.font = font;
  draw(context, width, height);
  return canvas;
}, () => ({width, height}));

onNewFigure((frame, {draw, label}) => {
  const canvas = /** @type {HTMLCanvasElement} */ (frame.querySelector("canvas"));
  frame.append(element("div", {class: "save"}, ...saveButtons(label, draw, () => canvas,
    () => ({width: frame.clientWidth, height: parseFloat(canvas.style.height)}))));
});
