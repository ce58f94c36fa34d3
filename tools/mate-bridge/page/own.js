// Own effect: a correction of a joint's angle typed as an expression, checked by the bridge as it is typed.
import {make, button, choice, renew} from "./elements.js";
import {send, on} from "./connection.js";
import {state, act} from "./state.js";

const draft = {name: "kneeCable", at: "LKneePitch", correction: "a*sin(3*q) + b*abs(tau)", unknowns: "a rad 0.01\nb rad/Nm 0.005"};
let number = 0, showAnswer = () => {}, recheck = () => {};

export function ownFrom(effect) {
  Object.assign(draft, {name: effect.name, at: effect.at, correction: effect.correction,
    unknowns: Object.entries(effect.unknowns).map(([name, {unit, sigma}]) => name + " " + unit + " " + sigma).join("\n")});
}

// {a: {unit, sigma}} of lines "a rad 0.01".
function unknownsOf(text) {
  const result = {};
  for (const line of text.split("\n")) {
    const [name, unit, sigma] = line.trim().split(/\s+/);
    if (name) result[name] = {unit: unit || "", sigma: sigma === undefined || isNaN(Number(sigma)) ? null : Number(sigma)};
  }
  return result;
}
const effectOf = () => ({name: draft.name, at: draft.at, correction: draft.correction, unknowns: unknownsOf(draft.unknowns)});

// Whether that is the draft as it stands.
function isDraft({name, at, correction, unknowns}) {
  const typed = effectOf(), wanted = Object.entries(typed.unknowns);
  return name === typed.name && at === typed.at && correction === typed.correction && wanted.length === Object.keys(unknowns).length &&
    wanted.every(([key, {unit, sigma}]) => unknowns[key] && unknowns[key].unit === unit && unknowns[key].sigma === sigma);
}

on("fit", () => recheck()); // it may be in the model now
on("checked", answer => { if (answer.number === number) showAnswer(answer); });

export function showOwn(parent) {
  const verdict = make("p", {id: "ownVerdict", role: "status"}), pointer = make("pre", {id: "ownPointer", "aria-hidden": "true"});
  const add = button("Add to the model", () => act({do: "define", effect: effectOf()}), {class: "main", disabled: true, id: "ownAdd"});
  const check = () => { send({do: "check", number: ++number, effect: effectOf()}); };
  recheck = () => { if (add.isConnected) check(); };
  const field = (label, key, element) => {
    element.value = draft[key];
    element.id = "own-" + key;
    element.addEventListener("input", () => { draft[key] = element.value; add.disabled = true; check(); });
    return make("div", {class: "field"}, make("label", {for: element.id}, label), element);
  };
  const correction = make("input", {type: "text", spellcheck: "false", autocomplete: "off", class: "code", "aria-describedby": "ownVerdict"});
  showAnswer = ({ok, sentence, letter}) => {
    const wrongHere = !ok && letter !== undefined, isIn = ok && state.set.own.some(isDraft) && (draft.at === "*" || state.fit.with.includes(draft.name + "@" + draft.at));
    add.disabled = !ok || isIn;
    correction.setAttribute("aria-invalid", String(wrongHere));
    verdict.className = ok ? "good" : "bad";
    verdict.textContent = isIn ? "✓ This is there already." : ok ? "✓ This can be added." : "✗ " + sentence;
    pointer.replaceChildren(...(wrongHere ? [" ".repeat(letter), make("mark", {}, "^"), " letter " + (letter + 1)] : [" "]));
  };
  const joints = choice("", [{value: "*", text: "every joint (*)"}, ...state.set.joints.map(value => ({value, text: value}))], draft.at,
    value => { draft.at = value; check(); }).querySelector("select");
  joints.id = "own-at";
  const text = make("input", {type: "text", spellcheck: "false", autocomplete: "off"});
  renew(parent,
    make("h1", {}, "An effect of your own"),
    make("p", {class: "soft"}, "What is added to a joint's true angle [rad], as an expression; it must be 0 where its unknowns are 0. It may use ",
      ...["q", "qd", "tau", "approach", "T", "t", "current"].flatMap(name => [make("code", {}, name), " "]),
      "of that joint (angle [rad], speed [rad/s], torque [Nm], sense of approach, temperature [°C], time [s], current [A]), any joint by its name, ",
      make("code", {}, "tau_"), "JOINT, ", make("code", {}, "imu_x imu_y com_x com_y"), ", and sin, cos, abs, sqrt, exp, sign …"),
    make("div", {class: "form"},
      field("Name", "name", text),
      make("div", {class: "field"}, make("label", {for: "own-at"}, "At"), joints),
      field("Correction [rad]", "correction", correction), make("div", {class: "field"}, make("span"), make("div", {}, pointer, verdict)),
      field("Unknowns: name, unit, how large it plausibly is", "unknowns", make("textarea", {rows: "3", spellcheck: "false", class: "code"})),
      make("div", {class: "field"}, make("span"), add)),
    ...mine());
  check();
}

function mine() {
  const {own} = state.set;
  if (!own.length) return [];
  return [make("h2", {}, "Yours"), make("ul", {class: "terms"}, ...own.map(effect => make("li", {},
    make("span", {}, make("b", {}, effect.name + "@" + effect.at), " ", make("code", {}, "+" + effect.correction)),
    button("edit", () => { ownFrom(effect); showOwn(document.getElementById("view")); }, {class: "small"}))))];
}
