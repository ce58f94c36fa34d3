// What a calibration brought.
import {make} from "./elements.js";
import {px, number} from "./words.js";

const degrees = value => value === undefined ? "–" : number(value.toFixed(2)) + "°";

// Errors before and after on pictures that were not used, and the offsets as they were and are.
export function outcome(state, isRunning, before, now) {
  const shown = [];
  if (state && state.errorBefore !== null && !isRunning) {
    const most = Math.max(state.errorBefore, state.errorAfter);
    const row = (name, value) => {
      const bar = make("span", {class: "bar"});
      bar.style.width = 100 * value / most + "%";
      return make("div", {class: "rung flat"}, make("span", {}, name), make("span", {class: "axis"}, bar), make("span", {class: "number"}, px(value)));
    };
    shown.push(make("h2", {}, "Error on pictures that were not used"), row("before", state.errorBefore), row("after", state.errorAfter));
  }
  if (now && now.length) {
    const value = (list, key) => list.find(one => one.key === key)?.value;
    const changed = now.filter(one => typeof one.value === "number" && (one.value !== 0 || (before && value(before, one.key) !== one.value)));
    shown.push(make("h2", {}, "Joint offsets on the robot"), changed.length ? make("table", {}, make("thead", {}, make("tr", {}, make("th", {scope: "col"}, "joint"),
      before ? make("th", {scope: "col", class: "number"}, "before") : null, make("th", {scope: "col", class: "number"}, "now"))),
      make("tbody", {}, ...changed.map(one => make("tr", {}, make("th", {scope: "row"}, one.key), before ? make("td", {class: "number"}, degrees(value(before, one.key))) : null,
        make("td", {class: "number"}, degrees(one.value)))))) : make("p", {class: "soft"}, "None: every joint counts as it reads."));
  }
  return shown;
}
