// The panel: views, tabs, keys, messages of the bridge.
import "./core/theme.js";
import {at, button, element, empty, question} from "naocal/lib/dom.js";
import {capitalized, waitingWords} from "naocal/lib/format.js";
import {showLearn} from "./analysis/candidates.js";
import {showCompare} from "./analysis/compare.js";
import {showMap} from "./analysis/residual-views.js";
import {filesWorked, showFiles} from "./analysis/files.js";
import {canRedo, canUndo, redo, showModel, undo} from "./analysis/model.js";
import {refreshPlay, showNext} from "./analysis/next-poses.js";
import {showResult} from "./analysis/result.js";
import {showUserEffect} from "./analysis/user-effect.js";
import {showLink} from "./bridge-status.js";
import {showTools} from "./command-runner.js";
import {connect, on} from "./core/connection.js";
import {explainAlways} from "./core/glossary.js";
import {offerViews} from "./core/session-export.js";
import {endNotice, notice, onNotice, say, state} from "./core/state.js";
import {hasCalibration, leaveCalibrate, calibrationSummary, onMessage as onCalibrateMessage, showCalibrate} from "./robots/calibrate.js";
import {onMessage as onConfigurationMessage, showKeys} from "./robots/configuration.js";
import {hasHistory, requestHistory, showHistory} from "./history/history.js";
import {refreshStop} from "./robots/controls.js";
import {followAll, stateKey} from "./robots/health.js";
import {leaveLive, onMessage as onLiveMessage, showLive} from "./robots/live.js";
import {onMessage as onRobotMessage, selectedRobot} from "./robots/robots.js";
import {endUpload, onUpload, takeDrops} from "./start/drop.js";
import {showHome} from "./start/home.js";
import {endImport, refreshImport} from "./start/import.js";
import {refreshTour, startTour} from "./start/tour.js";


// `kinds`: messages after which a view is redrawn; `awaits`: it shows nothing without the diagnosis; `worked`: called when the bridge starts or ends a task.
const views = [
  {id: "home", name: "Home", show: showHome, worked: showHome, kinds: ["start", "robot", "robotGone"]},
  {id: "compare", name: "Compare", show: showCompare, kinds: ["fit", "diagnosis", "unsearched"], analysis: true},
  {id: "learn", name: "Learn", show: showLearn, kinds: ["fit", "diagnosis", "unsearched"], awaits: true, analysis: true},
  {id: "map", name: "Map", show: parent => showMap(parent, go), kinds: ["fit", "diagnosis", "unsearched"], awaits: true, analysis: true},
  {id: "own", name: "Custom effect", show: showUserEffect, kinds: ["set"], analysis: true},
  {id: "result", name: "Result", show: showResult, kinds: ["fit", "keys", "robot"], analysis: true},
  {id: "next", name: "Next poses", show: showNext, kinds: ["fit", "next", "work", "keys", "robot"], analysis: true},
  {id: "files", name: "Files", show: showFiles, worked: filesWorked, kinds: ["set", "compared", "missing"]},
  {id: "match", name: "Calibrate", show: showCalibrate, enter: requestHistory, leave: leaveCalibrate, kinds: []},
  {id: "live", name: "Live", show: showLive, leave: leaveLive, kinds: []},
  {id: "keys", name: "Configuration", show: showKeys, kinds: []},
  {id: "history", name: "History", show: showHistory, enter: requestHistory, kinds: ["history"]},
  {id: "tools", name: "Tools", show: showTools, kinds: []},
];
const keyed = ["h", "1", "2", "3", "4", "5", "6", "7", "8", "9", "0", "y", "t"]; // keyboard shortcuts of the views
/** @type {any} */
let current;
let hasRobots = false; // whether the bridge has robots
let complete = false; // whether all data of the analysis views have arrived

function go(id) {
  if (location.hash === "#" + id) open();
  else location.hash = id;
}

function open() {
  const first = state.analysis ? "compare" : hasRobots ? "match" : "home";
  const wanted = views.find(({id}) => id === location.hash.slice(1)) || views.find(({id}) => id === first);
  if (current !== wanted && current && current.leave) current.leave();
  const arrived = current !== wanted;
  current = wanted;
  for (const tab of at("tabs").querySelectorAll("button")) {
    if (tab.dataset.view === current.id) tab.setAttribute("aria-current", "page");
    else tab.removeAttribute("aria-current");
  }
  document.title = current.name + " – naocal panel";
  at("menu").textContent = current.name;
  toggleMenu(false);
  at("model").hidden = !(current.analysis && state.analysis);
  document.body.classList.toggle("laddered", !at("model").hidden);
  /** @type {HTMLElement} */ (document.querySelector("main")).classList.toggle("wide", at("model").hidden);
  draw();
  if (!arrived) return;
  if (current.enter) current.enter();
  showTab();
  scrollTo(0, 0);
}

// Scrolls the tab strip of a narrow window, not the page.
function showTab() {
  const strip = at("tabs"), tab = strip.querySelector("[aria-current]");
  if (tab) strip.scrollLeft += tab.getBoundingClientRect().left - strip.getBoundingClientRect().left - (strip.clientWidth - tab.clientWidth) / 2;
}
addEventListener("resize", showTab);

// In narrow windows the tabs are a menu.
function toggleMenu(open) {
  at("tabs").classList.toggle("open", open);
  at("menu").setAttribute("aria-expanded", String(open));
}
at("menu").addEventListener("click", () => {
  toggleMenu(!at("tabs").classList.contains("open"));
  at("tabs").querySelector("[aria-current]")?.focus({preventScroll: true});
});
document.addEventListener("click", event => { if (!at("tabs").contains(event.target) && event.target !== at("menu")) toggleMenu(false); });

function draw() {
  drawView();
  refreshTour();
}

function drawView() {
  const view = at("view");
  complete = Boolean(state.fit && state.set && state.ladder);
  if (!current.analysis) current.show(view);
  else if (!state.analysis) {
    view.replaceChildren(empty(state.work ? "Opening captures" : "No captures are open", state.work ? "This takes a few seconds." : "Open a capture set, a result or a diagnosis, or take the tour on a sample.",
      ...state.work ? [] : [nextSteps(button("Open captures", () => go("home"), {class: "main"}), button("Take the tour", startTour))]));
  } else if (state.unfitted) view.replaceChildren(empty("These captures could not be fitted", state.unfitted.sentence.replace(/\.?$/, ". ") + "Remove what it names from the model or the captures, then open them again.",
    nextSteps(button("Open captures", () => go("home"), {class: "main"}))));
  else if (!complete) view.replaceChildren(empty("Fitting", "The first fit takes less than a second for thirty poses."));
  else if (awaitsAnswers() && state.earlier) showEarlier(view);
  else current.show(view);
  if (!awaitsAnswers()) view.classList.remove("earlier");
  if (!at("model").hidden) showModel(at("model"));
}

const nextSteps = (...buttons) => element("span", {class: "controls next-steps"}, ...buttons);

// Whether the view needs results for this model that the bridge is still computing.
const awaitsAnswers = () => Boolean(current && current.analysis && complete && current.awaits && !state.diagnosis && !state.unfitted);

// Shows the previous model's results, dimmed and inert, until those for this model arrive.
function showEarlier(view) {
  state.diagnosis = state.earlier;
  try {
    current.show(view);
  } finally {
    state.diagnosis = null;
  }
  for (const part of view.children) part.inert = true;
  view.classList.add("earlier");
  const note = element("p", {class: "waiting", role: "status"});
  view.prepend(note);
  sayWaiting(note);
}
function sayWaiting(note) {
  note.textContent = waitingWords(state.fit);
  note.classList.add("busy");
  clearTimeout(note.late);
  if (!state.work) note.late = setTimeout(() => { // the bridge is briefly idle between two tasks
    note.textContent = "These answers are for the previous model; those for this one did not arrive.";
    note.classList.remove("busy");
  }, 2000);
}

// Messages about the open captures; "diagnosis" refers to the preceding "fit".
const analysisKinds = ["set", "ladder", "fit", "unfitted", "diagnosis", "unsearched", "next", "compared"];
const forget = kinds => kinds.forEach(kind => { state[kind] = null; });
for (const kind of analysisKinds) {
  on(kind, message => {
    if (kind === "fit") state.earlier = state.diagnosis || state.earlier;
    state[kind] = message;
    if (kind === "fit") forget(["unfitted", "diagnosis", "unsearched", "next", "compared"]); // these refer to the previous fit
    redraw(kind);
  });
}
function redraw(kind) {
  if (!current) return;
  if (current.kinds.includes(kind) || (current.analysis && !complete)) draw();
  else if (!at("model").hidden) showModel(at("model"));
}
on("start", message => {
  state.start = message;
  if (current?.kinds.includes("start")) draw();
  else refreshTour();
});
on("hello", ({analysis, robots}) => { // the analysis messages follow
  hasRobots = robots.length > 0;
  forget([...analysisKinds, "earlier"]);
  state.analysis = analysis;
  open();
});
on("opened", () => { // other captures were opened
  forget([...analysisKinds, "earlier"]);
  state.analysis = true;
  state.chosen = null;
  state.missing = null;
  go("compare");
});
on("refused", ({sentence}) => { if (sentence !== state.missing?.sentence) notice(sentence); });
on("moved", ({sentence}) => say(capitalized(sentence) + "."));
on("history", message => {
  const isKnown = JSON.stringify(message) === JSON.stringify(state.history);
  state.history = message;
  if (!isKnown) redraw("history"); // a click would miss a button that is replaced under it
});
on("missing", message => {
  state.missing = message;
  endNotice("action");
  go("files");
});
on("work", ({what}) => {
  state.work = what;
  at("work").textContent = what ? what + " …" : "";
  at("work").classList.toggle("busy", Boolean(what));
  if (current?.worked) current.worked(at("view"));
  at("view").querySelectorAll(":scope > .waiting").forEach(sayWaiting);
  redraw("work");
});
for (const kind of ["robot", "robotGone", "list", "mounts", "keys", "update", "picture", "taken", "scene", "seen", "stand"]) {
  on(kind, (message, more) => {
    if (!onRobotMessage(message)) return;
    if (["robot", "robotGone", "list"].includes(kind)) { followAll(); refreshStop(); }
    if (message.robot === selectedRobot() && current && current.kinds.includes(kind)) redraw(kind);
    onLiveMessage(message, more, current && current.id === "live");
    onCalibrateMessage(message, more, current && current.id === "match");
    onConfigurationMessage(message, current && current.id === "keys");
    if (kind === "update" && message.values.some(({key}) => key === stateKey)) { refreshStop(); refreshPlay(); }
  });
}

/** By cause, the newest last; each stays until its cause ends or OK. @type {Map<string, {sentence: string, kind: string}>} */
const notices = new Map();
let fading = 0;
function showNotices() {
  at("notice").hidden = !notices.size;
  at("notice").replaceChildren(...[...notices].map(([cause, {sentence, kind}]) =>
    element("div", {class: kind}, element("span", {}, sentence), button("OK", () => dropNotice(cause), {class: "small"}))));
}
function dropNotice(cause) {
  if (notices.delete(cause)) showNotices();
}
onNotice((sentence, kind, cause) => {
  notices.delete(cause);
  notices.set(cause, {sentence, kind});
  showNotices();
  if (cause !== "action") return;
  clearTimeout(fading);
  if (kind === "news") fading = window.setTimeout(() => dropNotice(cause), 8000);
}, dropNotice);

document.addEventListener("keydown", event => {
  if (event.ctrlKey || event.metaKey || event.altKey || /^(INPUT|SELECT|TEXTAREA)$/.test(/** @type {Element} */ (event.target).tagName)) return;
  if (event.key === "Escape") toggleMenu(false);
  if (event.key === "?") showHelp();
  const place = keyed.indexOf(event.key) + 1;
  if (place >= 1) go(views[place - 1].id);
  else if (!current || at("model").hidden || !state.ladder) return;
  else if (event.key === "u" && canUndo(state.ladder)) undo(state.ladder);
  else if (event.key === "r" && canRedo(state.ladder)) redo(state.ladder);
});

function showHelp() {
  const row = (key, words) => element("tr", {}, element("td", {}, element("kbd", {}, key)), element("td", {}, words));
  const close = () => at("keys").replaceChildren();
  at("keys").replaceChildren(question({class: "confirm", "aria-label": "keyboard shortcuts"}, close, element("h2", {}, "Keyboard shortcuts"), element("table", {class: "files"}, element("tbody", {}, row("s", "Stop: every calibration ends and its robot goes back to its stand"), ...views.map(({name}, i) => row(keyed[i], name)),
    row("u", "undo the last change to the model"), row("r", "redo it"), row("?", "this list"), row("Esc", "close; discard an edited value; end the tour"), row("← →", "step of the tour"))),
    element("p", {class: "controls"}, button("Close", close, {class: "main", autofocus: true}))));
}
at("help").addEventListener("click", showHelp);

views.forEach((view, i) => {
  if (view.id === "match") at("tabs").append(element("span", {class: "gap"}));
  const tab = button(view.name, () => go(view.id), {title: "key " + keyed[i]});
  tab.dataset.view = view.id;
  at("tabs").append(tab);
});
offerViews([{name: "Model", show: showModel, shows: () => Boolean(state.fit && state.ladder)},
  ...views.filter(({analysis}) => analysis).map(({name, show}) => ({name, show, shows: () => Boolean(state.analysis && state.fit && state.set && state.ladder)})),
  {name: "Calibrate", show: calibrationSummary, shows: hasCalibration}, {name: "History", show: showHistory, shows: hasHistory}]);
addEventListener("hashchange", open);
const linked = connected => showLink(connected, () => {
  endUpload();
  endImport();
  if (current && !current.analysis) draw();
});
linked(false);
takeDrops();
onUpload(() => {
  if (current?.id === "home") draw();
  refreshImport();
});
explainAlways([at("view"), at("model")]);
connect(linked);
