// Entry point of the diagnosis page.
import {at, copyBox, element} from "naocal/lib/dom.js";
import {captureNames} from "naocal/lib/captures.js";
import {errorLadder} from "naocal/plots/error-ladder.js";
import {partialResiduals, partialWords} from "naocal/plots/partial-residuals.js";
import {views} from "naocal/views/views.js";
import {showCandidates, untested} from "naocal/pages/candidates.js";
import {readData, showContents, showHead} from "naocal/pages/head.js";

/** @import {Diagnosis, Step} from "naocal/lib/types.js" */

/** @type {Diagnosis} */
const data = readData();

const nameOf = (/** @type {Step} */ {added, dropped}) => added && "+ " + added + dropped.map(label => " − " + label).join("");

function command() {
  if (!data.suggested.length || data.tentative) return "";
  return data.own ? copyBox("Calibrate with the suggested effects (SET: the captures' folder; model.json: the text below the first curve):",
    "naocal solve SET --model model.json -o result.json")
    : copyBox("Calibrate with the suggested effects (SET: the captures' folder):",
      "naocal solve SET --with " + data.suggested.join(",") + " -o result.json");
}

/** @param {"candidates" | "misfit"} about */
function sections(about) {
  return views.filter(view => view.about === about).flatMap(({title, show}) => {
    const parts = show(data, {});
    return parts ? [element("section", {}, element("h2", {}, title), ...parts)] : [];
  });
}

showHead(data);
at("overLadder").hidden = !data.steps.length; // nothing could be fitted
at("scaled").hidden = data.unit === "px";
at("overCandidates").hidden = at("overUntested").hidden = !data.candidates.length;
if (data.steps.length) at("ladder").append(errorLadder(data.steps.map(step => ({...step, name: nameOf(step)})), {floorName: data.floorName, unit: data.unit}), command());
at("overCauses").hidden = !data.causes.length;
if (data.verdict === "adequate") at("causesTitle").textContent = "Certain, but too small to matter";
const {capturesName} = captureNames(data);
at("causes").append(element("p", {}, partialWords), ...data.causes.map(cause => partialResiduals(cause, {nameOf: capturesName})));
showCandidates(data.candidates);
at("candidateViews").append(...sections("candidates"));
at("untested").append(untested(data.candidates));
at("overNext").hidden = !data.next;
if (data.next) at("next").textContent = data.next.poses
  ? data.next.poses + " poses are proposed in the diagnosis file: measuring in them " + data.next.why + "."
  : "naocal diagnose SET --next poses.json proposes poses: measuring in them " + data.next.why + ".";
at("misfitViews").append(...sections("misfit"));
showContents();
