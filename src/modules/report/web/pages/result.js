// Entry point of the result page.
import {at, choosing, element} from "naocal/lib/dom.js";
import {redrawAll} from "naocal/lib/figure.js";
import {direction} from "naocal/lib/format.js";
import {binnedMeans, extent, groupBy, quantile, trendStrength} from "naocal/lib/statistics.js";
import {boardViews, captureTimes, cornersOf, meanErrorOf, pictureNames} from "naocal/lib/captures.js";
import {doubtfulBelow} from "naocal/plots/corners.js";
import {errorGroups} from "naocal/plots/error-groups.js";
import {estimates, titleOf} from "naocal/plots/estimates.js";
import {residualField} from "naocal/views/residual-field.js";
import {residualScatter} from "naocal/plots/residual-scatter.js";
import {readData, showContents, showHead} from "naocal/pages/head.js";
import {showPictures} from "naocal/pages/pictures.js";

/** @import {Layer, Picture, Result} from "naocal/lib/types.js" */

/** @type {Result} */
const data = readData();
const nameOf = pictureNames(data.pictures), times = captureTimes(data.pictures);
const timeOf = (/** @type {Picture} */ picture) => times.get(picture) ?? 0, byTime = [...data.pictures].sort((a, b) => timeOf(a) - timeOf(b));
const severalSets = new Set(data.pictures.map(({set}) => set)).size > 1;
const poseOf = (/** @type {Picture} */ picture) => (severalSets ? picture.set + "/" : "") + picture.pose; // pictures of a pose share its joint errors
const layer = () => /** @type {Layer} */ (at("layer").value);

/** Mean error of each board and picture over a value of the picture; skips pictures without it. @param {(picture: Picture) => number | undefined} valueOf */
function trendPoints(valueOf) {
  return boardViews(data.pictures, layer()).flatMap(({picture, board, corners}) => {
    const x = valueOf(picture), trusted = corners.filter(({weight}) => weight >= doubtfulBelow);
    return x === undefined ? [] : [{x, picture, board, error: meanErrorOf(corners), trusted: trusted.length ? meanErrorOf(trusted) : null}];
  });
}
/** @typedef {ReturnType<typeof trendPoints>} TrendPoints */

/** Binned means to the right (0) or down (1), without doubtful corners. @param {TrendPoints} points @param {0 | 1} side @param {(picture: Picture) => string} groupOf */
const meansOf = (points, side, groupOf) => binnedMeans(points.flatMap(({x, picture, trusted}) => trusted ? [{x, y: trusted[side], picture}] : []),
  {groupOf: ({picture}) => groupOf(picture)});

/** Plots of both error components, side by side. @param {TrendPoints} points @param {{label: string, xLabel: string, groupOf: (picture: Picture) => string}} options */
function trend(points, {label, xLabel, groupOf}) {
  const sides = /** @type {(0 | 1)[]} */ ([0, 1]).map(side => ({side, means: meansOf(points, side, groupOf)}));
  const least = Math.max(quantile(points.flatMap(({error}) => error.map(Math.abs)), 0.98), // common y axis
    ...sides.flatMap(({means}) => means.map(({y, error}) => Math.abs(y) + 2 * error)));
  return element("div", {class: "grid"}, ...sides.map(({side, means}) => residualScatter({
    points: points.map(({x, picture, board, error}) => ({x, y: error[side], picture, tip: () => nameOf(picture) + "\nboard " + board +
      ": mean prediction " + direction(...error) + "\n" + xLabel + ": " + Number(x.toFixed(2))})),
    means, least, xLabel, title: side ? "predicted too far down [px]" : "predicted too far to the right [px]",
  }, {label: label + (side ? ", down" : ", to the right"), open: pictures.open})));
}

/** Joints that moved by more than 1 degree, strongest trend first. */
function movedJoints() {
  const names = new Set(data.pictures.flatMap(({angles}) => Object.keys(angles ?? {})));
  return [...names].map(name => ({name, points: trendPoints(({angles}) => angles?.[name])})).filter(({points}) => {
    const [low, high] = extent(points.map(({x}) => x));
    return high - low > 1;
  }).map(({name, points}) => ({name, strength: Math.max(trendStrength(meansOf(points, 0, poseOf)), trendStrength(meansOf(points, 1, poseOf)))}))
    .sort((a, b) => b.strength - a.strength);
}

function angles() {
  const joints = movedJoints();
  const why = data.missing.length ? "Joint angles are missing: " + data.missing.join("; ") + "." : joints.length ? "" : "No joint moved by more than 1°.";
  return [why ? element("p", {}, why) : "", joints.length ? choosing("joint", "Joint", joints.map(({name}) => ({value: name, text: name})), name =>
    trend(trendPoints(({angles}) => angles?.[name]), {label: "mean errors over a joint's angle", xLabel: name + " [°]", groupOf: poseOf})) : ""];
}

const overTime = () => trend(trendPoints(timeOf), {label: "mean errors over time",
  xLabel: severalSets ? "time [s], sets one after the other" : "time [s]", groupOf: picture => poseOf(picture) + "/" + picture.repeat});

const byPose = () => errorGroups(byTime.map(picture => ({group: poseOf(picture), corners: () => cornersOf(picture, layer()), picture, name: nameOf(picture)})),
  {xLabel: "poses in the order they were first taken", label: "errors by pose", pixelNoise: data.pixelNoise, open: pictures.open});

function byBoard() {
  const members = byTime.flatMap(picture => picture.boards.map(({board}) => ({group: board, picture, name: "board " + board + " in " + nameOf(picture),
    corners: () => cornersOf(picture, layer()).filter(corner => corner.board === board)})));
  return errorGroups(members.sort((a, b) => a.group < b.group ? -1 : a.group > b.group ? 1 : 0),
    {xLabel: "boards", label: "errors by board", pixelNoise: data.pixelNoise, open: pictures.open});
}

const overImage = () => [...groupBy([...data.pictures].sort((a, b) => a.camera < b.camera ? -1 : 1), ({camera}) => camera).values()]
  .map(list => residualField(list, {layer, nameOf, open: pictures.open}));

function weak() {
  if (!data.weak.length) return "";
  return element("div", {}, element("h3", {}, "Weakly determined combinations"), element("ul", {}, ...data.weak.map(({sentence, sigma, unit}) =>
    element("li", {}, sentence + " (" + (unit === "rad" ? "± " + (sigma * 180 / Math.PI).toPrecision(2) + "° along this combination"
      : Math.round(100 * Math.min(1, sigma)) + " % of the prior uncertainty remains along this combination") + ")"))));
}

function aboutPhotographs() {
  const count = data.pictures.length, kept = data.pictures.filter(({photograph}) => photograph).length;
  return kept === count ? "" : kept ? "Photographs of the " + kept + " worst pictures are part of this page."
    : "The frames are empty: " + (data.missing.join("; ") || "no photographs were kept with the captures") + ".";
}

const pictures = showPictures(byTime, {layer, nameOf});
const showTrends = () => {
  at("angles").replaceChildren(...angles());
  at("times").replaceChildren(overTime());
};
at("layer").addEventListener("change", () => { pictures.show(); showTrends(); redrawAll(); });
showHead({...data, sentence: (data.sentence ? data.sentence + " " : "") + "From " + data.sets.join(", ") + "."});
document.title = "NAO " + data.robot + ": " + data.headline;
at("photographs").textContent = aboutPhotographs();
at("estimates").append(...data.groups.flatMap(group => [element("h3", {}, titleOf(group)), estimates(group)]), weak());
at("fields").append(...overImage());
at("poses").append(byPose());
at("boards").append(byBoard());
showTrends();
showContents();
