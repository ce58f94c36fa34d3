// How often readings are off by how many standard deviations of their noise, beside what noise alone gives.
import {bold} from "naocal/lib/dom.js";
import {captioned, colours} from "naocal/lib/figure.js";
import {axes} from "naocal/lib/axes.js";
import {percent, short} from "naocal/lib/format.js";
import {quantile, rms} from "naocal/lib/statistics.js";

/** @import {ReadingSeries} from "naocal/lib/types.js" */

const leastReach = 5, mostReach = 20; // standard deviations; what lies beyond is counted at the ends

/** @param {number} z */
const density = z => Math.exp(-z * z / 2) / Math.sqrt(2 * Math.PI);

/** Joint readings are moved within their noise, so that only the instrument's is left. @param {ReadingSeries} series */
export const readingHistogram = ({points, sigma, title}) =>
  captioned({height: 250, label: "errors against noise: " + title, draw: (context, width, height, caption) => {
    const errors = points.flatMap(reading => reading.fitted.map(value => value / sigma)), wide = errors.length > 150 ? 0.5 : 1;
    const reach = Math.max(leastReach, Math.min(mostReach, Math.ceil(quantile(errors.map(Math.abs), 0.99))));
    const bars = Array.from({length: 2 * reach / wide}, () => 0);
    for (const error of errors) ++bars[Math.max(0, Math.min(bars.length - 1, Math.floor((error + reach) / wide)))];
    const heights = bars.map(count => count / errors.length / wide), highest = 1.1 * Math.max(density(0), ...heights);
    const box = {left: 50, right: width - 10, top: 30, bottom: height - 42};
    const {x, y} = axes(context, box, [-reach, reach], [0, highest], {title: "share per sigma", xLabel: "error per axis in standard deviations of the noise"});
    context.fillStyle = colours.blue;
    context.globalAlpha = 0.55;
    heights.forEach((value, i) => context.fillRect(x(i * wide - reach) + 0.5, y(value), x(wide) - x(0) - 1, box.bottom - y(value)));
    context.globalAlpha = 1;
    context.strokeStyle = colours.orange;
    context.lineWidth = 2;
    context.beginPath();
    for (let z = -reach; z <= reach; z += 0.1) context.lineTo(x(z), y(density(z)));
    context.stroke();
    const far = errors.filter(error => Math.abs(error) > 2).length / errors.length;
    caption.replaceChildren(bold(title), ": " + short(rms(errors)) + " times the noise (rms per axis); " + percent(far) + " lie beyond two standard deviations, of noise alone 5 %");
    return bars.map((count, i) => ({x: x((i + 0.5) * wide - reach), y: y(heights[i] / 2), tip: () => count + " of " + errors.length + (i === 0 ? " at " + -(reach - wide) + " sigma and below"
      : i === bars.length - 1 ? " at " + (reach - wide) + " sigma and above" : " between " + (i * wide - reach) + " and " + ((i + 1) * wide - reach) + " sigma")}));
  }});
