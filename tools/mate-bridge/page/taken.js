// Captures as they are taken: a thumbnail of each picture and what it is worth.
import {make} from "./elements.js";
import {of, valueOf} from "./values.js";

export const capturesKey = "Brain.calibrationCaptures"; // [{number, round, pose, camera, corners, boards}]
const fewCorners = 6;

// Takes thumbnails while the cameras still remember the pictures; `now`: of the cycle that told.
export function gather(robot, cameras, now) {
  const told = valueOf(robot, capturesKey) || [], known = of(robot);
  if (told.length < known.captures.length) {
    known.captures.forEach(({url}) => url && URL.revokeObjectURL(url));
    known.captures = [];
  }
  told.forEach((one, i) => {
    const {when = now, url: had = null} = known.captures[i] || {};
    const file = had ? null : cameras.find(({key}) => key.includes(one.camera))?.camera.at(when); // it may come later
    known.captures[i] = {...one, when, url: file ? URL.createObjectURL(file) : had};
  });
}

export const worth = ({corners, boards}) => corners === null ? "being looked at"
  : corners < fewCorners ? "no board seen" : corners + " corners on " + (boards.length === 1 ? "board " : "boards ") + boards.join(", ");

export function thumbnails(robot) {
  const {captures} = of(robot);
  if (!captures.length) return [];
  return [make("h2", {}, "Captures"), make("ol", {class: "thumbnails", tabindex: "0", "aria-label": "captures, the latest first"}, ...[...captures].reverse().map(capture => make("li", {class: capture.corners !== null && capture.corners < fewCorners ? "poor" : ""},
    capture.url ? make("img", {src: capture.url, alt: "", width: "160", height: "120"}) : make("span", {class: "blank soft"}, "no picture here"),
    make("b", {}, "pose " + capture.pose + ", " + capture.camera), make("span", {class: "soft"}, worth(capture)))))];
}
