// Compare: where the prediction fails. Residuals over anything, the chosen capture beside them, all pictures worst first.
import {make, button, choice, csv, download, renew} from "./elements.js";
import {on} from "./connection.js";
import {state} from "./state.js";
import {pictureFigure, pictureRms, cornersOf} from "./pictures.js";
import {scatterFigure, horizontals, verticals, isChosen} from "./scatter.js";

const perPage = 6;
const shown = {horizontal: "u", vertical: "du", camera: "", first: 0, order: "worst"};
on("opened", () => Object.assign(shown, {camera: "", first: 0}));

export function showCompare(parent) {
  const {fit} = state;
  const options = horizontals(fit), horizontal = options.find(({value}) => value === shown.horizontal) || options[0];
  const vertical = verticals.find(({value}) => value === shown.vertical);
  const again = () => showCompare(parent);
  const pictures = [...fit.pictures].sort((a, b) => shown.order === "worst" ? pictureRms(b) - pictureRms(a) : a.time - b.time || a.capture - b.capture);
  const chosen = pictures.find(isChosen) || pictures[0];
  const cameras = [...new Set(fit.pictures.map(({camera}) => camera))];
  const scatter = scatterFigure({fit, horizontal, vertical, camera: shown.camera, choose: picture => { state.chosen = picture; again(); }});
  renew(parent,
    make("h1", {}, "Where the prediction fails"),
    make("p", {class: "soft"}, "Every point is a corner: how far its prediction is off. Orange squares are means with two " +
      "standard errors; good is when they stay at zero everywhere. Click a point to see its capture."),
    make("div", {class: "controls"},
      choice("Error over", options, shown.horizontal, value => { shown.horizontal = value; again(); }, "overX"),
      choice("error", verticals, shown.vertical, value => { shown.vertical = value; again(); }, "errorY"),
      choice("camera", [{value: "", text: "both"}, ...cameras.map(value => ({value, text: value}))], shown.camera,
        value => { shown.camera = value; again(); }, "ofCamera"),
      choice("joints", [{value: "reported", text: "as their encoders report them"}, {value: "fitted", text: "moved as far as their noise allows"}],
        state.layer, value => { state.layer = value; again(); }, "layer"),
      button("CSV", () => saveCorners(fit), {class: "small"})),
    make("div", {class: "split"}, scatter, make("div", {}, pictureFigure(chosen))),
    make("h2", {}, "Captures"),
    pager(pictures, again),
    fit.pictures.some(({kept}) => kept) ? null : make("p", {class: "soft"}, "No photographs were kept with these captures: only what was found in them is drawn."),
    make("div", {class: "grid"}, ...pictures.slice(shown.first, shown.first + perPage).map(pictureFigure)));
}

function pager(pictures, again) {
  shown.first = Math.min(shown.first, Math.max(0, pictures.length - 1));
  const turn = pages => () => { shown.first = Math.max(0, shown.first + pages * perPage); again(); };
  return make("div", {class: "controls"},
    choice("Order", [{value: "worst", text: "worst first"}, {value: "time", text: "as taken"}], shown.order,
      value => { shown.order = value; shown.first = 0; again(); }, "order"),
    button("‹", turn(-1), {disabled: shown.first === 0, id: "previous", "aria-label": "captures before"}),
    make("span", {}, shown.first + 1 + "–" + Math.min(shown.first + perPage, pictures.length) + " of " + pictures.length),
    button("›", turn(1), {disabled: shown.first + perPage >= pictures.length, id: "next", "aria-label": "captures after"}),
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
