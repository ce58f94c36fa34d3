// Compare: where the prediction fails. Residuals over anything, the chosen capture beside them, all pictures worst first.
import {make, button, choice, csv, download, renew} from "./elements.js";
import {on} from "./connection.js";
import {state} from "./state.js";
import {pictureFigure, pictureRms, cornersOf} from "./pictures.js";
import {scatterFigure, horizontals, verticals, isChosen} from "./scatter.js";
import {px} from "./words.js";

const perPage = 6;
const shown = {horizontal: "u", vertical: "du", isChosen: false, camera: "", first: 0, order: "worst"};
on("opened", () => Object.assign(shown, {isChosen: false, camera: "", first: 0}));

const isShown = ({error, over}) => shown.vertical === error && shown.horizontal === over;
const look = ({error, over}) => Object.assign(shown, {vertical: error, horizontal: over});

export function showCompare(parent) {
  const {fit} = state, {telling} = fit;
  if (!shown.isChosen) look(telling.pairs[0] || {error: "du", over: "u"});
  const errors = verticals(fit), vertical = errors.find(({value}) => value === shown.vertical) || errors[0];
  const options = horizontals(fit, vertical), horizontal = options.find(({value}) => value === shown.horizontal) || options[0];
  const again = () => showCompare(parent), choose = change => { Object.assign(shown, change, {isChosen: true}); again(); };
  const pictures = [...fit.pictures].sort((a, b) => shown.order === "worst" ? pictureRms(b) - pictureRms(a) : a.time - b.time || a.capture - b.capture);
  const chosen = pictures.find(isChosen) || pictures[0];
  const cameras = [...new Set(fit.pictures.map(({camera}) => camera))];
  const scatter = scatterFigure({fit, horizontal, vertical, camera: shown.camera, choose: picture => { state.chosen = picture; again(); }});
  renew(parent,
    make("h1", {}, "Where the prediction fails"),
    told(telling, choose),
    make("p", {class: "soft"}, (vertical.joint ? "Every point is one reading of the joint: how far it would have to be off to explain its pictures. "
      : "Every point is a corner: predicted minus measured. ") + "Orange squares are means with two standard errors, each pose counted once; good is when they stay at zero " +
      "everywhere. Click a point to see its capture."),
    make("div", {class: "controls"},
      choice("Error", errors, vertical.value, value => choose({vertical: value}), "errorY"),
      choice("over", options, horizontal.value, value => choose({horizontal: value}), "overX"),
      choice("camera", [{value: "", text: "both"}, ...cameras.map(value => ({value, text: value}))], shown.camera,
        value => { shown.camera = value; again(); }, "ofCamera"),
      vertical.joint ? null : choice("joints", [{value: "reported", text: "as their encoders report them"}, {value: "fitted", text: "moved as far as their noise allows"}],
        state.layer, value => { state.layer = value; again(); }, "layer"),
      button("CSV", () => saveCorners(fit), {class: "small"})),
    make("div", {class: "split"}, scatter, make("div", {}, pictureFigure(chosen))),
    make("h2", {}, "Captures"),
    ...captures(pictures, again));
}

// What the library found most telling, and the next ones.
function told({sentence, pairs}, choose) {
  const here = pairs.find(isShown), words = here ? here.sentence : pairs.length ? "Most telling: " + sentence : sentence;
  return make("div", {class: pairs.length ? "telling" : "telling none"}, make("p", {class: "sentence", role: "status"}, words),
    pairs.length ? make("div", {class: "controls chips"}, ...pairs.flatMap((pair, i) => [
      i < 2 ? make("span", {class: "soft"}, i ? "next:" : "Most telling:") : null,
      button(pair.label, () => choose({vertical: pair.error, horizontal: pair.over}), {class: "small", "aria-pressed": String(isShown(pair)), title: pair.sentence}),
    ])) : null);
}

const groupOf = picture => [picture.set, picture.pose || picture.capture, picture.camera].join("\n");

// Pictures of one pose and camera stand for each other: the worst, and how many there are.
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
    pictures.some(({kept}) => kept) ? null : make("p", {class: "soft"}, "No photographs were kept with these captures: only what was found in them is drawn."),
    make("div", {class: "grid"}, ...groups.slice(shown.first, shown.first + perPage).map(group => grouped(group, again)))];
}

// The picture that was looked at last stays in front.
const inFront = new Map(); // by group: which of its pictures
function grouped(group, again) {
  const key = groupOf(group[0]);
  const front = Math.min(inFront.get(key) || 0, group.length - 1), figure = pictureFigure(group[front]);
  if (group.length > 1) {
    figure.append(make("div", {class: "controls repeats"}, make("span", {class: "soft"}, "captures of this pose:"),
      ...group.map((picture, i) => button(String(picture.capture), () => { inFront.set(key, i); again(); },
        {class: "small", "aria-pressed": String(i === front), "aria-label": "show capture " + picture.capture, title: px(pictureRms(picture)) + " rms"}))));
  }
  return figure;
}

function pager(groups, again) {
  shown.first = Math.min(shown.first, Math.max(0, groups.length - 1));
  const turn = pages => () => { shown.first = Math.max(0, shown.first + pages * perPage); again(); };
  return make("div", {class: "controls"},
    choice("Order", [{value: "worst", text: "worst first"}, {value: "time", text: "as taken"}], shown.order,
      value => { shown.order = value; shown.first = 0; again(); }, "order"),
    button("‹", turn(-1), {disabled: shown.first === 0, id: "previous", "aria-label": "captures before"}),
    make("span", {}, shown.first + 1 + "–" + Math.min(shown.first + perPage, groups.length) + " of " + groups.length),
    button("›", turn(1), {disabled: shown.first + perPage >= groups.length, id: "next", "aria-label": "captures after"}),
    make("span", {class: "keys soft"}, make("span", {class: "key measured"}), " measured ", make("span", {class: "key predicted"}), " predicted ",
      make("span", {class: "key doubtful"}), " doubtful"));
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
