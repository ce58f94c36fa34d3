// Memory growth of page and bridge with two cameras, overlays and plots [MB/min]: slope over the second half of the run.
// Run by hand, for the given time.
// Usage: node endurance.mjs NAOCAL-ROBOT MATE-BRIDGE NODE_MODULES CONFIGURATION MINUTES
import {readFileSync} from "node:fs";
import {tools, check, panelOf, folder, quietPage, livePicture, end} from "./browser.mjs";
import {robotIn} from "./robotHere.mjs";

const [, , robotProgram, bridge, modules, configuration, minutes] = process.argv;
const {launch} = tools(modules), robot = robotIn(folder(), robotProgram, configuration, {periodSeconds: 1 / 30});
const panel = await panelOf(bridge, "--robot", await robot.start()), browser = await launch();
const page = await quietPage(browser, panel.address), inspector = await page.context().newCDPSession(page);
await livePicture(page);
await page.getByRole("button", {name: "Live", exact: true}).click();
await page.getByLabel("filter values").fill("Motion.angles");
await page.getByLabel("Motion.angles").check();

const samples = [], begin = Date.now();
while (Date.now() - begin < 60000 * Number(minutes)) {
  await page.getByRole("button", {name: samples.length % 2 ? "Live" : "Calibrate", exact: true}).click();
  await page.waitForTimeout(5000);
  await inspector.send("HeapProfiler.collectGarbage");
  const {usedSize} = await inspector.send("Runtime.getHeapUsage");
  const resident = Number(readFileSync("/proc/" + panel.pid + "/status", "utf8").match(/VmRSS:\s+(\d+)/)[1]);
  samples.push({minute: (Date.now() - begin) / 60000, page: usedSize / 2 ** 20, bridge: resident / 2 ** 10});
  console.log(samples.at(-1).minute.toFixed(2) + " min: page " + samples.at(-1).page.toFixed(1) + " MB, bridge " + samples.at(-1).bridge.toFixed(1) + " MB; " +
    (await page.locator(".camera figcaption").allInnerTexts()).join("; "));
}
const half = samples.slice(Math.floor(samples.length / 2)), mean = key => half.reduce((sum, one) => sum + one[key], 0) / half.length;
for (const key of ["page", "bridge"]) {
  const slope = half.reduce((sum, one) => sum + (one.minute - mean("minute")) * (one[key] - mean(key)), 0) / half.reduce((sum, one) => sum + (one.minute - mean("minute")) ** 2, 0);
  check(slope < 0.5, "the " + key + " grows by " + slope.toFixed(3) + " MB a minute at " + mean(key).toFixed(1) + " MB");
}
await browser.close();
await panel.stop("SIGTERM");
robot.kill();
end();
