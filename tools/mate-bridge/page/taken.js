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

// A pose's pictures of one camera stand for each other: the last that there is, and what each is worth.
export function thumbnails(robot) {
  const groups = new Map();
  for (const capture of of(robot).captures) {
    const name = [capture.round, capture.pose, capture.camera].join("\n");
    groups.set(name, [...(groups.get(name) || []), capture]);
  }
  if (!groups.size) return [];
  return [make("h2", {}, "Captures"), make("ol", {class: "thumbnails", "aria-label": "captures, the latest first"}, ...[...groups.values()].reverse().map(captures => {
    const {url} = captures.findLast(one => one.url) || {}, [{round, pose, camera}] = captures, worths = [...new Set(captures.map(worth))];
    return make("li", {class: captures.some(({corners}) => corners !== null && corners < fewCorners) ? "poor" : ""},
      url ? make("img", {src: url, alt: "", width: "160", height: "120"}) : make("span", {class: "blank soft"}, "no picture here"),
      make("b", {}, "pose " + pose + ", " + camera), make("span", {class: "soft"}, (round ? "second round, " : "") + (captures.length > 1 ? captures.length + " pictures: " : "") + worths.join("; ")));
  }))];
}
