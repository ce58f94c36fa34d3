// Reads what a person reads of one set on every screen: terminal, Python, reports, and the panel's Compare, Learn, Result
// and ladder. All must tell the same first finding and the same numbers, and nothing may contradict it.
// Correctness is not tested.
// Usage: node screens.mjs NAOCAL MATE-BRIDGE NODE_MODULES PYTHONPATH [SET...]; without sets, six simulated robots.
import {spawnSync} from "node:child_process";
import {readFileSync, writeFileSync} from "node:fs";
import {join} from "node:path";
import {pathToFileURL} from "node:url";
import {tools, check, panelOf, run, folder, quietPage, patientPage, end} from "./browser.mjs";

const [, , naocal, bridge, modules, python, ...given] = process.argv;
const here = folder(), sets = given.length ? given : simulated();

function simulated() {
  const set = (name, ...options) => { run(naocal, "simulate", join(here, name), ...options); return join(here, name); };
  writeFileSync(join(here, "arm.urdf"), `<robot name="arm"><link name="base"/><link name="upper"/><link name="fore"/><link name="hand"/>
${[["pan", "base", "upper", "0 0 0.3", "0 0 1"], ["lift", "upper", "fore", "0.1 0 0", "0 1 0"], ["elbow", "fore", "hand", "0.4 0 0", "0 1 0"]].map(([name, parent, child, xyz, axis]) =>
    `<joint name="${name}" type="revolute"><parent link="${parent}"/><child link="${child}"/><origin xyz="${xyz}"/><axis xyz="${axis}"/><limit lower="-2" upper="2" velocity="3" effort="1"/></joint>`).join("\n")}</robot>`);
  writeFileSync(join(here, "scene.json"), JSON.stringify({format: "naocal-scene", version: 1, robot: {urdf: "arm.urdf"}, trackers: {laser: {sigma: 0.0002, about: {x: 2, y: 0.3, z: 1, yaw: 3}}},
    markers: [{id: "a", link: "hand", about: [0.1, 0.05, 0.02]}, {id: "b", link: "hand", about: [-0.03, 0.04, 0.1]}]}));
  const arm = ["--robot", join(here, "arm.urdf"), "--scene", join(here, "scene.json"), "--poses", "24", "--samples", "1"];
  return [set("sound", "--poses", "12", "--samples", "2", "--seed", "1"), set("soft", "--poses", "14", "--samples", "2", "--seed", "2", "--flaw", "elasticity@LKneePitch"),
    set("loose", "--poses", "14", "--samples", "2", "--repeat-kind", "reapproach", "--seed", "3", "--flaw", "hysteresis@LHipPitch"), set("displaced", "--poses", "12", "--samples", "2", "--seed", "4", "--displaced-board"),
    set("eccentric", ...arm, "--seed", "5", "--flaw", "encoderEccentricity@lift"), set("reversed", ...arm, "--seed", "6", "--flaw", "reversedJoint@elbow")];
}

const {launch} = tools(modules), browser = await launch();
const squeezed = text => text.replace(/\s+/g, " ").replaceAll("−", "-").trim();
const textOf = async locator => squeezed((await locator.allInnerTexts()).join(" "));
// A headline and the sentence after it, as one: pages break the sentence of a finding at its first colon or full stop.
const lettersOf = text => squeezed(text).toLowerCase().replace(/[^a-z0-9@±°.-]+/g, " ").replace(/\.( |$)/g, " ").trim();
const says = (screen, text, sentence) => check(lettersOf(text).includes(lettersOf(sentence)), screen + " says \"" + sentence.slice(0, 90) + "\"" + (lettersOf(text).includes(lettersOf(sentence)) ? "" : "; found \"" + squeezed(text).slice(0, 400) + "\""));

/** What the terminal prints, and the file that it writes. */
function told(command, set, file) {
  const {stdout, status} = spawnSync(naocal, [command, set, command === "solve" ? "-o" : "--json", file], {encoding: "utf8", maxBuffer: 1e8});
  check(status === 0 || status === 3, command + " ends with 0 or 3");
  return {text: squeezed(stdout), document: JSON.parse(readFileSync(file, "utf8"))};
}

/** Sentences of all findings in Python. */
function inPython(set) {
  const script = "import json, sys, naocal\ncaptures = naocal.read_captures(sys.argv[1])\nprint(json.dumps([naocal.solve(captures).findings, naocal.diagnose(captures).findings]))";
  const {stdout, stderr, status} = spawnSync("python3", ["-c", script, set], {encoding: "utf8", env: {...process.env, PYTHONPATH: python}, maxBuffer: 1e8});
  return status === 0 ? JSON.parse(stdout) : stderr;
}

/** A report's head, and all its findings. */
async function reported(file) {
  const page = await patientPage(browser), report = file + ".html";
  run(naocal, "report", file, "-o", report);
  await page.goto(pathToFileURL(report).href);
  await page.locator("#headline").waitFor();
  await page.locator("details.notes").evaluateAll(all => all.forEach(details => { details.open = true; }));
  const head = await textOf(page.locator("#headline")) + " " + await textOf(page.locator("#sentence")), findings = await textOf(page.locator(".findings li"));
  await page.close();
  return {head, findings};
}

/** What a view of the panel says on top, with its findings. */
async function shownIn(page, view, selector) {
  await page.evaluate(name => { location.hash = name; }, view);
  await page.locator(selector).first().waitFor();
  await page.locator("details.notes").evaluateAll(all => all.forEach(details => { details.open = true; }));
  return textOf(page.locator(selector).first());
}

const further = ({findings, sentence}) => findings.slice(1).filter(({why}) => !sentence.includes(why));
const levels = {stop: "do not use yet", act: "usable meanwhile", note: ""};
const verdicts = {stop: "do-not-use", act: "cause-missing", note: "good"};
const missingIn = ({findings}) => findings.filter(({id}) => id.startsWith("effect-missing:")).map(({id}) => id.slice(15));

for (const set of sets) {
  console.log("# " + set);
  const solved = told("solve", set, join(here, "result.json")), diagnosed = told("diagnose", set, join(here, "diagnosis.json"));
  const [result, diagnosis] = [solved.document, diagnosed.document];

  // Documents: the verdict is that of the first finding, and the two do not contradict one another.
  check(verdicts[result.findings[0].level] === result.verdict, "the result's verdict is that of its first finding");
  check((diagnosis.findings[0].level === "note") === (diagnosis.findings[0].id === "good"), "a diagnosis that asks for nothing calls the model good");
  if (result.verdict === "good") check(diagnosis.tentative || diagnosis.findings[0].level === "note" || /^(noise|accident)/.test(diagnosis.findings[0].id), "what solve calls good lacks nothing in diagnose: " + diagnosis.findings[0].id);
  if (diagnosis.findings[0].id === "good") check(result.verdict === "good" || false, "what diagnose calls good lacks nothing in solve: " + result.findings[0].id);
  const [found] = missingIn(diagnosis), [likely] = missingIn(result);
  if (found && likely && !diagnosis.tentative) says("solve's sentence", result.sentence, found);

  // Terminal, Python, reports.
  says("solve", solved.text, result.sentence);
  says("diagnose", diagnosed.text, diagnosis.sentence);
  for (const [document, {text}] of [[result, solved], [diagnosis, diagnosed]]) for (const {level, sentence} of further(document)) if (level !== "note") says("the terminal", text, sentence);
  const sentencesOf = findings => findings.map(({level, sentence}) => level + " " + sentence).join();
  const imported = inPython(set);
  check(Array.isArray(imported) && sentencesOf(imported[0]) === sentencesOf(result.findings) && sentencesOf(imported[1]) === sentencesOf(diagnosis.findings), "Python has the same findings" + (Array.isArray(imported) ? "" : ": " + imported));
  for (const [file, document] of [["result.json", result], ["diagnosis.json", diagnosis]]) {
    const report = await reported(join(here, file));
    says("the report of " + file, report.head, document.sentence);
    for (const {sentence} of further(document)) says("it", report.findings, sentence);
  }

  // The panel.
  const panel = await panelOf(bridge, set), page = await quietPage(browser, panel.address + "#compare");
  const unfitted = page.getByText("These captures could not be fitted");
  await page.waitForFunction(() => (document.querySelector(".finding") && !document.querySelector(".finding.searching")) || document.body.innerText.includes("could not be fitted"));
  if (await unfitted.count()) {
    says("the panel", await page.locator("body").innerText(), result.findings[0].why);
  } else {
    for (const view of ["compare", "learn"]) {
      const words = await shownIn(page, view, ".finding");
      says(view, words, diagnosis.sentence.replace(/^Undecided: |^Something is wrong with the captures or the set-up: /, ""));
      for (const {sentence} of further(diagnosis)) says(view, words, sentence);
      check((await textOf(page.locator(".finding .level"))) === levels[diagnosis.findings[0].level], view + " says whether it may be used: " + await textOf(page.locator(".finding .level")));
      check(!/no trend|nothing is missing/i.test(words) || diagnosis.findings[0].level === "note", view + " does not say that nothing is missing");
    }
    if (found) {
      await shownIn(page, "compare", ".finding");
      check(await page.getByRole("img", {name: "error without " + found}).count() > 0, "Compare's picture is of " + found);
    }
    const words = await shownIn(page, "result", ".verdict");
    says("Result", words, result.sentence);
    for (const {sentence} of further(result)) says("Result", words, sentence);
    const rung = squeezed(await page.locator(".ladder .rung").first().innerText()), floor = squeezed(await page.locator(".ladder .floor").first().innerText());
    const unit = diagnosis.errorUnit?.perPx ?? 1, shown = text => Number(text.match(/(-?[\d.]+) (px|mm|°)/)?.[1]);
    const step = diagnosis.steps[0], isNear = (text, expected) => Math.abs(shown(text) - unit * expected) <= 0.0006 * Math.max(1, unit * expected);
    check(isNear(rung, step.heldOutPx ?? step.rmsPx), "the ladder has the held-out error: " + rung + ", " + unit * (step.heldOutPx ?? step.rmsPx));
    check(isNear(floor, step.noiseFloorPx), "and the noise floor: " + floor + ", " + unit * step.noiseFloorPx);
  }
  await page.close();
  await panel.stop();
}
await browser.close();
end();
