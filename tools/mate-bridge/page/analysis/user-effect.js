// Custom effect: an expression that corrects a joint's angle, checked by the bridge while typing.
import {button, choice, element, renew} from "naocal/lib/dom.js";
import {on, send} from "../core/connection.js";
import {act, state} from "../core/state.js";

const draft = {name: "kneeCable", at: "LKneePitch", correction: "a*sin(3*q) + b*abs(tau)", unknowns: "a rad 0.01\nb rad/Nm 0.005"};
// Starting points: corrections that are 0 where their unknowns are 0.
const starts = [
  {text: "periodic in the angle", name: "gearRipple", correction: "a*sin(8*q) + b*(cos(8*q) - 1)", unknowns: "a rad 0.005\nb rad 0.005"},
  {text: "grows with the torque, either way", name: "cable", correction: "b*abs(tau)", unknowns: "b rad/Nm 0.005"},
  {text: "lags behind the motion", name: "friction", correction: "c*approach", unknowns: "c rad 0.005"},
  {text: "drifts with the temperature", name: "warmth", correction: "w*(T - 40)", unknowns: "w rad/K 0.0005"},
];
let number = 0, recheck = () => {};
/** @type {(answer: any) => void} */
let showAnswer = () => {};

export function draftFrom(effect) {
  Object.assign(draft, {name: effect.name, at: effect.at, correction: effect.correction,
    unknowns: Object.entries(effect.unknowns).map(([name, {unit, sigma}]) => name + " " + unit + " " + sigma).join("\n")});
}

// Parses lines "a rad 0.01" to {a: {unit, sigma}}.
function unknownsOf(text) {
  const result = {};
  for (const line of text.split("\n")) {
    const [name, unit, sigma] = line.trim().split(/\s+/);
    if (name) result[name] = {unit: unit || "", sigma: sigma === undefined || isNaN(Number(sigma)) ? null : Number(sigma)};
  }
  return result;
}
const effectOf = () => ({name: draft.name, at: draft.at, correction: draft.correction, unknowns: unknownsOf(draft.unknowns)});

// Whether an effect equals the draft.
function isDraft({name, at, correction, unknowns}) {
  const typed = effectOf(), wanted = Object.entries(typed.unknowns);
  return name === typed.name && at === typed.at && correction === typed.correction && wanted.length === Object.keys(unknowns).length &&
    wanted.every(([key, {unit, sigma}]) => unknowns[key] && unknowns[key].unit === unit && unknowns[key].sigma === sigma);
}

on("fit", () => recheck()); // the effect may now be in the model
on("checked", answer => { if (answer.number === number) showAnswer(answer); });

export function showUserEffect(parent) {
  const verdict = element("p", {id: "ownVerdict", role: "status"}), pointer = element("pre", {id: "ownPointer", "aria-hidden": "true"});
  const add = button("Add to the model", () => act({do: "define", effect: effectOf()}), {class: "main", disabled: true, id: "ownAdd"});
  const check = () => { send({do: "check", number: ++number, effect: effectOf()}); };
  recheck = () => { if (add.isConnected) check(); };
  const field = (label, key, input) => {
    input.value = draft[key];
    input.id = "own-" + key;
    input.addEventListener("input", () => { draft[key] = input.value; add.disabled = true; check(); });
    return element("div", {class: "field"}, element("label", {for: input.id}, label), input);
  };
  const correction = element("input", {type: "text", spellcheck: "false", autocomplete: "off", class: "code", "aria-describedby": "ownVerdict"});
  showAnswer = ({ok, sentence, letter}) => {
    const wrongHere = !ok && letter !== undefined, isIn = ok && state.set.own.some(isDraft) && (draft.at === "*" || state.fit.with.includes(draft.name + "@" + draft.at));
    add.disabled = !ok || isIn;
    correction.setAttribute("aria-invalid", String(wrongHere));
    verdict.className = ok ? "good" : "bad";
    verdict.textContent = isIn ? "✓ This is in the model already." : ok ? "✓ This can be added." : "✗ " + sentence;
    pointer.replaceChildren(...(wrongHere ? [" ".repeat(letter), element("mark", {}, "^"), " letter " + (letter + 1)] : [" "]));
  };
  const joints = choice("", [{value: "*", text: "every joint (*)"}, ...state.set.joints.map(value => ({value, text: value}))], draft.at,
    value => { draft.at = value; check(); }, "own-at").querySelector("select");
  const text = element("input", {type: "text", spellcheck: "false", autocomplete: "off"});
  renew(parent,
    element("h1", {}, "Custom effect"),
    element("p", {class: "soft"}, "A correction added to a joint's true angle [rad], as an expression; it must be 0 where its unknowns are 0. It may use ",
      ...["q", "qd", "tau", "approach", "T", "t", "current"].flatMap(name => [element("code", {}, name), " "]),
      "of that joint (angle [rad], speed [rad/s], torque [Nm], sense of approach, temperature [°C], time [s], current [A]), any joint by its name, ",
      element("code", {}, "tau_"), "JOINT, ", element("code", {}, "imu_x imu_y com_x com_y"), ", and sin, cos, abs, sqrt, exp, sign …"),
    element("p", {class: "controls"}, "Start from: ", ...starts.map(({text: words, ...start}) => button(words, () => { Object.assign(draft, start); showUserEffect(parent); }, {class: "small"}))),
    element("div", {class: "form"},
      field("Name", "name", text),
      element("div", {class: "field"}, element("label", {for: "own-at"}, "At"), joints),
      field("Correction [rad]", "correction", correction), element("div", {class: "field"}, element("span"), element("div", {}, pointer, verdict)),
      field("Unknowns: name, unit, plausible size (1 sigma)", "unknowns", element("textarea", {rows: "3", spellcheck: "false", class: "code"})),
      element("div", {class: "field"}, element("span"), add)),
    ...mine());
  check();
}

function mine() {
  const {own} = state.set;
  if (!own.length) return [];
  return [element("h2", {}, "Your effects"), element("ul", {class: "terms"}, ...own.map(effect => element("li", {},
    element("span", {}, element("b", {}, effect.name + "@" + effect.at), " ", element("code", {}, "+" + effect.correction)),
    button("edit", () => { draftFrom(effect); showUserEffect(document.getElementById("view")); }, {class: "small"}))))];
}
