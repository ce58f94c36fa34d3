// Drives naocal-robot with a simulated robot from the panel in a real browser: live pictures, a calibration of neck and
// cameras, its undo and its history, values over time, setting and saving a parameter, restart of the robot's process.
// Proves that panel, bridge and robot process work together, and saves screenshots of every view.
// Usage: node robot.mjs NAOCAL-ROBOT MATE-BRIDGE NODE_MODULES CONFIGURATION PICTURES
import {existsSync, readdirSync, readFileSync} from "node:fs";
import {join} from "node:path";
import {tools, check, happens, panelOf, folder, quietPage, livePicture, portrait, px, until, end} from "./browser.mjs";
import {robotIn} from "./robotHere.mjs";

const [, , robotProgram, bridge, modules, configuration, pictures] = process.argv;
const {launch, axe} = tools(modules), here = folder(), robot = robotIn(here, robotProgram, configuration);
const address = await robot.start();
const panel = await panelOf(bridge, "--robot", address), browser = await launch();
const opened = Date.now();
let page = await quietPage(browser, panel.address);
const tab = name => page.getByRole("button", {name, exact: true}).click();

await livePicture(page);
console.log("measured: from opening to the first live picture: " + (Date.now() - opened) + " ms");
await page.waitForTimeout(3000);
console.log("measured: cameras: " + (await page.locator(".camera figcaption").allInnerTexts()).join("; "));

await page.getByRole("button", {name: "Calibrate …"}).click();
check((await page.locator(".confirm").innerText()).includes("synthetic-1 (" + address + ")"), "the question names the robot: " + (await page.locator(".confirm").innerText()).replaceAll("\n", " "));
check(await page.locator(".robots").getByRole("button", {name: "synthetic-1 (" + address + ")"}).count() === 1, "so does the row of robots");
await portrait(page, axe, pictures, "calibrate-confirm");
await page.evaluate(() => { // records the page's requests
  const {send} = WebSocket.prototype;
  window.sent = [];
  WebSocket.prototype.send = function (text) { window.sent.push(JSON.parse(text)); send.call(this, text); };
});
const wills = () => page.evaluate(() => window.sent.filter(({settings}) => settings?.[0].key === "lastWill").map(({settings}) => settings[0].value.length).join());
await page.getByRole("button", {name: "Start", exact: true}).click();
await page.getByText(/pose [1-9] of/).waitFor();
await happens(page.getByText(/, \d+ of \d+ of this round/).waitFor(), "each pose is shown before it is played");
await page.locator(".thumbnails img").first().waitFor();
const found = page.locator(".camera figcaption").filter({hasText: "corners, predicted"}).first(); // not visible in every pose
await happens(found.waitFor(), "corners are found in the live pictures");
await page.screenshot({path: join(pictures, "calibrate-running.png")});
const listed = await page.locator(".thumbnails li").count(), drawn = await page.locator(".thumbnails img").count();
await tab("Configuration"); // captures are followed in other views too
await page.waitForTimeout(6000);
await tab("Calibrate");
await page.locator(".thumbnails li").nth(listed).waitFor();
const drawnMeanwhile = await page.locator(".thumbnails img").count() - drawn;
check(drawnMeanwhile > 0, "captures that were taken while another view was shown have their pictures: " + drawnMeanwhile);
await page.getByRole("heading", {name: /^(Finished|Failed)$/}).waitFor();
const bars = page.locator(".rung.flat"), before = px(await bars.nth(0).innerText()), after = px(await bars.nth(1).innerText());
check(await page.getByRole("heading", {name: "Finished"}).count() === 1 && after < 0.5 * before, "the robot is calibrated: " + before + " px before, " + after + " px after");
check(await wills() === "1,0", "a last will is made for the calibration, and ends with it: " + await wills());
await page.getByRole("rowheader", {name: "headPitch"}).waitFor();
const thumbnails = page.locator(".thumbnails li");
check(await thumbnails.count() > 20 && /corners on board/.test((await thumbnails.allInnerTexts()).join()), "captures are shown with what they are worth: " + await thumbnails.count());
check(await page.locator(".thumbnails img").count() + await page.locator(".thumbnails .blank").count() === await thumbnails.count(), "each with its picture or with the words that it has none: " + await page.locator(".thumbnails img").count() + " pictures");
await happens(page.getByRole("row", {name: /headPitch.*±/}).waitFor(), "offsets have their sigmas");
check(/%.*°C/s.test(await page.locator(".vitals").innerText()), "battery and temperature are shown: " + await page.locator(".vitals").innerText());
await portrait(page, axe, pictures, "calibrate-finished");
check(/never calibrated: errors up to \d+ px are plausible/.test((await page.locator(".rests").allInnerTexts()).join()), "a live comparison says what it rests on: " + (await page.locator(".rests").allInnerTexts()).join(" | "));

// Later pages show each capture's own picture and the previous values; a bridge started later has no pictures.
const bytesOf = one => one.evaluate(async () => {
  const list = [...document.querySelectorAll(".thumbnails img")];
  return Promise.all(list.map(async ({src}) => Array.from(new Uint8Array(await crypto.subtle.digest("SHA-256", await (await fetch(src)).arrayBuffer()))).join("")));
});
const known = await bytesOf(page), wasBefore = await page.getByRole("row", {name: /headPitch/}).innerText();
check(await page.evaluate(robot => fetch("taken/" + encodeURIComponent(robot + "/0/9999")).then(answer => answer.status), address) === 204, "a picture that went to another capture is absent, and no error");
check(new Set(known).size === known.length, "captures have pictures of their own: " + new Set(known).size + " of " + known.length);
await page.reload();
await page.locator(".thumbnails img").first().waitFor();
await page.getByRole("rowheader", {name: "headPitch"}).waitFor();
check((await bytesOf(page)).join() === known.join(), "after a reload each capture shows the same picture");
check(await page.getByRole("row", {name: /headPitch/}).innerText() === wasBefore && !wasBefore.includes("–"), "and the value of before: " + wasBefore);
const newcomer = await panelOf(bridge, "--robot", address), later = await quietPage(browser, newcomer.address);
await later.locator(".thumbnails .blank").first().waitFor();
check(await later.locator(".thumbnails img").count() === 0, "a bridge that comes later shows no picture in its place");
await later.screenshot({path: join(pictures, "calibrate-newcomer.png"), fullPage: true});
await later.close();
await newcomer.stop("SIGTERM");
await page.getByRole("button", {name: "Undo …"}).click();
await page.getByRole("button", {name: /^Undo on/}).click();
await happens(page.getByText("No offsets: joint readings are used as they are.").waitFor(), "undo takes the offsets back");
await happens(page.waitForFunction(() => [...document.querySelectorAll("button")].find(one => one.textContent === "Undo …")?.disabled), "what was taken back cannot be taken back again");

// The run came by the robot's socket: once, although two bridges of this user saw it, and with its undo.
await tab("History");
await happens(page.getByRole("cell", {name: /^kept, then undone/}).waitFor(), "the history has the calibration, and that it was undone");
check(await page.locator("table.runs tbody tr").count() === 1, "it is listed once");
check(/[\d.]+ px/.test(await page.locator("table.runs tbody tr").innerText()), "with its errors: " + (await page.locator("table.runs tbody tr").innerText()).replaceAll("\t", " "));
await portrait(page, axe, pictures, "history-robot");
await tab("Calibrate");
await page.getByRole("button", {name: "Open its captures"}).click();
await happens(page.getByRole("heading", {name: "Where the prediction fails"}).waitFor(), "the captures of a calibration are opened from where it ended");
await tab("Calibrate");

// Stop ends a calibration on press, from any view; so does the key s, but not Ctrl+S.
const begun = async () => {
  await tab("Calibrate");
  await page.getByRole("button", {name: "Calibrate …"}).click();
  await page.getByRole("button", {name: "Start", exact: true}).click();
  await page.getByRole("heading", {name: /^(Moving|Collecting|Going home)$/}).waitFor();
};
const wasEnded = async () => {
  await tab("Calibrate");
  await page.getByText("The calibration was ended").waitFor();
  await page.waitForFunction(() => !document.getElementById("stop").classList.contains("moving"));
};
await begun();
await tab("Compare");
const stop = await page.getByRole("button", {name: "Stop", exact: true}).boundingBox();
await page.mouse.move(stop.x + 5, stop.y + 5);
await page.mouse.down();
await happens(wasEnded(), "stop ends the calibration");
await page.mouse.up();
await begun();
await page.keyboard.press("Control+s");
await page.waitForTimeout(500);
check(await page.locator("#stop.moving").count() === 1, "Ctrl+S does not stop the robot");
await page.keyboard.press("S"); // as with Caps Lock
await happens(wasEnded(), "s stops it, whatever the state of Caps Lock");
await page.getByRole("button", {name: "Undo …"}).click(); // Undo stays enabled: an older calibration may be saved
await page.getByRole("button", {name: /^Undo on/}).click();
await happens(page.getByText(/^Nothing was taken back: /).waitFor(), "after a calibration that was ended the robot says whether there is something to take back");

// Closing the panel while the robot moves ends the calibration, as there is no Stop button any more.
const onlooker = await panelOf(bridge, "--robot", address), looked = await quietPage(browser, onlooker.address);
await looked.getByRole("button", {name: "Calibrate", exact: true}).click();
await begun();
await looked.getByRole("heading", {name: /^(Moving|Collecting|Going home)$/}).waitFor();
await page.close();
await looked.getByText("The calibration was ended").waitFor();
await looked.close();
await onlooker.stop("SIGTERM");
page = await quietPage(browser, panel.address);
await happens(wasEnded(), "a calibration ends when its panel is closed");

// Disconnecting a calibrating robot needs a confirmation; an invalid address stays editable.
await begun();
await page.getByLabel("disconnect from " + address).click();
await page.getByText("Without its panel it stops").waitFor();
await page.getByRole("button", {name: "Not now"}).click();
await page.getByRole("button", {name: "Stop", exact: true}).click();
await wasEnded();
await page.getByLabel("robot to connect to").fill("nao 21");
await page.getByRole("button", {name: "Connect", exact: true}).click();
await page.locator("#notice").getByRole("button", {name: "OK"}).click();
check(await page.getByLabel("robot to connect to").inputValue() === "nao 21", "a mistyped address stays where it was typed");
await page.getByLabel("robot to connect to").fill("");

// Values over time.
await tab("Live");
await page.getByLabel("filter values").fill("Motion.angles");
await page.getByLabel("Motion.angles").check();
await page.locator(".plot canvas").first().waitFor();
check((await page.locator("pre.value").first().innerText()).length > 20, "values are shown as they come");
await portrait(page, axe, pictures, "live");
const downloaded = async name => {
  const [file] = await Promise.all([page.waitForEvent("download"), page.getByLabel(name, {exact: true}).click()]);
  return readFileSync(await file.path());
};
await page.getByRole("button", {name: "LKneePitch", exact: true}).click();
check(await page.getByRole("button", {name: "LKneePitch", exact: true}).getAttribute("aria-pressed") === "true", "which numbers are drawn is chosen by name");
check((await downloaded("save as SVG: Motion.angles")).toString().includes("LKneePitch"), "a plot over time is saved as strokes");
check((await downloaded("save as PNG: Motion.angles")).subarray(1, 4).toString() === "PNG", "a plot over time is saved as a picture");
let rows = [];
await until(async () => (rows = (await downloaded("save as CSV: Motion.angles")).toString().trim().split("\n")).length > 50); // rows accumulate over time
check(rows[0].startsWith("time [s],HeadYaw,") && rows.length > 50 && rows.every(row => row.split(",").length === rows[0].split(",").length), "and as a table");

// Parameters are written only after a confirmation.
await tab("Configuration");
await page.getByLabel("filter modules").fill("CalibrationRunner");
await page.getByRole("button", {name: "Brain.CalibrationRunner", exact: true}).click();
await page.getByLabel("repeats", {exact: true}).fill("3");
await page.getByRole("button", {name: "set repeats"}).click();
await page.waitForFunction(() => document.getElementById("parameter-repeats")?.value === "3" && !document.querySelector(".edited"));
await portrait(page, axe, pictures, "configuration");
check(await page.locator("#parameter-run").count() === 0, "nothing moves the robot from its parameters");
await page.getByLabel("checkPoses", {exact: true}).fill('"many"');
await page.getByRole("button", {name: "set checkPoses"}).click();
await happens(page.getByText(/did not take checkPoses = "many"/).waitFor(), "a value that the robot refuses is said to be refused");
await page.locator("#notice").getByRole("button", {name: "OK"}).click();
const savedIn = folder => existsSync(join(here, folder)) && readdirSync(join(here, folder), {recursive: true}).filter(name => name.endsWith("CalibrationRunner.json"))
  .some(name => /"repeats": 3/.test(readFileSync(join(here, folder, name), "utf8")));
const saved = () => savedIn("state");
check(!saved(), "a value that is set is not written into files");
await page.getByRole("button", {name: "Save …"}).click();
await page.getByRole("button", {name: /^Save on/}).click();
check(await until(saved), "saving writes it, once it is confirmed");
check(!savedIn("configuration"), "and leaves what was shipped as it is");

// The robot's process is killed and restarted.
await tab("Live");
await page.getByLabel("filter values").click();
await page.keyboard.press("End");
await page.keyboard.type(".s");
robot.kill();
await page.getByText(/below are its last known values/).waitFor();
await page.keyboard.type("1u");
check((await page.getByLabel("filter values").inputValue()).endsWith(".s1u") && page.url().endsWith("#live"), "a filter that is typed stays while the robot goes: " + await page.getByLabel("filter values").inputValue());
await page.getByLabel("filter values").fill("");
await tab("Configuration");
await page.getByText(/Nothing can be set until it is back/).waitFor();
await tab("Calibrate");
await page.getByLabel("robot to connect to").focus();
await page.keyboard.type("nao");
await page.screenshot({path: join(pictures, "robot-gone.png")});
await robot.start();
await page.locator(".robot.connected").waitFor();
await happens(livePicture(page), "a robot that comes back is seen again");
await page.keyboard.type("21");
check(await page.getByLabel("robot to connect to").inputValue() === "nao21", "an address that is typed stays while the robot comes: " + await page.getByLabel("robot to connect to").inputValue());

// After the bridge ends, no robot is shown as connected.
await panel.stop("SIGKILL");
await page.getByText("is unreachable: the bridge is away").first().waitFor();
check(await page.locator(".robot.connected").count() === 0 && !await page.locator("#stop").isVisible(), "with the bridge away no robot seems connected, and no Stop seems to work");
await page.screenshot({path: join(pictures, "robot-bridge-away.png")});
await browser.close();
robot.kill();
end();
