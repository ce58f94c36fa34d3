// Start page: recent files, files to drop, a sample and a simulated robot to try, robots on the network, boards to print.
import {button, choice, element, renew} from "naocal/lib/dom.js";
import {capitalized} from "naocal/lib/format.js";
import {chooseCommand} from "../command-runner.js";
import {act, state} from "../core/state.js";
import {showRobot, simulateRobot} from "../robots/robots.js";
import {fileChoosers, uploadProgress} from "./drop.js";
import {startTour} from "./tour.js";

let typedPath = "", paper = "a3";
/** @type {string | null} */
let typedRobots = null; // null: as the bridge keeps them

const linesOf = text => text.split("\n").map(line => line.trim()).filter(Boolean);

export function showHome(parent) {
  const told = state.start;
  renew(parent, element("h1", {}, "Calibrate a robot"),
    element("p", {class: "soft"}, "Open captures, try the panel without a robot, or connect a robot. Nothing leaves this computer."),
    element("div", {class: "cards"}, opening(told), trying(told), robots(told, () => showHome(parent)), preparing()));
}

const card = (title, ...parts) => element("section", {class: "card", "aria-label": title}, element("h2", {}, title), ...parts.flat());

// Files.

function opening(told) {
  const progress = uploadProgress(), isBusy = progress !== null || Boolean(state.work);
  const path = element("input", {type: "text", id: "homePath", class: "code", spellcheck: "false", autocomplete: "off", placeholder: "/path/to/captures", "aria-label": "path of a capture set, recording or result",
    oninput: () => { typedPath = path.value; }});
  path.value = typedPath;
  const bar = element("progress", {max: "1", "aria-label": "files read"});
  bar.value = progress ?? 0;
  return card("Open captures", element("div", {class: "drop"},
    element("p", {}, "Drop a capture set, a robot's recording, or a result with its captures here. A table (CSV) with its robot's URDF is imported."),
    progress === null ? element("p", {class: "controls"}, ...fileChoosers(isBusy))
      : element("p", {class: "controls", role: "status"}, "Reading the files …", bar)),
  element("form", {class: "paths", onsubmit: event => {
    event.preventDefault();
    if (path.value.trim()) act({do: "open", paths: [path.value.trim()]});
  }}, path, element("button", {type: "submit", disabled: isBusy}, "Open")),
  recent(told));
}

function recent(told) {
  if (!told) return [];
  const note = told.problem ? [element("p", {class: "bad"}, capitalized(told.problem) + ".")] : [];
  if (!told.recent.length) return note;
  return [element("h3", {}, "Recent"), element("ul", {class: "recent"}, ...told.recent.map(one => element("li", {},
    element("span", {}, button(one.name + (one.paths.length > 1 ? " and " + (one.paths.length - 1) + " more" : ""), () => act({do: "open", paths: one.paths}), {class: "plain", title: one.paths.join("\n")}),
      element("span", {class: "soft"}, one.what + (one.opened ? ", " + ago(Date.now() / 1000 - one.opened) : ""))),
    element("span", {class: "soft where", title: one.folder}, one.folder),
    button("×", () => act({do: "forget", paths: one.paths}), {class: "small", "aria-label": "forget " + one.name, title: "remove from this list; the files stay"})))), ...note];
}

/** "3 hours ago" @param {number} seconds */
export function ago(seconds) {
  for (const [unit, length] of /** @type {[string, number][]} */ ([["day", 86400], ["hour", 3600], ["minute", 60]])) {
    const count = Math.floor(seconds / length);
    if (count >= 1) return count + " " + unit + (count > 1 ? "s" : "") + " ago";
  }
  return "just now";
}

// Without captures or a robot.

function trying(told) {
  const {state: made, sentence} = told?.sample ?? {state: "none", sentence: ""}, robot = told?.robot ?? {state: "off", address: "", sentence: ""};
  const isBusy = made === "making" || Boolean(state.work);
  return card("Try it without a robot",
    element("p", {}, "A simulated NAO with a hidden flaw has looked at four boards. Find the flaw, and see the error fall."),
    element("p", {class: "controls"}, button("Take the tour", startTour, {class: "main", disabled: isBusy, title: "five steps on the sample"}),
      button("Open the sample", () => act({do: "sample"}), {disabled: isBusy}),
      made === "making" ? element("span", {class: "soft", role: "status"}, "Taking pictures …") : null),
    made === "failed" ? element("p", {class: "bad"}, "The sample could not be made: " + sentence) : null,
    element("h3", {}, "A robot to calibrate"),
    element("p", {}, "A simulated NAO runs on this computer as naocal does on a real one. What it learns and records is deleted when mate-bridge ends."),
    element("p", {class: "controls"}, ...robot.state === "running" ? [button("Go to the robot", () => showRobot(robot.address), {class: "main"}), button("End it", () => act({do: "endRobot"})),
      element("span", {class: "soft"}, robot.address)]
      : robot.state === "ending" ? [element("span", {class: "soft", role: "status"}, "It goes to its stand …"), button("End it now", () => act({do: "endRobot"}))]
        : [button("Simulate a robot", simulateRobot)]),
    robot.state === "failed" ? element("p", {class: "bad"}, "The simulated robot has ended: " + robot.sentence) : null);
}

// Robots.

function robots(told, again) {
  const kept = told?.robots ?? [];
  if (typedRobots !== null && linesOf(typedRobots).join("\n") === kept.join("\n")) typedRobots = null;
  const text = typedRobots ?? kept.join("\n"), search = told?.search;
  const field = element("textarea", {rows: "2", id: "homeRobots", class: "code", spellcheck: "false", "aria-label": "addresses of robots, one per line", placeholder: "nao21\n10.1.24.22",
    oninput: () => { typedRobots = field.value; }});
  field.value = text;
  const connected = address => state.robots.get(address)?.connected;
  const connect = address => connected(address) ? button("Show", () => showRobot(address), {class: "small", "aria-label": "show " + address})
    : button("Connect", () => { if (act({do: "connect", robot: address})) showRobot(address); }, {class: "small", "aria-label": "connect to " + address});
  const row = (mark, address, words) => element("li", {}, element("span", {class: "mark " + mark, "aria-hidden": "true"}), element("b", {}, address), element("span", {class: "soft"}, words), connect(address));
  return card("Robots", element("form", {onsubmit: event => {
    event.preventDefault();
    typedRobots = field.value; // until the bridge has the same: it may refuse one of them
    act({do: "findRobots", robots: linesOf(field.value)});
    again();
  }}, element("p", {}, "Addresses of your robots, one per line: HOST, HOST:PORT, or the folder of UNIX sockets. They are kept. Only these are asked."), field,
  element("p", {class: "controls"}, element("button", {type: "submit", disabled: Boolean(search?.searching)}, "Look for robots"),
    search?.searching ? element("span", {class: "soft", role: "status"}, "Looking …") : null)),
  search?.searched ? [element("ul", {class: "recent found"}, ...search.listed.map(({address, state: found, sentence}) => row(found, address, sentence)),
    ...search.announced.map(({name, address}) => row("announced", address, name + " announces itself"))),
  !search.searching && !search.listed.length && !search.announced.length ? element("p", {class: "soft"}, "No robot was found.") : null,
  search.note ? element("p", {class: "soft"}, search.note) : null] : []);
}

// Before the first capture.

const papers = ["a4", "a3", "a2", "a1", "a0"];

function preparing() {
  const link = element("a", {class: "button", href: "boards-" + paper + ".pdf", download: "boards-" + paper + ".pdf"}, "Boards to print (PDF)");
  return card("Before the first capture",
    element("p", {}, "Print four boards at 100 %, and measure both rulers of each: printers scale. ", element("code", {}, "naocal board --boards boards.json --measured …"), " keeps the real size."),
    element("p", {class: "controls"}, choice("Paper", papers.map(value => ({value, text: value.toUpperCase()})), paper, value => {
      paper = value;
      Object.assign(link, {href: "boards-" + value + ".pdf", download: "boards-" + value + ".pdf"});
    }, "homePaper"), link),
    element("p", {}, "Plan which poses to take, and where the boards lie: stable poses in sight of the boards."),
    element("p", {class: "controls"}, button("Plan poses", () => { chooseCommand("Plan poses"); location.hash = "tools"; })));
}
