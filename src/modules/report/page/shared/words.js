// Numbers in words.

const minus = text => text.replace("-", "−");

export const withUnit = (text, unit) => !unit ? text : unit.startsWith("°") ? text + unit : text + " " + unit;

// The value with as many digits as its error bar deserves.
export function withError(value, sigma, unit = "") {
  const digits = Math.min(6, Math.max(0, 1 - Math.floor(Math.log10(Math.abs(sigma) || 1))));
  return withUnit(minus(value.toFixed(digits)) + " ± " + sigma.toFixed(digits), unit);
}

export const sizeWords = ({name, value, sigma, unit, told}) =>
  told === false || value === null || sigma === null ? name + " undetermined" : name + " = " + withError(value, sigma, unit);

export const px = value => minus(value.toFixed(Math.abs(value) < 10 ? 2 : 1)) + " px";

// Three digits at most; a dash for what is not known.
export const short = value => value === null || value === undefined || !isFinite(value) ? "–"
  : minus(String(Number(value.toPrecision(3))));
export const tenths = value => minus((Math.round(10 * value) / 10 || 0).toFixed(1)); // never −0.0
export const number = value => minus(String(value));

// "p = 0.02"
export const chance = p => p < 0.001 ? "p < 0.001" : "p = " + Number(p.toPrecision(2));

// "0.80 px to the right, 0.30 px down"
export const direction = (x, y) =>
  px(Math.abs(x)) + (x < 0 ? " to the left, " : " to the right, ") + px(Math.abs(y)) + (y < 0 ? " up" : " down");

export const mean = values => values.reduce((a, b) => a + b, 0) / values.length;

// The value that a share of the values does not exceed; 0 when there are none.
export function quantile(values, share) {
  const sorted = Float64Array.from(values).sort();
  return sorted.length ? sorted[Math.floor(share * (sorted.length - 1))] : 0;
}

export const stateWords = {
  "present": "the captures need it",
  "aliased": "explains as much, but one that these captures cannot tell from it was taken",
  "trivial": "there, but too small to matter",
  "absent": "would have been seen if it were as large as it plausibly is",
  "inconclusive": "might be there without being seen",
  "absorbed": "these poses cannot test it: other unknowns imitate it, or hardly anything moves it",
  "no-data": "cannot be tested: what drives it was not recorded",
};

export const driverWords = name => name === "t" ? "time" : name === "approach" ? "how it was approached"
  : name === "T" ? "its temperature" : name === "qd" ? "its speed"
  : name.startsWith("tau_") ? "the torque on " + name.slice(4) : "the angle of " + name;

export const bold = text => Object.assign(document.createElement("b"), {textContent: text});
