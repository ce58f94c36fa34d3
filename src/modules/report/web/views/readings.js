// Readings of trackers and contacts that a model of the diagnosis leaves off.
import {element} from "naocal/lib/dom.js";
import {captureNames, orderOfTaking} from "naocal/lib/captures.js";
import {arrowsOfReadings, arrowsWords, dotsOfReadings, dotsWords, histogramsOfReadings, histogramWords} from "naocal/plots/reading-sections.js";
import {modelChoice} from "naocal/views/model-choice.js";

/** @import {Diagnosis, Layer, Reading, View, ViewTools} from "naocal/lib/types.js" */

/** @param {Diagnosis} data @param {ViewTools} tools @returns {import("naocal/lib/readings.js").ReadingTools} */
function toolsOf(data, {open}) {
  const {captureName} = captureNames(data);
  const places = orderOfTaking(data.pictures.map(({pose, capture}) => ({set: data.poses[pose].set, capture})));
  return {layer: () => /** @type {Layer} */ ("reported"), nameOf: ({of}) => captureName(of), orderOf: ({of}) => places[of],
    pictureOf: (/** @type {Reading} */ {of}) => of, open};
}

/** @type {View} */
export const view = {
  place: 62, title: "Readings", about: "misfit",
  show: (data, tools) => data.left.asGiven?.readings?.length ? [
    element("p", {}, dotsWords + " Joint readings are taken as they are."),
    modelChoice("readingsBy", data, ({readings}) => {
      const drawn = toolsOf(data, tools);
      return element("div", {}, dotsOfReadings(readings, "readingSeries", drawn), element("p", {class: "soft"}, arrowsWords), arrowsOfReadings(readings, "arrowSeries", drawn),
        element("p", {class: "soft"}, histogramWords), histogramsOfReadings(readings));
    })] : null,
};
