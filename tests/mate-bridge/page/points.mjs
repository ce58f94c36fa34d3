// Responsiveness of Compare with 100 000 points: time from selecting an axis to the drawing, and frame times while the
// pointer moves. A measurement, run by hand.
// Usage: node points.mjs NAOCAL MATE-BRIDGE NODE_MODULES
import {join} from "node:path";
import {tools, check, panelOf, run, folder, quietPage, end} from "./browser.mjs";

const [, , naocal, bridge, modules] = process.argv;
const {launch} = tools(modules), here = folder();
run(naocal, "simulate", join(here, "many"), "--poses", "60", "--samples", "32", "--seed", "1");
const panel = await panelOf(bridge, join(here, "many")), browser = await launch(), page = await quietPage(browser, panel.address);
await page.getByRole("heading", {name: "Where the prediction fails"}).waitFor();
await page.waitForFunction(() => document.getElementById("work").textContent === "");
console.log("measured: " + (await page.getByText(/^1–6 of/).innerText()).replace(/.*of/, "") + " pictures, opened");
for (const axis of ["v", "radius", "capture", "u"]) {
  const begun = Date.now();
  await page.getByLabel("Error over").selectOption(axis);
  await page.evaluate(() => new Promise(resolve => requestAnimationFrame(() => requestAnimationFrame(resolve))));
  console.log("measured: another axis (" + axis + ") is drawn after " + (Date.now() - begun) + " ms");
}
const longest = await page.evaluate(async () => { // 95th percentile of frame times while the pointer moves
  const canvas = document.querySelector(".scatter canvas"), box = canvas.getBoundingClientRect(), gaps = [];
  let last = performance.now();
  for (let i = 0; i < 120; ++i) {
    canvas.dispatchEvent(new PointerEvent("pointermove", {clientX: box.left + box.width * (i + 0.5) / 120, clientY: box.top + box.height / 2}));
    await new Promise(resolve => requestAnimationFrame(resolve));
    gaps.push(performance.now() - last);
    last = performance.now();
  }
  return gaps.sort((a, b) => a - b).at(-6);
});
check(longest < 50, "95 % of the frames while the pointer moves take less than 50 ms: " + longest.toFixed(0) + " ms");
await page.getByRole("button", {name: "Result", exact: true}).click();
console.log("measured: with " + (await page.getByText(/measured corners in/).innerText()).match(/between (\d+)/)[1] + " points");
await browser.close();
await panel.stop("SIGKILL");
end();
