"use strict";
// What every page needs: its data, elements, numbers in words, the note beside the pointer, text to copy.

const at = id => document.getElementById(id);
const data = JSON.parse(at("data").textContent);

function element(tag, className, text) {
  const result = document.createElement(tag);
  if (className) result.className = className;
  if (text !== undefined) result.textContent = text;
  return result;
}

// The value with as many digits as its error bar deserves.
function withError(value, halfWidth, unit) {
  const digits = Math.min(6, Math.max(0, 1 - Math.floor(Math.log10(halfWidth || 1))));
  return value.toFixed(digits).replace("-", "−") + " ± " + halfWidth.toFixed(digits) + " " + unit;
}

const px = value => value.toFixed(Math.abs(value) < 10 ? 2 : 1) + " px";

// Three digits at most, with a real minus; a dash for what is not known.
const short = value => value === null ? "–" : String(Number(value.toPrecision(3))).replace("-", "−");
const tenths = value => (Math.round(10 * value) / 10 || 0).toFixed(1).replace("-", "−"); // never −0.0
const withUnit = (text, unit) => unit.startsWith("°") || !unit ? text + unit : text + " " + unit;

// "p = 0.02"
const chance = p => p < 0.001 ? "p < 0.001" : "p = " + Number(p.toPrecision(2));

// "0.80 px to the right, 0.30 px down"
const direction = ([x, y]) =>
  px(Math.abs(x)) + (x < 0 ? " to the left, " : " to the right, ") + px(Math.abs(y)) + (y < 0 ? " up" : " down");

const lengthOf = ([x, y]) => Math.hypot(x, y);
const mean = values => values.reduce((a, b) => a + b, 0) / values.length;

// The value that a share of the values does not exceed; 0 when there are none.
function quantile(values, share) {
  const sorted = Float64Array.from(values).sort();
  return sorted.length ? sorted[Math.floor(share * (sorted.length - 1))] : 0;
}

function showTip(event, text) {
  const tip = at("tip");
  tip.hidden = false;
  tip.textContent = text;
  tip.style.left = Math.max(4, Math.min(event.clientX + 14, innerWidth - tip.offsetWidth - 8)) + "px";
  tip.style.top = (event.clientY + 18 + tip.offsetHeight < innerHeight ? event.clientY + 18
                                                                     : event.clientY - tip.offsetHeight - 12) + "px";
}

const hideTip = () => { at("tip").hidden = true; };

// The note `text` beside the pointer while it is over `part`.
function tipOver(part, text) {
  for (const event of ["pointermove", "pointerdown"]) part.addEventListener(event, where => showTip(where, text));
  part.addEventListener("pointerleave", hideTip);
}

// Text to take along: a box that copies itself.
function copyBox(title, text) {
  const frame = element("div", "copy"), button = element("button", "", "copy");
  const box = element("textarea");
  box.readOnly = true;
  box.spellcheck = false;
  box.value = text;
  box.rows = text.split("\n").length;
  button.type = "button";
  button.addEventListener("click", () => {
    box.select();
    button.textContent = document.execCommand("copy") ? "copied" : "press Ctrl-C";
  });
  box.setAttribute("aria-label", title);
  const head = frame.appendChild(element("p", "", title));
  head.append(button);
  frame.append(box);
  return frame;
}

// The head of a page: the headline, a sentence, figures to remember, and what to beware of.
function showVerdict(sentence, warnings) {
  at("headline").textContent = document.title = data.headline;
  at("sentence").textContent = sentence;
  for (const {figure, sentence} of data.facts) {
    const fact = at("facts").appendChild(element("div"));
    fact.append(element("dt", "", figure), element("dd", "", sentence));
  }
  warnings.forEach(warning => at("warnings").append(element("li", "", warning)));
}
