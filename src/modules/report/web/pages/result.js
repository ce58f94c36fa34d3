// Entry point of the result page.
import {at, choosing, element} from "naocal/lib/dom.js";
import {redrawAll} from "naocal/lib/figure.js";
import {direction, px, sized} from "naocal/lib/format.js";
import {groupBy} from "naocal/lib/statistics.js";
import {boardViews, captureTimes, cornersOf, lengthOf, meanErrorOf, pictureNames} from "naocal/lib/captures.js";
import {axisNames, groupsOf, lengthOfError, targetName} from "naocal/lib/readings.js";
import {doubtfulBelow} from "naocal/plots/corners.js";
import {errorGroups} from "naocal/plots/error-groups.js";
import {estimates, titleOf} from "naocal/plots/estimates.js";
import {componentTitle, readingTip} from "naocal/plots/reading-dots.js";
import {arrowsOfReadings, arrowsWords, dotsOfReadings, dotsWords, histogramsOfReadings, histogramWords} from "naocal/plots/reading-sections.js";
import {residualField} from "naocal/views/residual-field.js";
import {readData, showContents, showHead} from "naocal/pages/head.js";
import {showPictures} from "naocal/pages/pictures.js";
import {movedJoints, trend} from "naocal/pages/trends.js";

/** @import {Layer, Picture, ReadCapture, ReadingSeries, Result} from "naocal/lib/types.js" */
/** @import {ErrorKind} from "naocal/pages/trends.js" */

/** @type {Result} */
const data = readData();
/** @type {ReadCapture[]} */
const captures = [...data.pictures, ...data.captures];
const nameOf = pictureNames(captures), times = captureTimes(captures);
const timeOf = (/** @type {ReadCapture} */ capture) => times.get(capture) ?? 0, byTime = [...data.pictures].sort((a, b) => timeOf(a) - timeOf(b));
const severalSets = new Set(captures.map(({set}) => set)).size > 1;
const poseOf = (/** @type {ReadCapture} */ capture) => (severalSets ? capture.set + "/" : "") + capture.pose; // captures of a pose share its joint errors
const layer = () => /** @type {Layer} */ (at("layer").value);

/** Mean error of each board and picture. @type {ErrorKind} */
const cornerErrors = {title: "corners", captures: data.pictures, open: picture => pictures?.open(picture),
  components: [{name: "to the right", title: "predicted too far to the right [px]"}, {name: "down", title: "predicted too far down [px]"}],
  points: valueOf => boardViews(data.pictures, layer()).flatMap(({picture, board, corners}) => {
    const x = valueOf(picture), trusted = corners.filter(({weight}) => weight >= doubtfulBelow), error = meanErrorOf(corners);
    return x === undefined ? [] : [{x, capture: picture, error, trusted: trusted.length ? meanErrorOf(trusted) : null,
      tip: () => nameOf(picture) + "\nboard " + board + ": mean prediction " + direction(...error)}];
  })};

const keyOf = (/** @type {ReadCapture} */ {set, capture}) => set + "\n" + capture;
const placeOf = new Map([...new Set([...data.captures].sort((a, b) => timeOf(a) - timeOf(b) || a.capture - b.capture).map(keyOf))].map((key, place) => [key, place + 1]));
/** @type {import("naocal/lib/readings.js").ReadingTools} */
const readingTools = {layer, nameOf: ({of}) => nameOf(data.captures[of]), orderOf: ({of}) => placeOf.get(keyOf(data.captures[of])) ?? 0};

/** @param {ReadingSeries} series @returns {ErrorKind} */
const readingErrors = series => ({title: series.title, captures: data.captures,
  components: axisNames.map(name => ({name: (series.isPlace ? "along " : "about ") + name, title: componentTitle(series, name)})),
  points: valueOf => series.points.flatMap(reading => {
    const capture = data.captures[reading.of], x = valueOf(capture), error = reading[layer()];
    return x === undefined ? [] : [{x, capture, error, trusted: error, tip: () => readingTip(reading, series, readingTools)}];
  })});

const kinds = [...(data.pictures.length ? [cornerErrors] : []), ...data.readings.map(readingErrors)];

/** A choice of the kind of errors, where there are several. @param {string} id @param {(kind: ErrorKind) => Node} show */
const byKind = (id, show) => choosing(id, "Errors of", kinds.map(({title}) => ({value: title, text: title})), title => show(kinds.find(kind => kind.title === title) ?? kinds[0]));

function angles() {
  const why = data.missing.length ? "Joint angles are missing: " + data.missing.join("; ") + "." : "";
  return [why ? element("p", {}, why) : "", byKind("anglesOf", kind => {
    const joints = movedJoints(kind, poseOf);
    if (!joints.length) return why ? element("span") : element("p", {}, "No joint moved by more than 1° or 1 mm.");
    return choosing("joint", "Joint", joints.map(({name}) => ({value: name, text: name})), name => trend(kind, kind.points(({angles}) => angles?.[name]),
      {label: "mean errors over a joint's angle", xLabel: name + " [" + (data.jointUnits[name] ?? "°") + "]", groupOf: poseOf}), joints[0].name);
  })];
}

const overTime = () => byKind("timesOf", kind => trend(kind, kind.points(timeOf), {label: "mean errors over time",
  xLabel: severalSets ? "time [s], sets one after the other" : "time [s]", groupOf: capture => poseOf(capture) + "/" + capture.repeat}));

const cornerMember = (/** @type {string} */ group, /** @type {Picture} */ picture, /** @type {string} */ name, board = "") => ({group, picture, name,
  lengths: () => cornersOf(picture, layer()).filter(corner => !board || corner.board === board).map(lengthOf)});
const cornerGroups = {title: "rms error [px]", noise: Math.SQRT2 * data.pixelNoise, noiseName: "corner noise alone", words: px, open: cornerErrors.open};

const byPose = () => errorGroups(byTime.map(picture => cornerMember(poseOf(picture), picture, nameOf(picture))),
  {...cornerGroups, xLabel: "poses in the order they were first taken", label: "errors by pose"});

function byBoard() {
  const members = byTime.flatMap(picture => picture.boards.map(({board}) => cornerMember(board, picture, "board " + board + " in " + nameOf(picture), board)));
  return errorGroups(members.sort((a, b) => a.group < b.group ? -1 : a.group > b.group ? 1 : 0), {...cornerGroups, xLabel: "boards", label: "errors by board"});
}

/** @param {ReadingSeries} series */
function byMarker({points, unit, sigma, title}) {
  const members = [...groupsOf(points)].flatMap(([group, list]) => list.map(reading => ({group: String(group), picture: undefined,
    name: targetName(reading) + ", " + nameOf(data.captures[reading.of]), lengths: () => [lengthOfError(reading, layer())]})));
  return element("div", {}, element("h3", {}, title), errorGroups(members, {title: "error [" + unit + "]", noise: Math.sqrt(3) * sigma, noiseName: "noise of readings alone",
    words: value => sized(value, unit), xLabel: points.some(({place}) => place) ? "places" : "markers and frames", label: "errors by marker: " + title}));
}

const overImage = () => [...groupBy([...data.pictures].sort((a, b) => a.camera < b.camera ? -1 : 1), ({camera}) => camera).values()]
  .map(list => residualField(list, {layer, nameOf, open: cornerErrors.open}));

function aboutPhotographs() {
  const count = data.pictures.length, kept = data.pictures.filter(({photograph}) => photograph).length;
  return kept === count ? "" : kept ? "Photographs of the " + kept + " worst pictures are part of this page."
    : "The frames are empty: " + (data.missing.join("; ") || "no photographs were kept with the captures") + ".";
}

const showTrends = () => {
  at("angles").replaceChildren(...angles());
  at("times").replaceChildren(overTime());
};

for (const part of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("[data-of]"))) {
  part.hidden = !data[/** @type {"pictures" | "readings"} */ (part.dataset.of)].length;
}
const pictures = data.pictures.length ? showPictures(byTime, {layer, nameOf}) : null;
at("layer").addEventListener("change", () => { pictures?.show(); showTrends(); redrawAll(); });
showHead({...data, sentence: (data.sentence ? data.sentence + " " : "") + "From " + data.sets.join(", ") + "."});
document.title = data.robot + ": " + data.headline;
at("estimates").append(...data.groups.flatMap(group => [element("h3", {}, titleOf(group)), estimates(group)]));
if (data.pictures.length) {
  at("photographs").textContent = aboutPhotographs();
  at("fields").append(...overImage());
  at("poses").append(byPose());
  at("boards").append(byBoard());
}
if (data.readings.length) {
  at("dotsWords").textContent = dotsWords;
  at("arrowsWords").textContent = arrowsWords;
  at("histogramWords").textContent = histogramWords;
  at("readingDots").append(dotsOfReadings(data.readings, "dotsOf", readingTools));
  at("readingArrows").append(arrowsOfReadings(data.readings, "arrowsOf", readingTools));
  at("readingHistograms").append(histogramsOfReadings(data.readings));
  at("readingGroups").append(...data.readings.map(byMarker));
}
showTrends();
showContents();
