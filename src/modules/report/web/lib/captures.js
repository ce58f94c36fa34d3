// Captures: names, corners and capture times of their pictures.
import {groupBy, mean, rms, extent} from "naocal/lib/statistics.js";

/** @import {CaptureName, Picture, Corner, Layer, Taken} from "naocal/lib/types.js" */

/** "capture 17, pose P05 (repeat 1), top camera" @param {CaptureName} picture */
export const pictureName = ({capture, pose, repeat, camera}) =>
  "capture " + capture + (pose ? ", pose " + pose : "") + (repeat ? " (repeat " + repeat + ")" : "") + (camera ? ", " + camera + " camera" : "");

/** Prefixed with the set name if there are several sets. @param {CaptureName[]} pictures @returns {(picture: CaptureName) => string} */
export function pictureNames(pictures) {
  const severalSets = new Set(pictures.map(({set}) => set)).size > 1;
  return picture => (severalSets ? picture.set + ", " : "") + pictureName(picture);
}

/** Names of the poses and captures of a diagnosis. @param {Taken} taken */
export function captureNames({poses, pictures}) {
  const severalSets = new Set(poses.map(({set}) => set)).size > 1;
  const poseName = (/** @type {number} */ pose) => (severalSets ? poses[pose].set + ", " : "") + "pose " + poses[pose].name;
  /** "pose P05\ncaptures 12 (top), 13 (bottom)" of some pictures of one pose @param {number[]} some */
  const capturesName = some => poseName(pictures[some[0]].pose) + "\ncaptures " + some.map(picture =>
    pictures[picture].capture + (pictures[picture].camera ? " (" + pictures[picture].camera + ")" : "")).join(", ");
  return {
    poseName,
    /** The same of all of its pictures. @param {number} pose */
    poseTip: pose => capturesName(poses[pose].pictures),
    capturesName,
    /** "capture 12, pose P05" @param {number} picture */
    captureName: picture => "capture " + pictures[picture].capture + ", " + poseName(pictures[picture].pose),
  };
}

/**
 * The place of each in the order of taking, from 1; sets follow each other, for captures are numbered within their set.
 * @param {{set: string, capture: number}[]} taken
 * @returns {number[]}
 */
export function orderOfTaking(taken) {
  const sets = [...new Set(taken.map(({set}) => set))];
  const sorted = taken.map(({set, capture}, i) => ({set: sets.indexOf(set), capture, i})).sort((a, b) => a.set - b.set || a.capture - b.capture);
  /** @type {number[]} */
  const places = [];
  let place = 0;
  sorted.forEach((one, at) => {
    const before = sorted[at - 1];
    if (!before || before.set !== one.set || before.capture !== one.capture) ++place;
    places[one.i] = place;
  });
  return places;
}

/** Cache: corners and rms error of each picture, by layer. @type {WeakMap<Picture, Record<string, {corners: Corner[], error: number}>>} */
const known = new WeakMap();

/** @param {Picture} picture @param {Layer} layer */
function lookUp(picture, layer) {
  const layers = known.get(picture) ?? {};
  known.set(picture, layers);
  if (!layers[layer]) {
    const corners = picture.boards.flatMap(board => board.ids.map((id, i) => ({
      id, board: board.board, picture, u: board.measured[2 * i], v: board.measured[2 * i + 1],
      du: board[layer][2 * i], dv: board[layer][2 * i + 1], weight: board.weight ? board.weight[i] : 1,
    })));
    layers[layer] = {corners, error: errorOf(corners)};
  }
  return layers[layer];
}

/** The corners in a picture. @param {Picture} picture @param {Layer} layer */
export const cornersOf = (picture, layer) => lookUp(picture, layer).corners;

/** RMS error of a picture's corners [px]. @param {Picture} picture @param {Layer} layer */
export const pictureError = (picture, layer) => lookUp(picture, layer).error;

/** @param {Corner} corner */
export const lengthOf = ({du, dv}) => Math.hypot(du, dv);

/** RMS length of the error vectors [px]. @param {Corner[]} corners */
export const errorOf = corners => rms(corners.map(lengthOf));

/** Mean error vector, right and down [px]. @param {Corner[]} corners @returns {[number, number]} */
export const meanErrorOf = corners => [mean(corners.map(({du}) => du)), mean(corners.map(({dv}) => dv))];

/** One entry per board and picture. @param {Picture[]} pictures @param {Layer} layer */
export const boardViews = (pictures, layer) => pictures.flatMap(picture =>
  [...groupBy(cornersOf(picture, layer), ({board}) => board)].map(([board, corners]) => ({picture, board: String(board), corners})));

/**
 * Capture time of each picture [s]; sets follow each other with a gap.
 * @template {CaptureName} P
 * @param {P[]} pictures
 * @returns {Map<P, number>}
 */
export function captureTimes(pictures) {
  const times = new Map();
  let start = 0;
  for (const own of groupBy(pictures, ({set}) => set).values()) {
    const [first, last] = extent(own.map(({time}) => time));
    own.forEach(picture => times.set(picture, start + picture.time - first));
    start += 1.05 * (last - first) + 1;
  }
  return times;
}
