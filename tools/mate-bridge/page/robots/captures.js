// Captures of a calibration: thumbnails with corner counts.
import {element} from "naocal/lib/dom.js";
import {of, valueOf} from "../core/state.js";

export const capturesKey = "Brain.calibrationCaptures"; // [{number, round, pose, camera, corners, boards}]
const fewCorners = 6;

// Captures with the URL of their picture, if the bridge has received it.
export function capturesOf(robot) {
  const {pictures: {series, places}} = of(robot);
  return (valueOf(robot, capturesKey) || []).map((one, i) => ({...one,
    url: places.includes(i) ? "taken/" + encodeURIComponent(robot + "/" + series + "/" + i) : null}));
}

const worth = ({corners, boards}) => corners === null ? "searching for boards"
  : corners < fewCorners ? "no board seen" : corners + " corners on " + (boards.length === 1 ? "board " : "boards ") + boards.join(", ");

// One thumbnail per pose and camera: the last picture, and the corner count of each.
export function thumbnails(robot) {
  const groups = new Map();
  for (const capture of capturesOf(robot)) {
    const name = [capture.round, capture.pose, capture.camera].join("\n");
    groups.set(name, [...(groups.get(name) || []), capture]);
  }
  if (!groups.size) return [];
  return [element("h2", {}, "Captures"), element("ol", {class: "thumbnails", "aria-label": "captures, the latest first"}, ...[...groups.values()].reverse().map(captures => {
    const {url} = captures.findLast(one => one.url) || {}, [{round, pose, camera}] = captures, worths = [...new Set(captures.map(worth))];
    return element("li", {class: captures.some(({corners}) => corners !== null && corners < fewCorners) ? "poor" : ""},
      url ? element("img", {src: url, alt: "", width: "160", height: "120"}) : element("span", {class: "blank soft", title: "No panel was watching when it was taken. The robot's recording has it."}, "no picture"),
      element("b", {}, "pose " + pose + ", " + camera), element("span", {class: "soft"}, (round ? "second round, " : "") + (captures.length > 1 ? captures.length + " pictures: " : "") + worths.join("; ")));
  }))];
}
