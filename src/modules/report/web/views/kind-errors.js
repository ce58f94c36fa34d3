// A ladder of errors for every kind of measurement, in its own unit.
import {element} from "naocal/lib/dom.js";
import {errorLadder} from "naocal/plots/error-ladder.js";

/** @import {View} from "naocal/lib/types.js" */

/** @type {View} */
export const view = {
  place: 5, title: "Errors by kind of measurement", about: "candidates",
  show: ({kinds}) => kinds?.length ? [
    element("p", {}, "The same models, each kind of measurement in its own unit: rms of the distance or angle between measured and predicted, joint readings as they are. " +
      (kinds.some(({rungs}) => rungs.some(({heldOut}) => heldOut !== null)) ? "Full bars: poses that the fit has not seen; dashed: " : "Of ") +
      "the captures that were fitted. Grey: what the noise of the readings alone would leave."),
    element("div", {class: "grid"}, ...kinds.map(({title, unit, noise, rungs}) => element("div", {}, element("h3", {}, title + " [" + unit + "]"),
      errorLadder(rungs.filter(({rms}) => rms !== null).map(({name, rms, heldOut}) => ({name, rms: rms ?? 0, heldOut, floor: noise, alarm: null})), {unit, floorName: "noise of readings"}))))] : null,
};
