// Helpers of the tests that drive the panel in a real browser.
import {spawn, execFileSync} from "node:child_process";
import {createRequire} from "node:module";
import {existsSync, mkdirSync, mkdtempSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";

const notRun = 77; // CTest's SKIP_RETURN_CODE
const patience = Number(process.env.NAOCAL_PATIENCE) || 900000; // timeout of all waits [ms]; long, as results must not depend on the machine's load

export const skip = why => { console.log("not run: " + why); process.exit(notRun); };

// Browser driver and axe, from the packages that the page was built with.
export function tools(modules) {
  const browser = ["/usr/bin/chromium", "/usr/bin/google-chrome"].find(existsSync);
  if (!browser) skip("there is no chromium");
  if (!existsSync(join(modules, "playwright-core"))) skip("the page's packages are not installed");
  const require = createRequire(join(modules, "x.js"));
  return {
    launch: () => require("playwright-core").chromium.launch({executablePath: browser, args: ["--no-sandbox", "--disable-gpu"], timeout: patience}),
    axe: require("axe-core").source,
  };
}

export const failures = [];
export function check(truth, sentence) {
  console.log((truth ? "ok: " : "FAILED: ") + sentence);
  if (!truth) failures.push(sentence);
}

// Checks that a promise resolves before its timeout.
export const happens = (awaited, sentence) => awaited.then(() => check(true, sentence), error => check(false, sentence + ": " + error.message.split("\n")[0]));

// Runs, and what panels keep, are in a folder of the test, never in the user's.
process.env.XDG_STATE_HOME = folder();
const ownState = {}; // further variables of programs
const environment = () => ({...process.env, ...ownState.more});
/** Further variables of programs that are started later. */
export const setEnvironment = more => { ownState.more = more; };

// Starts a program that runs until `stop`; its first line of output contains the address.
export async function started(program, ...options) {
  const child = spawn(program, options, {stdio: ["ignore", "pipe", "inherit"], env: environment()});
  process.on("exit", () => child.kill("SIGKILL"));
  const line = await new Promise((resolve, reject) => {
    let text = "";
    child.stdout.on("data", data => { text += data; if (text.includes("\n")) resolve(text); });
    child.on("exit", code => reject(new Error(program + " ended with " + code)));
  });
  return {line, pid: child.pid, stop: signal => new Promise(resolve => { child.on("exit", resolve); child.kill(signal); })};
}

export async function panelOf(bridge, ...options) {
  const {line, pid, stop} = await started(bridge, "--no-open", ...options);
  return {address: line.match(/http:\/\/\S+/)[0], pid, stop};
}

export const run = (program, ...options) => execFileSync(program, options, {stdio: ["ignore", "ignore", "inherit"]});

export function folder() {
  const path = mkdtempSync(join(tmpdir(), "naocal-test-"));
  process.on("exit", () => rmSync(path, {recursive: true, force: true}));
  return path;
}

// A page with the long timeout.
export async function patientPage(browser, options = {}) {
  const page = await browser.newPage(options);
  page.setDefaultTimeout(patience);
  return page;
}

// Polls a condition outside the page; false on a timeout.
export async function until(holds) {
  const end = Date.now() + patience;
  while (Date.now() < end) {
    if (await holds()) return true;
    await new Promise(resolve => setTimeout(resolve, 50));
  }
  return false;
}

// A page whose console errors, warnings and exceptions are failures, except refused connections.
export async function quietPage(browser, address, options = {}) {
  const page = await patientPage(browser, {viewport: {width: 1366, height: 800}, ...options});
  page.on("console", message => { if (["error", "warning"].includes(message.type()) && !message.text().includes("ERR_CONNECTION_REFUSED")) check(false, "the console is quiet: " + message.text()); });
  page.on("pageerror", error => check(false, "no script fails: " + error.message));
  await page.goto(address);
  return page;
}

// Waits for the first picture of a camera.
export const livePicture = page => page.locator(".camera figcaption", {hasText: /\d+ × \d+ px/}).first().waitFor();

export const px = text => Number(text.match(/([\d.]+) px/)[1]);

// Screenshots of a view in light, dark and in a narrow window; checks accessibility with axe, and the width.
export async function portrait(page, axe, pictures, name) {
  mkdirSync(pictures, {recursive: true});
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({colorScheme, reducedMotion: "reduce"});
    await page.evaluate(() => scrollTo(0, 0)); // the header is sticky
    await page.waitForTimeout(150);
    await page.screenshot({path: join(pictures, name + "-" + colorScheme + ".png"), fullPage: true});
    await page.evaluate(axe);
    const {violations} = await page.evaluate(() => window.axe.run());
    const serious = violations.filter(({impact}) => impact === "serious" || impact === "critical");
    for (const {id, nodes} of serious) console.log("axe: " + id + ": " + nodes.slice(0, 3).map(({html}) => html.slice(0, 140)).join(" | "));
    check(serious.length === 0, "axe finds no serious barrier in " + name + ", " + colorScheme);
  }
  await page.emulateMedia({colorScheme: "light"});
  await page.setViewportSize({width: 420, height: 800});
  await page.evaluate(() => scrollTo(0, 0));
  await page.waitForTimeout(150);
  await page.screenshot({path: join(pictures, name + "-narrow.png")});
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  check(wide <= 0, name + " fits a window 420 px wide (" + wide + " px over)");
  await page.setViewportSize({width: 1366, height: 800});
}

export function end() {
  console.log(failures.length ? failures.length + " failed" : "all held");
  process.exit(failures.length ? 1 : 0);
}
