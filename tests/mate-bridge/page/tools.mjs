// Drives the panel's tools in a real browser: simulates captures and opens them, plans poses, shows the program's message
// for a wrong option, and ends a long command. Proves that the page can run naocal's commands only.
// Usage: node tools.mjs MATE-BRIDGE NODE_MODULES PICTURES
import {chmodSync, existsSync, readFileSync, readdirSync, readlinkSync, writeFileSync} from "node:fs";
import {spawn} from "node:child_process";
import {join} from "node:path";
import {tools, check, happens, panelOf, folder, quietPage, portrait, patientPage, until, end} from "./browser.mjs";

const [, , bridge, modules, pictures] = process.argv;
const {launch, axe} = tools(modules), here = folder();
const panel = await panelOf(bridge);
const browser = await launch(), page = await quietPage(browser, panel.address);
const click = name => page.getByRole("button", {name, exact: true}).click();
const status = page.locator("#toolStatus"), line = page.locator("#toolLine"), output = page.locator("#toolOutput");
const ended = () => page.waitForFunction(() => /finished|ended with/.test(document.getElementById("toolStatus")?.textContent));

const statOf = pid => { try { return readFileSync("/proc/" + pid + "/stat", "utf8").replace(/^.*\) \S+ /s, ""); } catch { return null; } };

await click("Tools");
await click("Simulate");
await page.getByLabel("write the captures to").fill(join(here, "a robot"));
await page.getByLabel("number of poses, or a plan file").fill("8");
await page.getByLabel("hide a flaw in it").check();
check((await line.innerText()).trim() === "naocal simulate '" + join(here, "a robot") + "' --poses 8 --samples 3 --support left --seed 1 --hidden-flaw", "the line is what one would type: " + await line.innerText());
await portrait(page, axe, pictures, "tools");
await click("Run");
await ended();
check((await status.innerText()).endsWith("has finished."), "captures are simulated: " + await status.innerText());
check(existsSync(join(here, "a robot", "captures.json")), "they are there");
const setFile = join(here, "a robot", "captures.json"), set = JSON.parse(readFileSync(setFile));
await page.screenshot({path: join(here, "a robot", "kept.png")}); // a kept image
set.captures[0].image = "kept.png";
writeFileSync(setFile, JSON.stringify(set));
await page.getByRole("button", {name: /^Open /}).click();
await happens(page.getByRole("heading", {name: "Where the prediction fails"}).waitFor(), "they are opened by a click");
const kept = await page.evaluate(id => fetch("picture/" + encodeURIComponent("a robot") + "/" + id).then(answer => answer.status), set.captures[0].id);
check(kept === 200, "pictures of a set whose name has a space are shown: " + kept);

await click("Tools");
await click("Plan poses");
await page.getByLabel("write the plan to").fill(join(here, "poses.json"));
await page.getByLabel("candidate poses").fill("20000");
await page.getByLabel("poses", {exact: true}).fill("5");
await click("Run");
await page.waitForFunction(() => /^naocal poses .*finished/.test(document.getElementById("toolStatus")?.textContent));
check(JSON.parse(readFileSync(join(here, "poses.json"))).poses.length === 5, "five poses are planned");
await portrait(page, axe, pictures, "tools-finished");

await page.getByLabel("stand on").selectOption("both");
await page.getByLabel("further options").fill("--sellect 3");
await click("Run");
await page.waitForFunction(() => /ended with/.test(document.getElementById("toolStatus")?.textContent));
check((await output.innerText()).includes("--sellect"), "a slip is told in the program's words: " + (await output.innerText()).trim());

await click("Solve");
await page.getByLabel("captures", {exact: true}).fill(join(here, "a robot"));
await page.getByLabel("write the result to").fill(join(here, "result.json"));
await page.getByLabel("add effects").fill("focalLength@top");
await click("Run");
await page.waitForFunction(() => /^naocal solve .*finished/.test(document.getElementById("toolStatus")?.textContent));
await portrait(page, axe, pictures, "tools-solve");
await click("Open " + join(here, "result.json"));
await happens(page.getByRole("button", {name: "remove focalLength@top"}).waitFor(), "a result that was solved for is opened by a click, with its model");

await click("Tools");
await click("Export a result");
await page.getByLabel("result", {exact: true}).fill(join(here, "result.json"));
check((await page.getByLabel("for", {exact: true}).locator("option").allInnerTexts()).includes("urdf"), "results are exported to all programs that naocal knows");
await page.getByLabel("for", {exact: true}).selectOption("bhuman");
await page.getByLabel("folder to write to").fill(join(here, "B-Human"));
await click("Run");
await page.waitForFunction(() => /^naocal export .*finished/.test(document.getElementById("toolStatus")?.textContent));
check((await output.innerText()).includes("not written: ") && !existsSync(join(here, "B-Human")), "one that should not be used is refused: " + (await output.innerText()).trim().slice(0, 120));
await portrait(page, axe, pictures, "tools-export");

await click("Check captures");
await page.getByLabel("captures", {exact: true}).fill(join(here, "a robot"));
await click("Run");
await page.waitForFunction(() => /^naocal check .*finished/.test(document.getElementById("toolStatus")?.textContent));
check(/kept\.png has \d+ × \d+ pixels/.test(await output.innerText()), "captures are checked, and a picture of another size is found: " + (await output.innerText()).trim());

await click("Evaluate: next poses");
await page.getByLabel("robots").fill("5000");
await click("Run");
await page.locator("#toolEnd").waitFor();
check(await page.locator("#toolRun").isDisabled(), "one command at a time");
const programOf = pid => { try { return readlinkSync("/proc/" + pid + "/exe"); } catch { return ""; } };
let child; // after exec of the command
await until(() => child = readdirSync("/proc").find(pid => /^\d+$/.test(pid) && statOf(pid)?.startsWith(panel.pid + " ") && /\/naocal(-evaluate)?$/.test(programOf(pid))));
const open = readdirSync("/proc/" + child + "/fd").map(one => { try { return readlinkSync("/proc/" + child + "/fd/" + one); } catch { return ""; } });
check(child && !open.some(one => one.startsWith("socket:")), "a command holds none of the bridge's sockets: " + open.join(" "));
await click("End it");
await page.waitForFunction(() => /finishes what it has begun|was ended/.test(document.getElementById("tools")?.innerText ?? document.body.innerText));
// A second click ends a command that still computes; one that was between two robots has ended already.
await page.locator("#toolEnd").click({timeout: 2000}).catch(() => undefined);
await happens(page.waitForFunction(() => /was ended/.test(document.getElementById("toolStatus")?.textContent)), "a long command is ended");

const refused = await page.evaluate(words => new Promise(resolve => {
  const socket = new WebSocket(location.href.replace(/^http/, "ws").replace(/#.*$/, "") + "live");
  socket.onopen = () => socket.send(JSON.stringify({do: "run", words}));
  socket.onmessage = ({data}) => { if (typeof data === "string" && JSON.parse(data).kind === "refused") resolve(JSON.parse(data).sentence); };
}), ["explore; touch x", "/etc"]);
check(refused.includes("expected one of naocal's commands"), "nothing else is run: " + refused);

// The browser's command line is visible to all users of this computer: it contains no secret, and leads to the panel.
const fake = join(here, "chromium");
writeFileSync(fake, "#!/bin/sh\necho \"$@\" > '" + join(here, "arguments") + "'\n");
chmodSync(fake, 0o755);
const opening = spawn(bridge, [], {stdio: ["ignore", "pipe", "inherit"], env: {...process.env, PATH: here + ":/usr/bin:/bin", HOME: here}});
const line2 = await new Promise(resolve => opening.stdout.once("data", data => resolve(String(data))));
const told = () => existsSync(join(here, "arguments")) ? readFileSync(join(here, "arguments"), "utf8") : "";
await until(() => told().endsWith("\n"));
const words = readFileSync(join(here, "arguments"), "utf8").trim(), [, token] = line2.match(/:\d+\/([0-9a-f]{32})\//);
check(words.startsWith("--app=file://") && !words.includes(token), "the secret is not in the browser's command line: " + words);
const led = await patientPage(browser);
await led.goto(words.replace("--app=", ""));
await led.getByRole("heading", {name: "Calibrate a robot"}).waitFor();
check(led.url().includes(token), "its page leads to the panel");
opening.kill("SIGTERM");
await new Promise(resolve => opening.on("exit", resolve));
check(!existsSync(words.replace("--app=file://", "")), "and goes with the bridge");
await browser.close();
end();
