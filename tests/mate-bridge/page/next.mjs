// Captures leave candidates open; the panel suggests poses, plays them on the connected robot after a confirmation, and
// opens the robot's recording.
// Proves the workflow from suggestion to new captures, across panel, bridge, library and robot process.
// Usage: node next.mjs NAOCAL NAOCAL-ROBOT MATE-BRIDGE NODE_MODULES CONFIGURATION PICTURES
import {existsSync, readdirSync, readFileSync} from "node:fs";
import {join} from "node:path";
import {tools, check, happens, panelOf, run, folder, quietPage, livePicture, portrait, end} from "./browser.mjs";
import {robotIn} from "./robotHere.mjs";

const [, , naocal, robotProgram, bridge, modules, configuration, pictures] = process.argv;
const {launch, axe} = tools(modules), here = folder();
run(naocal, "simulate", join(here, "few"), "--hidden-flaw", "--flaw-scale", "0.3", "--poses", "6", "--samples", "2", "--repeat-kind", "reapproach", "--offset-degrees", "0.5", "--seed", "1");
const robot = robotIn(here, robotProgram, configuration, {offsetRangeDegrees: 0.5});
const panel = await panelOf(bridge, join(here, "few"), "--robot", await robot.start()), browser = await launch();
const page = await quietPage(browser, panel.address), tab = name => page.getByRole("button", {name, exact: true}).click();
const idle = () => page.waitForFunction(() => document.getElementById("work").textContent === "");

await page.getByRole("heading", {name: "Where the prediction fails"}).waitFor();
await idle();
await tab("Calibrate"); // watches the robot
await livePicture(page);
await tab("Next poses");
await page.getByLabel("How many").selectOption("2");
await page.getByRole("button", {name: "Suggest poses"}).click();
await happens(page.locator("figure figcaption", {hasText: "foot, sees"}).nth(1).waitFor(), "poses are suggested");
await portrait(page, axe, pictures, "next-with-robot");
await page.getByRole("button", {name: /^Play on/}).click();
await portrait(page, axe, pictures, "next-confirm");
await page.getByRole("button", {name: "Play", exact: true}).click();
await page.locator("#stop.moving").waitFor();
await tab("Next poses");
check(await page.getByRole("button", {name: /^Play on/}).isDisabled(), "no poses are played on a robot that calibrates");
await tab("Calibrate");

// The robot asks to be held while changing its support feet, and to be released before its poses.
for (const words of [/going to stand on its .* foot/, /lies flat, let go/, /back onto both feet/]) {
  await page.getByText(words).first().waitFor();
  if (words.test("lies flat, let go")) check(await page.getByText("Hold the robot by its trunk").count() === 0, "who is to let go is not told to hold on");
  await happens(page.waitForFunction(() => document.activeElement?.matches("dialog.asks > p")), "the robot's question has the focus, but not its answer");
  await page.screenshot({path: join(pictures, "calibrate-question.png"), fullPage: true});
  await page.getByRole("button", {name: "Confirm"}).click();
}
await page.getByRole("heading", {name: /^(Finished|Failed)$/}).waitFor();
check(await page.getByRole("heading", {name: "Finished"}).count() === 1, "the robot took them: " + await page.getByRole("heading", {name: /^(Finished|Failed)$/}).locator("xpath=following-sibling::p[1]").innerText());
const sessions = readdirSync(join(here, "recordings")).map(name => join(here, "recordings", name, "first")).filter(path => existsSync(join(path, "captures.json")));
const taken = sessions.length ? JSON.parse(readFileSync(join(sessions.at(-1), "captures.json"))).captures : [];
check(new Set(taken.map(({pose}) => pose)).size === 2 && taken.length >= 8, "both poses are recorded: " + taken.length + " captures");

// Opens the recording.
await tab("Files");
await page.getByLabel("path of what to open").fill(sessions.at(-1) ?? "");
await page.getByRole("button", {name: "Open", exact: true}).click();
await page.getByRole("heading", {name: "Where the prediction fails"}).waitFor();
await tab("Files");
await happens(page.getByText("Open now: " + sessions.at(-1)).waitFor(), "and the recording is opened");

// Opens captures and requests applying their result to the robot.
async function toApply(name) {
  await tab("Files");
  await page.getByLabel("path of what to open").fill(join(here, name));
  await page.getByRole("button", {name: "Open", exact: true}).click();
  await page.getByRole("heading", {name: "Where the prediction fails"}).waitFor();
  await tab("Result");
  await page.getByRole("button", {name: /^Apply to .* …/}).click();
}

// Applies a result to the robot: new values are listed beside the present ones.
await toApply("few");
const changes = page.locator(".confirm tbody tr");
await page.waitForFunction(() => !/–/.test(document.querySelector(".confirm table")?.innerText ?? "–"));
const told = await changes.allInnerTexts();
check(told.some(row => row.startsWith("lKneePitch")) && told.some(row => row.startsWith("top camera")), "what would be set is listed beside what is there: " + told.join("; "));
check(await page.getByText("These captures are of head synthetic-1 and body synthetic-1").count() === 1, "the question says whose captures they are");
check(told.some(row => row.startsWith("lHipYawPitch")) === told.some(row => row.startsWith("rHipYawPitch")), "one motor, one offset");
await portrait(page, axe, pictures, "apply");
await page.getByRole("button", {name: /^Apply to/}).last().click();
await page.getByText(/^Sent to/).waitFor();
await tab("Configuration");
await page.getByLabel("filter modules").fill("JointCalibrationProvider");
await page.getByRole("button", {name: "Motion.JointCalibrationProvider", exact: true}).click();
await page.getByLabel("lKneePitch", {exact: true}).waitFor();
const knee = Number(told.find(row => row.startsWith("lKneePitch")).split("\t").at(-1).replace("−", "-").replace("°", ""));
await page.waitForFunction(wanted => Math.abs(Number(document.getElementById("parameter-lKneePitch")?.value) - wanted) < 0.006, knee);
check(knee !== 0, "and is on the robot then: " + knee + "°");
const had = told.find(row => row.startsWith("lKneePitch")).split("\t").at(-2);
await tab("Result");
await page.getByRole("button", {name: "Put back …"}).click();
check((await changes.allInnerTexts()).find(row => row.startsWith("lKneePitch")).split("\t").at(-1) === had, "what it had can be put back: " + had);
await page.getByRole("button", {name: /^Put back on/}).click();
await tab("Configuration");
await happens(page.waitForFunction(wanted => Math.abs(Number(document.getElementById("parameter-lKneePitch")?.value) - wanted) < 0.006, Number(had.replace("−", "-").replace("°", ""))), "and is on the robot again");

// Captures of another robot cause a warning.
run(naocal, "simulate", join(here, "strangers"), "--poses", "6", "--samples", "2", "--seed", "2");
await toApply("strangers");
const warning = page.locator(".confirm .bad");
check(/head synthetic-2 and body synthetic-2, but .* has another head and body/.test(await warning.innerText()), "another robot's captures are warned of: " + await warning.innerText());
await browser.close();
await panel.stop("SIGTERM");
robot.kill();
end();
