// The plots of all readings that are no corners: a choice of the series, and what belongs to it.
import {choosing, element} from "naocal/lib/dom.js";
import {readingArrows} from "naocal/plots/reading-arrows.js";
import {readingDots} from "naocal/plots/reading-dots.js";
import {readingHistogram} from "naocal/plots/reading-histogram.js";

/** @import {ReadingSeries} from "naocal/lib/types.js" */
/** @import {ReadingTools} from "naocal/lib/readings.js" */

/** @param {ReadingSeries[]} series @param {string} id of the choice @param {(one: ReadingSeries) => Node} show */
const bySeries = (series, id, show) => choosing(id, "Readings", series.map(({title}) => ({value: title, text: title})),
  title => show(series.find(one => one.title === title) ?? series[0]));

/** @param {ReadingSeries[]} series @param {string} id @param {ReadingTools} tools */
export const dotsOfReadings = (series, id, tools) => bySeries(series, id, one => readingDots(one, tools));

/** @param {ReadingSeries[]} series */
export const histogramsOfReadings = series => element("div", {class: "grid"}, ...series.map(readingHistogram));

/** Of lengths alone. @param {ReadingSeries[]} series @param {string} id @param {ReadingTools} tools */
export const arrowsOfReadings = (series, id, tools) => bySeries(series.filter(({isPlace}) => isPlace), id, one => readingArrows(one, tools));

export const dotsWords = "Errors of what trackers and contacts measured, one dot per reading and axis of the world. Good: dots fill the band and have no pattern. " +
  "Suspicious: a drift or a step (something moved or warms up), one capture far out (a bad reading), or one marker unlike the others.";
export const histogramWords = "How often a reading is off by how much, in standard deviations of its noise; the orange curve is noise alone. Joint readings are " +
  "moved within their own noise. Wider than the curve: a cause is missing, or the noise is larger than the set says. Narrower: the noise is smaller than said.";
export const arrowsWords = "Each reading where it lies in the world of this fit. Good: short arrows in all directions. Suspicious: arrows of a region that point one way, " +
  "or that turn around a joint.";
