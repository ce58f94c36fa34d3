// Opens captures of robots with a URDF in the panel: readings of a tracker, contacts, corners of a camera on a wrist.
// Proves that each is fitted, tested and compared in its own unit, that views without anything to show are absent, and
// that no text speaks of pixels where there are none; mends a suspected set-up. Numbers are tested with the diagnosis.
// Usage: node readings.mjs NAOCAL MATE-BRIDGE NODE_MODULES PICTURES SETS; skipped (77) without the sets
import {existsSync, writeFileSync} from "node:fs";
import {join} from "node:path";
import {tools, check, happens, panelOf, folder, quietPage, portrait, run, skip, end} from "./browser.mjs";

const [, , naocal, bridge, modules, pictures, sets] = process.argv;
const tracked = join(sets, "plain-ur10-tracker"), seen = join(sets, "plain-ur10-wrist");
if (!existsSync(join(tracked, "captures.json"))) skip("there is no " + tracked);
const {launch, axe} = tools(modules), here = folder(), browser = await launch();
const tab = (page, name) => page.locator("#tabs").getByRole("button", {name, exact: true});
const opened = async set => {
  const panel = await panelOf(bridge, set), page = await quietPage(browser, panel.address, {viewport: {width: 1366, height: 900}});
  await page.getByRole("heading", {name: "Where the prediction fails"}).waitFor();
  return {panel, page};
};

const {panel, page} = await opened(tracked);
const words = () => page.evaluate(() => document.body.innerText);
await happens(page.getByRole("img", {name: "errors of positions of laser"}).waitFor(), "the errors of the tracker's positions are drawn");
check(await page.getByRole("img", {name: "errors in space: positions of laser"}).count() === 1, "and where they lie");
check(await page.getByRole("img", {name: /^errors against noise/}).count() === 2, "and how they compare with the noise");
check(await page.getByRole("img", {name: /corners/}).count() === 0 && await page.getByRole("heading", {name: "Captures", exact: true}).count() === 0, "there is no picture to show");
await page.locator("#errorY").selectOption({label: "along x [mm]"});
await page.locator("#overX").selectOption({label: "the angle of elbow_joint [°]"});
await happens(page.getByRole("img", {name: "error along x [mm] over the angle of elbow_joint [°]"}).waitFor(), "errors are drawn over any joint's angle");
check(!/\bpx\b/.test(await words()), "no text of Compare speaks of pixels");
await portrait(page, axe, pictures, "readings");
for (const [view, heading] of [["Learn", "Candidates"], ["Map", "Readings"], ["Result", /^Joint offset/]]) {
  await tab(page, view).click();
  await happens(page.getByRole("heading", {name: heading}).first().waitFor(), view + " is shown");
  check(!/\bpx\b/.test(await words()), "and speaks of no pixels");
}
check(/held.out|noise floor/.test(await page.locator("#model").innerText()) && / mm/.test(await page.locator("#model").innerText()), "the ladder is in millimetres");
await tab(page, "Next poses").click();
await page.getByLabel("How many").selectOption("2");
await page.getByRole("button", {name: "Suggest poses"}).click();
const posed = page.locator("figure figcaption", {hasText: ", measures "});
await happens(posed.nth(1).waitFor(), "poses are suggested for an arm");
check(await posed.count() === 2 && await page.locator("figure tbody tr", {hasText: "elbow_joint"}).count() === 2, "with the angles of its joints");
check(/Leave everything where it stands, record the poses as a new set/.test(await words()), "and it is said how to take them");
check(await page.getByRole("button", {name: /^Play on/}).count() === 0, "no robot plays them from here");
await portrait(page, axe, pictures, "next-arm");
await tab(page, "Files").click();
await page.locator("#compare").fill(tracked);
await page.getByRole("button", {name: "Compare", exact: true}).last().click();
await happens(page.getByText(/mm rms/).waitFor(), "a comparison is in millimetres");
check(/\d° rms/.test(await words()), "and in degrees");
await panel.stop();

const corners = await opened(seen);
await happens(corners.page.getByRole("img", {name: /^measured and predicted corners/}).first().waitFor(), "an arm's pictures are drawn");
check(await corners.page.getByRole("heading", {name: "Against the noise"}).count() === 0, "and no readings");
await corners.panel.stop();

// A suspected set-up is mended like an effect is added.
const mirrored = join(here, "mirrored"), scene = join(here, "scene.json");
writeFileSync(scene, JSON.stringify({format: "naocal-scene", version: 1, trackers: {laser: {sigma: 0.0002, about: {x: 2, y: 0.3, z: 1, yaw: 3}}},
  markers: [{id: "ball", link: "wrist_3_link", about: [0.1, 0.05, 0.02]}]}));
run(naocal, "simulate", mirrored, "--robot", join(tracked, "robot.urdf"), "--scene", scene, "--flaw", "reversedJoint@elbow_joint", "--poses", "24", "--samples", "1");
const wrong = await opened(mirrored);
await tab(wrong.page, "Learn").click();
const mend = wrong.page.getByRole("button", {name: "mend reversedJoint@elbow_joint", exact: true});
await happens(mend.waitFor(), "a joint that turns the other way is offered to be mended");
await portrait(wrong.page, axe, pictures, "mirrored");
await mend.click();
await happens(wrong.page.locator("#model").getByText("+ reversedJoint@elbow_joint").first().waitFor(), "and the ladder has it");
await happens(wrong.page.getByText(/^The model explains these captures/).first().waitFor(), "and then nothing is missing");
await wrong.panel.stop();

// The report of a folder.
const report = join(here, "report.html");
run(naocal, "report", tracked, "-o", report);
const shown = await quietPage(browser, "file://" + report);
await happens(shown.getByRole("img", {name: "errors in space: positions of laser"}).waitFor(), "the report of a folder draws its readings");
check(!/\bpx\b/.test(await shown.evaluate(() => document.body.innerText)), "and speaks of no pixels");
await shown.getByLabel("Errors with joint readings").selectOption("fitted");
check(await shown.locator("#joint").count() === 1, "with a choice of joints");
await browser.close();
end();
