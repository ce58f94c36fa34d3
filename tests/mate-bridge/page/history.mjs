// Drives the panel's history in a real browser: a recorded history with a fall and a jump is listed and plotted, a run
// opens in Compare, and captures that were moved are asked for and found. Proves that page and bridge work together; the
// rule for jumps is tested with its library. Runs of a connected robot are tested in robot.mjs.
// Usage: node history.mjs NAOCAL MATE-BRIDGE NODE_MODULES PICTURES
import {mkdirSync, readFileSync, readdirSync, renameSync, writeFileSync} from "node:fs";
import {execFileSync} from "node:child_process";
import {join} from "node:path";
import {tools, check, happens, panelOf, run, folder, quietPage, portrait, end} from "./browser.mjs";

const [, , naocal, bridge, modules, pictures] = process.argv;
const {launch, axe} = tools(modules), here = folder(), state = join(here, "state"), runs = join(state, "runs");
const days = ["2026-02-14", "2026-02-21", "2026-03-07", "2026-03-14"];

// Four calibrations of one robot; the last two after a fall that bent its knee by 2°.
mkdirSync(join(here, "nao/location"), {recursive: true});
for (const [i, day] of days.entries()) {
  const set = join(here, day), result = join(here, day + ".json");
  run(naocal, "simulate", set, "--poses", "10", "--samples", "2", "--seed", String(i + 1), "--robot-seed", "1");
  if (i >= 2) {
    const captures = JSON.parse(readFileSync(join(set, "captures.json"))), knee = captures.jointNames.indexOf("LKneePitch");
    for (const {joints} of captures.captures) joints.measured[knee] += 2 * Math.PI / 180;
    writeFileSync(join(set, "captures.json"), JSON.stringify(captures));
  }
  run(naocal, "solve", set, "-o", result);
  run(naocal, "apply", result, "--configuration", join(here, "nao"), "--state", state, "--body", "nao21", "--head", "nao21");
}
readdirSync(runs).sort().forEach((file, i) => { // four weeks instead of four seconds
  const one = JSON.parse(readFileSync(join(runs, file)));
  writeFileSync(join(runs, file), JSON.stringify({...one, time: days[i] + "T10:05:00Z"}));
});
run(naocal, "history", "nao21", "--state", state, "--fall", "2026-03-01 15:00");
const told = execFileSync(naocal, ["history", "nao21", "--state", state], {encoding: "utf8"}).split("\n")[0];

const panel = await panelOf(bridge, "--state", state);
const browser = await launch(), page = await quietPage(browser, panel.address);
await page.getByRole("button", {name: "History", exact: true}).click();
await page.locator("table.runs").waitFor();
check(await page.locator("p.sentence").innerText() === told, "the panel says what the terminal says: " + told);
check(told.includes("LKneePitch by +") && told.includes("with a fall in between"), "the knee's jump after the fall is found");
check(await page.locator("table.runs tbody tr").count() === 5, "four runs and a fall are listed");
const first = page.locator(".grid.history figcaption b").first();
check(await first.innerText() === "LKneePitch", "joints that jumped come first: " + await first.innerText());
await portrait(page, axe, pictures, "history");
await page.keyboard.press("7");
await page.keyboard.press("y");
await happens(page.locator("table.runs").waitFor(), "the key y shows the history");
await page.getByRole("button", {name: "open the run of " + days[0] + " 10:05 in Compare"}).click();
await happens(page.getByRole("heading", {name: "Where the prediction fails"}).waitFor(), "a run is opened in Compare");

// The captures are moved and renamed: the panel asks, and finds them by their content.
mkdirSync(join(here, "archive/2026/old/box"), {recursive: true});
renameSync(join(here, days[1]), join(here, "archive/2026/old/box/saturday"));
await page.getByRole("button", {name: "History", exact: true}).click();
await page.getByRole("button", {name: "open the run of " + days[1] + " 10:05 in Compare"}).click();
await happens(page.getByRole("heading", {name: "Where are the captures now?"}).waitFor(), "captures that were moved are asked for");
await portrait(page, axe, pictures, "missing");
await page.getByLabel("folder to search for the captures").fill(join(here, "archive"));
await page.getByRole("button", {name: "Look there"}).click();
await happens(page.getByRole("heading", {name: "Where the prediction fails"}).waitFor(), "they are found there and opened");
check((await page.locator("#notice").innerText()).includes("saturday"), "and it is said where they are: " + await page.locator("#notice").innerText());
await browser.close();
end();
