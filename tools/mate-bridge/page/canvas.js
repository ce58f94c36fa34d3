// What is drawn as in the report, and saving it.
import {figure as drawn} from "../../../src/modules/report/page/shared/figure.js";
import {download} from "./elements.js";

export {colours, readColours} from "../../../src/modules/report/page/shared/figure.js";
export * from "../../../src/modules/report/page/shared/axes.js";
export * from "../../../src/modules/report/page/shared/plots.js";

export function figure(options) {
  const frame = drawn(options);
  frame.save = name => frame.querySelector("canvas").toBlob(blob => download(name, blob));
  return frame;
}
