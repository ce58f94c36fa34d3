// Compare view: what the search found, with the picture of its cause; the raw errors over any recorded quantity, the
// selected capture or all readings in space, and all pictures, worst first.
import {button, choice, csv, download, element, renew} from "naocal/lib/dom.js";
import {px} from "naocal/lib/format.js";
import {axisNames} from "naocal/lib/readings.js";
import {readingArrows} from "naocal/plots/reading-arrows.js";
import {arrowsWords, dotsOfReadings, dotsWords, histogramsOfReadings, histogramWords} from "naocal/plots/reading-sections.js";
import {on} from "../core/connection.js";
import {act, state} from "../core/state.js";
import {causePlots, finding} from "./finding.js";
import {cornersOf, errorOf, pictureFigure} from "./pictures.js";
import {horizontals, isChosen, readingTools, scatterFigure, verticals} from "./residual-scatter.js";

const perPage = 6;
const shown = {horizontal: "u", vertical: "du", isChosen: false, camera: "", first: 0, order: "worst"};
on("opened", () => Object.assign(shown, {isChosen: false, camera: "", first: 0}));

// Until other axes are chosen, or a cause was found, and then for every model of the set: errors over what drives the cause; as taken where something is wrong with captures; else
// over their place.
function lookAtCause({drivers, pictures}) {
  const {causes, verdict} = state.diagnosis ?? {}, driver = drivers.findIndex(({what}) => what === causes?.[0]?.over);
  Object.assign(shown, {vertical: pictures.length ? "dv" : "reading0x",
    horizontal: driver >= 0 ? "driver" + driver : pictures.length && verdict !== "bad-captures" ? "u" : "capture"});
}

export function showCompare(parent) {
  const {fit} = state;
  if (!shown.isChosen) lookAtCause(fit);
  shown.isChosen ||= Boolean(state.diagnosis);
  const errors = verticals(fit), vertical = errors.find(({value}) => value === shown.vertical) || errors[0];
  const options = horizontals(fit, vertical), horizontal = options.find(({value}) => value === shown.horizontal) || options[0];
  const again = () => showCompare(parent), choose = change => { Object.assign(shown, change, {isChosen: true}); again(); };
  const pictures = [...fit.pictures].sort((a, b) => shown.order === "worst" ? errorOf(b) - errorOf(a) : a.time - b.time || a.capture - b.capture);
  const chosen = pictures.find(isChosen) || pictures[0], choosePicture = picture => { state.chosen = picture; again(); };
  const cameras = [...new Set(fit.pictures.map(({camera}) => camera))];
  const scatter = scatterFigure({fit, horizontal, vertical, camera: shown.camera, choose: choosePicture});
  renew(parent,
    element("h1", {}, "Where the prediction fails"),
    finding("h2"), causePlots(choosePicture),
    element("h2", {}, "Raw errors"),
    element("p", {class: "soft"}, (vertical.joint ? "Each point is one reading of the joint: the error that would explain its pictures. "
      : vertical.series ? "Each point is a reading: predicted minus measured. " : "Each point is a corner: predicted minus measured. ") + "Orange squares: means with two standard errors, each pose counted once. Good: squares stay at zero. " +
      "Click a point to see its capture."),
    element("div", {class: "controls"},
      choice("Error", errors, vertical.value, value => choose({vertical: value}), "errorY"),
      choice("over", options, horizontal.value, value => choose({horizontal: value}), "overX"),
      cameras.length > 1 && !vertical.series ? choice("camera", [{value: "", text: cameras.length > 2 ? "all" : "both"}, ...cameras.map(value => ({value, text: value}))], shown.camera,
        value => { shown.camera = value; again(); }, "ofCamera") : null,
      vertical.joint ? null : choice("joints", [{value: "reported", text: "as reported by the encoders"}, {value: "fitted", text: "moved within their noise"}],
        state.layer, value => { state.layer = /** @type {import("naocal/lib/types.js").Layer} */ (value); again(); }, "layer"),
      button("CSV", () => vertical.series ? saveReadings(fit) : saveCorners(fit), {class: "small"})),
    ...beside(fit, vertical, scatter, chosen, choosePicture),
    ...readingParts(fit, choosePicture),
    ...(pictures.length ? [element("h2", {}, "Captures"), ...captures(pictures, again)] : []));
}

// The scatter beside the chosen picture; or above the readings in space, which need the room.
function beside(fit, {series}, scatter, chosen, open) {
  const inSpace = series ? (series.isPlace ? series : null) : chosen ? null : fit.readings.find(({isPlace}) => isPlace);
  if (!inSpace && chosen) return [element("div", {class: "split"}, scatter, element("div", {}, pictureFigure(chosen)))];
  return [scatter, inSpace ? readingArrows(inSpace, {...readingTools(fit), open}) : null];
}

function readingParts(fit, open) {
  if (!fit.readings.length) return [];
  return [element("h2", {}, "Readings"), element("p", {class: "soft"}, dotsWords + " " + arrowsWords), dotsOfReadings(fit.readings, "readingDots", {...readingTools(fit), open}),
    element("h2", {}, "Against the noise"), element("p", {class: "soft"}, histogramWords), histogramsOfReadings(fit.readings)];
}

const groupOf = picture => [picture.set, picture.pose || picture.capture, picture.camera].join("\n");

// Pictures grouped by pose and camera.
function byPose(pictures) {
  const groups = new Map();
  for (const picture of pictures) {
    const key = groupOf(picture);
    groups.set(key, [...(groups.get(key) || []), picture]);
  }
  return [...groups.values()];
}

function captures(pictures, again) {
  const groups = byPose(pictures);
  return [pager(groups, again),
    pictures.some(({kept}) => kept) ? null : element("p", {class: "soft"}, "These captures have no photographs: only the corners found in them are drawn."),
    element("div", {class: "grid"}, ...groups.slice(shown.first, shown.first + perPage).map(group => grouped(group, again)))];
}

// The picture last selected of each group stays in front.
const inFront = new Map(); // by group: index of the front picture
function grouped(group, again) {
  const key = groupOf(group[0]);
  const front = Math.min(inFront.get(key) || 0, group.length - 1), figure = pictureFigure(group[front]);
  if (group.length > 1) {
    figure.append(element("div", {class: "controls repeats"}, element("span", {class: "soft"}, "captures of this pose:"),
      ...group.map((picture, i) => button(String(picture.capture), () => { inFront.set(key, i); again(); },
        {class: "small", "aria-pressed": String(i === front), "aria-label": "show capture " + picture.capture, title: px(errorOf(picture)) + " rms"}))));
  }
  figure.append(leavingOut(group[front]));
  return figure;
}

// Calibrates without this capture, its pose or one of its boards; as a step of the model, which Undo takes back.
function leavingOut({set, capture, pose, boards}) {
  const several = new Set(state.fit.pictures.map(picture => picture.set)).size > 1, of = several ? set + "/" : "";
  const leave = (what, name) => button(what + " " + name, () => act({do: "add", labels: ["leftOut@" + what + ":" + of + name]}), {class: "small", "aria-label": "leave out " + what + " " + name});
  return element("div", {class: "controls repeats"}, element("span", {class: "soft"}, "leave out:"), leave("capture", capture), pose ? leave("pose", pose) : null,
    ...boards.map(({board}) => leave("board", board.split("/").at(-1))));
}

function pager(groups, again) {
  shown.first = Math.min(shown.first, Math.max(0, groups.length - 1));
  const turn = pages => () => { shown.first = Math.max(0, shown.first + pages * perPage); again(); };
  return element("div", {class: "controls"},
    choice("Order", [{value: "worst", text: "worst first"}, {value: "time", text: "as taken"}], shown.order,
      value => { shown.order = value; shown.first = 0; again(); }, "order"),
    button("‹", turn(-1), {disabled: shown.first === 0, id: "previous", "aria-label": "captures before"}),
    element("span", {}, shown.first + 1 + "–" + Math.min(shown.first + perPage, groups.length) + " of " + groups.length),
    button("›", turn(1), {disabled: shown.first + perPage >= groups.length, id: "next", "aria-label": "captures after"}),
    element("span", {class: "keys soft"}, element("span", {class: "key measured"}), " measured ", element("span", {class: "key predicted"}), " predicted ",
      element("span", {class: "key doubtful"}), " doubtful"));
}

function saveReadings(fit) {
  const rows = [["set", "capture", "pose", "readings", "of", "place", ...axisNames.map(name => name + " [m]"), ...axisNames.map(name => "error " + name), "unit"]];
  for (const {title, unit, points} of fit.readings) {
    for (const reading of points) {
      const {set, capture, pose} = fit.captures[reading.of];
      rows.push([set, capture, pose, title, reading.target, reading.place, ...reading.at, ...reading[state.layer], unit]);
    }
  }
  download("readings.csv", csv(rows), "text/csv");
}

function saveCorners(fit) {
  const rows = [["set", "capture", "pose", "camera", "board", "corner", "u [px]", "v [px]", "error right [px]", "error down [px]", "weight"]];
  for (const picture of fit.pictures) {
    for (const {id, board, u, v, du, dv, weight} of cornersOf(picture)) {
      rows.push([picture.set, picture.capture, picture.pose, picture.camera, board, id, u, v, du, dv, weight]);
    }
  }
  download("residuals.csv", csv(rows), "text/csv");
}
