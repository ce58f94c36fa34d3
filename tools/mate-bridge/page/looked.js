// The candidate that is looked at: what it is, what the captures say of it, what it looks like.
import {make, button, choice} from "./elements.js";
import {withUnit, short, tenths, px, chance, sizeWords, stateWords, stateName} from "./words.js";
import {figure, drawAdded, drawShift, colours, enlargement, enlargedWords} from "./canvas.js";
import {state, act} from "./state.js";

let shownCamera = 0;

export function detail(candidate, questions, again) {
  const [name, place] = candidate.label.split("@"), effect = state.set.effects.find(one => one.name === name);
  const parts = [make("h2", {}, candidate.label), make("p", {}, effect ? sentenceOf(effect.what) : "", make("span", {class: "soft"},
    " " + (place === "all" ? "Everywhere." : "At " + place + ".")))];
  if (effect) {
    parts.push(make("p", {}, make("code", {}, effect.formula)), make("p", {class: "soft"}, "Plausible (1 sigma): " +
      effect.unknowns.map(({name: unknown, sigma, unit}) => unknown + " ± " + withUnit(short(sigma), unit)).join(", ") + "."));
  }
  const facts = [[stateName(candidate.state), stateWords[candidate.state]]];
  if (candidate.why) facts.push(["why", candidate.why]);
  if (candidate.state !== "no-data") {
    facts.push(["size", candidate.sizes.map(sizeWords).join(", ") + (candidate.plausible ? "" : ": larger than plausible")]);
    facts.push(["noticeable", candidate.sizes.map(({detectable, unit}) => detectable === null ? "–" : withUnit(short(detectable), unit)).join(", ") +
      " and more is noticed in 9 of 10 cases"]);
    if (candidate.pValue !== null) facts.push(["by chance", chance(candidate.pValue)]);
    facts.push(["power", Math.round(100 * candidate.power) + " % to be noticed if as large as plausible"]);
    facts.push(["not imitated", Math.round(100 * candidate.kept) + " % of it; the rest other unknowns could do as well"]);
  }
  if (candidate.equivalent.length) facts.push(["like it", "these captures cannot tell it from " + candidate.equivalent.join(", ")]);
  parts.push(make("dl", {class: "facts"}, ...facts.flatMap(([term, words]) => [make("dt", {}, term), make("dd", {}, words)])));
  if (candidate.state !== "no-data") parts.push(make("p", {}, button("Add " + candidate.label, () => act({do: "add", label: candidate.label}), {class: "main"})));
  if (candidate.imprint) parts.push(...imprintOf(candidate.imprint, questions, again));
  if (candidate.added) parts.push(...addedOf(candidate, questions));
  return parts;
}

const sentenceOf = text => text.charAt(0).toUpperCase() + text.slice(1) + ".";

// What it would do to these captures were they perfect otherwise.
function imprintOf(imprint, {pictures, cameras}, again) {
  const names = Object.keys(cameras).filter(camera => imprint.pictures.some(({picture}) => pictures[picture].camera === camera));
  if (!names.length) return [];
  const camera = names[Math.min(shownCamera, names.length - 1)], {width: full, height: tall} = cameras[camera];
  const seen = imprint.pictures.filter(({picture}) => pictures[picture].camera === camera)[0];
  const caption = make("figcaption");
  const drawn = figure({
    height: width => width * tall / full, label: "what the effect would do to capture " + pictures[seen.picture].capture,
    draw: (context, width, height) => {
      const scale = width / full, enlarged = enlargement(seen.corners.map(([, , du, dv]) => scale * Math.hypot(du, dv)), 0.1 * width);
      context.fillStyle = colours.panel;
      context.fillRect(0, 0, width, height);
      caption.textContent = "capture " + pictures[seen.picture].capture + ", " + camera + " camera: " + px(seen.before) +
        " rms, " + px(seen.after) + " once the model without it is fitted; " + enlargedWords(enlarged);
      return seen.corners.map(corner => {
        const [, , du, dv, left, down] = corner;
        return {...drawShift(context, scale, enlarged, corner), tip: () => "shifted by " + px(Math.hypot(du, dv)) +
          ", after refitting " + px(Math.hypot(left, down))};
      });
    },
  });
  return [make("h3", {}, "What it would look like"), make("p", {class: "soft"}, make("span", {class: "key before"}), " shift of the corners, as large as " +
    (imprint.found ? "found" : "plausible") + "; ", make("span", {class: "key after"}), " what is left after refitting: only that can give it away."),
    names.length > 1 ? choice("camera", names.map((text, i) => ({value: String(i), text})), String(shownCamera), value => { shownCamera = Number(value); again(); }) : null,
    make("figure", {}, drawn, caption)];
}

// A point per pose; the slope is the size.
function addedOf({label, added}, {poses}) {
  const tipOf = ([pose, , y]) => "pose " + poses[pose].name + "\nmeasured " + tenths(y) + " sigma that way";
  const drawn = figure({height: 240, label: "what each pose says about " + label,
    draw: (context, width, height) => drawAdded(context, width, height, added, tipOf)});
  return [make("h3", {}, "What each pose says"), make("p", {class: "soft"}, "Convincing: many poses along a line that is not flat."), drawn];
}
