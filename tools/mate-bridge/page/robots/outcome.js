// Outcome of a calibration: error before and after, offsets with sigmas, warnings.
import {ticks} from "naocal/lib/axes.js";
import {csvTable, element} from "naocal/lib/dom.js";
import {colours, figure} from "naocal/lib/figure.js";
import {number, px, withError} from "naocal/lib/format.js";

export const outcomeKey = "Brain.calibrationOutcome"; // {joints: [{joint, before, after, sigma, learned}] [°], warnings: [sentence], diagnosis: sentence}
const degrees = value => value === undefined || value === null ? "–" : number(value.toFixed(2)) + "°";

export function outcome(state, isRunning, told) {
  const shown = [];
  if (state && state.errorBefore !== null && !isRunning) {
    const most = Math.max(state.errorBefore, state.errorAfter);
    const row = (name, value) => {
      const bar = element("span", {class: "bar"});
      bar.style.width = 100 * value / most + "%";
      return element("div", {class: "rung flat"}, element("span", {}, name), element("span", {class: "axis"}, bar), element("span", {class: "number"}, px(value)));
    };
    shown.push(element("h2", {}, "Error on pictures not used for the calibration"), row("before", state.errorBefore), row("after", state.errorAfter));
  }
  if (told && told.diagnosis) shown.push(element("h2", {}, "Quality of the fit"), element("p", {}, told.diagnosis));
  if (told && told.warnings.length) shown.push(element("h2", {}, "Note"), element("ul", {class: "warnings"}, ...told.warnings.map(warning => element("li", {}, warning))));
  return shown;
}

const shownTo = 5e-3; // [°]: half of the last digit

// Joint offsets on the robot before and now, with two sigmas where a calibration determined what the robot has now.
export function offsets(told, before, now) {
  if (!now || !now.length) return [];
  const value = (list, joint) => list ? list.find(({key}) => key.toLowerCase() === joint.toLowerCase())?.value : undefined;
  const rows = now.filter(({value}) => typeof value === "number").map(({key, value: after}) => {
    const found = told && told.joints.find(({joint}) => joint.toLowerCase() === key.toLowerCase());
    return {joint: key, before: found ? found.before : value(before, key), after, sigma: found && Math.abs(found.after - after) < shownTo ? found.sigma : null};
  }).filter(row => row.after !== 0 || row.sigma !== null || (row.before !== undefined && row.before !== row.after));
  if (!rows.length) return [element("h2", {}, "Joint offsets on the robot"), element("p", {class: "soft"}, "No offsets: joint readings are used as they are.")];
  const table = element("table", {}, element("thead", {}, element("tr", {}, element("th", {scope: "col"}, "joint"), element("th", {scope: "col", class: "number"}, "before"),
    element("th", {scope: "col", class: "number"}, "now"))), element("tbody", {}, ...rows.map(row => element("tr", {}, element("th", {scope: "row"}, row.joint),
    element("td", {class: "number"}, degrees(row.before)), element("td", {class: "number"}, row.sigma === null ? degrees(row.after) : withError(row.after, row.sigma, "°"))))));
  return [element("h2", {}, "Joint offsets on the robot"),
    figure({height: 34 + 22 * rows.length, label: "joint offsets before and after", draw: (context, width, height) => draw(context, width, height, rows)}),
    element("p", {class: "soft keys"}, element("span", {class: "key hollow"}), " before ", element("span", {class: "key full"}), " now, with two standard errors"),
    csvTable(table, "offsets")];
}

// Camera rotations relative to the drawing, before and now.
export function cameraMounts(before, now) {
  const rows = (now || []).filter(({key, value}) => key.endsWith("_ext") && Array.isArray(value))
    .map(({key, value}) => ({camera: key.replace("_ext", ""), after: value, before: (before || []).find(one => one.key === key)?.value}))
    .filter(({before: was, after}) => after.some(angle => angle !== 0) || (was && was.some(angle => angle !== 0)));
  if (!rows.length) return [];
  const angles = list => element("td", {class: "number wrap"}, ...(list ? list.flatMap(angle => [element("span", {}, degrees(angle * 180 / Math.PI)), " "]) : ["–"]));
  const head = ["camera (rx ry rz)", "before", "now"].map((words, i) => element("th", {scope: "col", class: i ? "number" : ""}, words));
  return [element("h2", {}, "Camera mounts on the robot"), csvTable(element("table", {}, element("thead", {}, element("tr", {}, ...head)),
    element("tbody", {}, ...rows.map(row => element("tr", {}, element("th", {scope: "row"}, row.camera), angles(row.before), angles(row.after))))), "camera-mounts")];
}

function draw(context, width, height, rows) {
  const reach = 1.1 * Math.max(0.1, ...rows.flatMap(({before, after, sigma}) => [Math.abs(before || 0), Math.abs(after) + 2 * (sigma || 0)]));
  const box = {left: Math.min(120, 0.3 * width), right: width - 10, top: 6, bottom: height - 26};
  const place = value => box.left + (value + reach) / (2 * reach) * (box.right - box.left);
  context.textBaseline = "top";
  context.textAlign = "center";
  for (const mark of ticks(-reach, reach, (box.right - box.left) / 80)) {
    context.fillStyle = colours.line;
    context.fillRect(place(mark), box.top, 1, box.bottom - box.top);
    context.fillStyle = colours.soft;
    context.fillText(number(mark) + "°", place(mark), box.bottom + 6);
  }
  context.textBaseline = "middle";
  return rows.map((row, i) => {
    const y = box.top + 22 * i + 11;
    context.fillStyle = colours.ink;
    context.textAlign = "right";
    context.fillText(row.joint, box.left - 8, y);
    context.strokeStyle = colours.soft;
    context.lineWidth = 1;
    if (row.before !== undefined && row.before !== null) context.strokeRect(Math.min(place(0), place(row.before)), y - 8, Math.max(3, Math.abs(place(row.before) - place(0))), 7);
    context.fillStyle = colours.blue;
    context.fillRect(Math.min(place(0), place(row.after)), y + 1, Math.abs(place(row.after) - place(0)) || 1, 7);
    if (row.sigma !== null) {
      context.strokeStyle = colours.orange;
      context.lineWidth = 2;
      context.beginPath();
      context.moveTo(place(row.after - 2 * row.sigma), y + 4.5);
      context.lineTo(place(row.after + 2 * row.sigma), y + 4.5);
      context.stroke();
    }
    context.strokeStyle = colours.soft;
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(place(0), y - 10);
    context.lineTo(place(0), y + 11);
    context.stroke();
    return {x: place(row.after), y: y + 4, tip: () => row.joint + "\nbefore " + degrees(row.before) + "\nnow " + (row.sigma === null ? degrees(row.after) : withError(row.after, row.sigma, "°"))};
  });
}
