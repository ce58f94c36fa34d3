// History view: the runs of a robot, and the offset of each joint over time with falls and jumps.
import {button, choosing, csvTable, element, empty, renew} from "naocal/lib/dom.js";
import {number, px} from "naocal/lib/format.js";
import {act, state} from "../core/state.js";
import {jumps, offsetPlot} from "./offset-plot.js";

/** @import {RecordedRun, RobotRuns} from "../core/messages.js" */

export const requestHistory = () => act({do: "history"});
export const hasHistory = () => Boolean(state.history?.robots.length);

/** "2026-02-14 10:05" @param {string} time */
const minute = time => time.slice(0, 16).replace("T", " ");

export const openRun = id => act({do: "openRun", id});

/** The newest run of a head that has captures. @param {string | undefined} head @returns {RecordedRun | undefined} */
export function newestRun(head) {
  const runs = (state.history?.robots ?? []).flatMap(({runs}) => runs).filter(run => run.robot.head === head && run.captures);
  return runs.sort((a, b) => a.time < b.time ? -1 : 1).at(-1);
}

export function showHistory(parent) {
  const {history} = state;
  if (!history) return renew(parent, element("h1", {}, "History"), element("p", {class: "soft"}, "The runs are being read."));
  const broken = history.broken.length ? [element("h2", {}, "Left out"), element("ul", {class: "warnings"}, ...history.broken.slice(0, 10).map(sentence => element("li", {}, sentence)),
    history.broken.length > 10 ? element("li", {}, number(history.broken.length - 10) + " more files like these") : null)] : [];
  if (!history.robots.length) {
    return renew(parent, empty("No runs are recorded yet", history.folder ? "Calibrations of connected robots are recorded in " + history.folder + " when they end, and what naocal apply sets." :
      "The panel found no folder to record runs in: start it with --state FOLDER."), ...broken);
  }
  const options = history.robots.map(({body, name}, i) => ({value: String(i), text: name || body}));
  renew(parent, element("h1", {}, "History"), choosing("historyRobot", "Robot", options, chosen => robotHistory(history.robots[Number(chosen)], history)), ...broken);
}

/** @param {RobotRuns} robot */
function robotHistory(robot, {rule, folder}) {
  const sorted = [...robot.joints].sort((a, b) => jumps(b).length - jumps(a).length || (a.joint < b.joint ? -1 : 1));
  const plots = sorted.map(joint => element("figure", {}, offsetPlot(joint, robot, openRun), element("figcaption", {}, element("b", {}, joint.joint), joint.sentence.slice(joint.sentence.indexOf(":")))));
  return element("div", {}, element("p", {class: "sentence"}, robot.sentence), element("h2", {}, "Runs"), csvTable(runTable(robot), "runs"),
    robot.runs.some(({errorBefore, heldOut}) => errorBefore !== undefined && !heldOut) ? element("p", {class: "soft"}, "*: on the captures that the result was made from; without it, on pictures that were not used.") : null,
    ...(plots.length ? [element("h2", {}, "Joint offsets over time"),
      element("p", {class: "soft"}, "Dots with two standard errors; ", element("span", {class: "key hollow round"}), " not compared: undone or taken back; ",
        element("span", {class: "key before"}), " a jump; ", element("span", {class: "key fall"}), " a fall. " + rule + " A click on a dot opens its run in Compare."),
      element("div", {class: "grid history"}, ...plots)] : []),
    element("p", {class: "soft"}, "Recorded in " + folder + "."));
}

/** @param {RobotRuns} robot */
function runTable({runs, falls}) {
  const head = ["date (UTC)", "head", "kind", "error before", "after", "offsets", "its numbers", "recorded by", ""];
  const lines = [...runs.map(run => ({time: run.time, row: runRow(run)})), ...falls.map(time => ({time, row: fallRow(time)}))];
  lines.sort((a, b) => a.time < b.time ? 1 : -1);
  return element("table", {class: "runs"}, element("thead", {}, element("tr", {}, ...head.map((words, i) => element("th", {scope: "col", class: i >= 3 && i <= 5 ? "number" : ""}, words)))),
    element("tbody", {}, ...lines.map(({row}) => row)));
}

/** @param {RecordedRun} run */
function runRow(run) {
  const error = value => element("td", {class: "number"}, value === undefined ? "–" : px(value) + (run.heldOut ? "" : "*"));
  const opens = run.captures || run.result;
  return element("tr", {class: run.words === "kept" ? "" : "soft"}, element("th", {scope: "row"}, minute(run.time)), element("td", {}, run.robot.head), element("td", {}, run.kind),
    error(run.errorBefore), error(run.errorAfter), element("td", {class: "number"}, Object.keys(run.offsets || {}).length),
    element("td", {}, run.words + (run.undone ? " " + minute(run.undone) : "")), element("td", {}, run.by),
    element("td", {}, opens ? button("Open", () => openRun(run.id), {class: "small", title: opens, "aria-label": "open the run of " + minute(run.time) + " in Compare"}) : null));
}

const fallRow = time => element("tr", {class: "fallen"}, element("th", {scope: "row"}, minute(time)), element("td", {}), element("td", {}, "fall"), element("td", {colspan: "6"}));
