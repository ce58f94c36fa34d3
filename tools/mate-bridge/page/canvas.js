// What is drawn as in the report, and saving it.
import {Context} from "svgcanvas";
import {figure as drawn, font} from "../../../src/modules/report/page/shared/figure.js";
import {button, download, make} from "./elements.js";

export {colours, readColours} from "../../../src/modules/report/page/shared/figure.js";
export * from "../../../src/modules/report/page/shared/axes.js";
export * from "../../../src/modules/report/page/shared/plots.js";

const fileName = label => label.toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "").slice(0, 60);

// As SVG: drawn once more, by what writes down each stroke.
export function svgOf(draw, width, height) {
  const context = new Context({width, height, document});
  context.isVector = true;
  context.font = font;
  context.__applyText = applyText;
  draw(context, width, height);
  return context.getSerializedSvg();
}

// In place of svgcanvas's own, which reads the font out of an inline style: the page's rules forbid those.
function applyText(text, x, y, action) {
  const parent = this.__closestGroupOrSvg(), [, weight, size, family] = this.font.match(/^(?:(bold) )?([\d.]+px) (.+)$/);
  const element = this.__createElement("text", {"font-family": family, "font-size": size, "font-weight": weight || "normal", x, y,
    "text-anchor": {center: "middle", right: "end"}[this.textAlign] || "start",
    "dominant-baseline": {middle: "central", top: "hanging", bottom: "text-after-edge"}[this.textBaseline] || "alphabetic"}, true);
  element.append(text);
  this.__currentElement = element;
  this.__applyTransformation(element);
  this.__applyStyleToCurrentElement(action);
  parent.append(element);
}

export function figure(options) {
  const frame = drawn(options), {draw, label} = options, name = fileName(label);
  frame.append(make("div", {class: "save"},
    button("PNG", () => frame.querySelector("canvas").toBlob(blob => download(name + ".png", blob)), {class: "small", "aria-label": "save as PNG: " + label}),
    button("SVG", () => {
      const canvas = frame.querySelector("canvas");
      download(name + ".svg", svgOf(draw, frame.clientWidth, parseFloat(canvas.style.height)), "image/svg+xml");
    }, {class: "small", "aria-label": "save as SVG: " + label})));
  return frame;
}
