"use strict";
// What every page needs: its data, elements, numbers in words, and the note beside the pointer.

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

// "p = 0.02"
const chance = p => p < 0.001 ? "p < 0.001" : "p = " + Number(p.toPrecision(2));

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
