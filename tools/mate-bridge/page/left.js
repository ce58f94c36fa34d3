// What is left over, beside the map: what each joint would have to do, within the pictures, on the boards.
import {make, choice, renew} from "./elements.js";
import {figure} from "./canvas.js";
import {jointsByTrend, drawWhatIf} from "../../../src/modules/report/page/shared/deflections.js";
import {drawWithin, drawRanges} from "../../../src/modules/report/page/shared/within.js";
import {boardPlan, drawShape} from "../../../src/modules/report/page/shared/boards.js";
import {state} from "./state.js";

const model = "asGiven"; // the one that one stands on
const shown = {joint: "", driver: ""};

export function leftSections(data, go) {
  const {left: {asGiven: left}} = data;
  if (!left) return [];
  // A point that belongs to a picture leads to it.
  const leading = draw => (...where) => draw(...where).map(target => target.picture === undefined ? target : {...target, click: () => {
    const {capture, pose} = data.pictures[target.picture], set = data.poses[pose].set;
    state.chosen = state.fit.pictures.find(picture => picture.capture === capture && picture.set === set);
    go("compare");
  }});
  const drawn = (label, height, draw) => {
    const caption = make("figcaption");
    return make("figure", {}, figure({label, height, draw: leading((context, width, tall) => draw(context, width, tall, caption))}), caption);
  };
  return [...deflections(data, drawn), ...within(data, left, drawn), ...boards(data, left, drawn)];
}

function deflections(data, drawn) {
  const ranked = jointsByTrend(data);
  if (!ranked.length) return [];
  const parent = make("div");
  const again = () => {
    const here = ranked.find(({joint}) => joint === shown.joint) || ranked[0], {offered} = here;
    const {driver} = offered.find(({driver: {what}}) => what === shown.driver) || offered[0];
    renew(parent,
      make("div", {class: "controls"},
        choice("Joint", ranked.map(({joint}) => ({value: joint, text: joint})), here.joint, value => { shown.joint = value; shown.driver = ""; again(); }, "bent"),
        choice("over", offered.map(({driver: {what}}) => ({value: what, text: what})), driver.what, value => { shown.driver = value; again(); }, "bentOver")),
      drawn("deflection of " + here.joint + " over " + driver.what, 340, (context, width, height, caption) =>
        drawWhatIf(context, width, height, {data, model, joint: here.joint, driver, caption})));
  };
  again();
  return [make("h2", {}, "Joint error that would explain the misfit"),
    make("p", {class: "soft"}, "For each encoder reading of a pose the deflection of one joint that alone would explain what is left over, with one " +
      "standard error; squares are means over stretches, with two. Good: the squares stay at zero. What varies most stands first in both lists."), parent];
}

function within(data, left, drawn) {
  if (!left.within.cells.length) return [];
  return [make("h2", {}, "Within the pictures"),
    make("p", {class: "soft"}, "What is left when every picture may move as a whole: no joint, link or mount can do it, but lens, boards and the finding of " +
      "corners can. Arrows lead from where corners were measured towards where they are predicted; thick where that is beyond chance."),
    make("div", {class: "grid"}, ...Object.entries(data.cameras).map(([camera, {width: full, height: tall}]) =>
      drawn("left over in the " + camera + " camera", width => width * tall / full, (context, width, height, caption) =>
        drawWithin(context, width, height, {data, model, camera, caption})))),
    drawn("left over by distance", 300, (context, width, height, caption) => drawRanges(context, width, height, {data, model, caption}))];
}

function boards(data, left, drawn) {
  if (!left.shapes.length) return [];
  return [make("h2", {}, "On the boards"),
    make("p", {class: "soft"}, "Where each board's corners seem to lie beside where its file has them: arrows within the sheet, discs off it, ",
      make("span", {class: "key dot orange"}), " towards the camera and ", make("span", {class: "key dot"}), " away from it; pale where that is less " +
      "than two standard errors. A sheet that is bent, printed crookedly or lies over a cable looks like that."),
    make("div", {class: "grid"}, ...left.shapes.map(({board}) => {
      const plan = boardPlan(data, model, board);
      return drawn("shape of board " + board, width => width * plan.tall, (context, width, height, caption) => drawShape(context, width, height, plan, caption));
    }))];
}
