// Readings of trackers and contacts: sizes, groups and colours.
import {groupBy, rms} from "naocal/lib/statistics.js";

/** @import {Layer, Reading} from "naocal/lib/types.js" */

/** How the readings of a series are drawn: which errors, their captures' order and names, and what a click does.
 * @typedef {object} ReadingTools
 * @property {() => Layer} layer
 * @property {(reading: Reading) => string} nameOf
 * @property {(reading: Reading) => number} orderOf place on an axis of captures
 * @property {(reading: Reading) => any} [pictureOf] what a click opens
 * @property {(picture: any) => void} [open]
 * @property {(reading: Reading) => boolean} [isChosen] readings to emphasise
 * @property {(name: string, factor: number) => number} [steady] the factor by which errors were enlarged before
 */

export const axisNames = ["x", "y", "z"];

/** @param {Reading} reading @param {Layer} layer */
export const lengthOfError = (reading, layer) => Math.hypot(...reading[layer]);

/** RMS length of the error vectors. @param {Reading[]} readings @param {Layer} layer */
export const rmsOf = (readings, layer) => rms(readings.map(reading => lengthOfError(reading, layer)));

/** The marker or frame, or what touched which place. @param {Reading} reading */
export const targetName = ({target, place}) => place ? target + " at " + place : target;

/** Marker or frame of each reading; the place, if one marker touches several. @param {Reading[]} readings */
export function groupsOf(readings) {
  const targets = groupBy(readings, ({target}) => target);
  return targets.size > 1 || !readings[0]?.place ? targets : groupBy(readings, ({place}) => place);
}

const tones = ["blue", "orange", "pink", "good"];

/** A colour per group while there are no more groups than colours; else one for all. @param {Reading[]} readings @returns {Map<string, string>} by group's name */
export function tonesOf(readings) {
  const names = [...groupsOf(readings).keys()].map(String);
  return new Map(names.map((name, i) => [name, names.length > tones.length ? tones[0] : tones[i]]));
}
