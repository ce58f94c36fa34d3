// Uses the pages of a result and a diagnosis as files in a real browser: selects, paging of pictures, clicks on points.
// Proves that each control has its effect and that the console stays silent; figures are not validated.
// Usage: node pages.mjs NAOCAL NODE_MODULES; skipped (77) without Chromium or npm's packages
import {spawnSync} from "node:child_process";
import {join} from "node:path";
import {tools, check, happens, folder, quietPage, end} from "../mate-bridge/page/browser.mjs";

const [, , naocal, modules] = process.argv;
const {launch} = tools(modules), here = folder();
const run = (...words) => check([0, 3].includes(spawnSync(naocal, words, {stdio: ["ignore", "ignore", "inherit"]}).status), "naocal " + words[0]); // 3: completed with a negative verdict
run("simulate", join(here, "flawed"), "--hidden-flaw", "--poses", "12", "--samples", "2", "--seed", "1");
run("solve", join(here, "flawed"), "-o", join(here, "result.json"));
run("diagnose", join(here, "flawed"), "--json", join(here, "diagnosis.json"), "--seed", "1", "--draws", "19");
for (const name of ["result", "diagnosis"]) run("report", join(here, name + ".json"), "-o", join(here, name + ".html"));

const browser = await launch();
const opened = async name => {
  const page = await quietPage(browser, "file://" + join(here, name + ".html"));
  await page.locator(".figure canvas").first().waitFor();
  return page;
};
const choose = (select, option) => select.selectOption(option);

const result = await opened("result"), captions = result.locator("#pictures figcaption"), firstCaption = () => captions.first().innerText();
await happens(captions.first().filter({hasText: "px rms"}).waitFor(), "pictures are drawn");
const worst = await firstCaption();
await result.getByRole("button", {name: "next ›"}).click();
await happens(result.waitForFunction(old => ![ "", old ].includes(document.querySelector("#pictures figcaption").innerText), worst), "the next pictures are shown");
await choose(result.getByLabel("Errors with joint readings"), "fitted");
await result.getByRole("button", {name: "‹ previous"}).click();
await happens(result.waitForFunction(old => ![ "", old ].includes(document.querySelector("#pictures figcaption").innerText), worst), "other errors are drawn with readings moved within their noise");
check(parseFloat(await firstCaption()) < parseFloat(worst), "and they are smaller: " + parseFloat(worst) + " px, " + parseFloat(await firstCaption()) + " px");
const joints = result.locator("#joint"), other = (await joints.locator("option").allInnerTexts())[1];
await joints.scrollIntoViewIfNeeded();
await choose(joints, other);
check(await result.getByRole("img", {name: "mean errors over a joint's angle, down"}).count() === 1, "errors are drawn over another joint: " + other);

// Clicking a point scrolls to its picture.
const poses = result.getByRole("img", {name: "errors by pose"});
await poses.evaluate(canvas => canvas.scrollIntoView({block: "start"}));
const seesPictures = () => result.evaluate(() => document.getElementById("pictures").getBoundingClientRect().bottom > 0);
check(!await seesPictures(), "the pictures are out of sight");
const {width, height} = await poses.boundingBox();
let inView = false;
for (let x = 0.1; x < 0.95 && !inView; x += 0.02) {
  for (let y = 0.15; y < 0.85 && !inView; y += 0.08) {
    await poses.hover({position: {x: x * width, y: y * height}});
    if (await result.locator("#tip").isHidden()) continue;
    await poses.click({position: {x: x * width, y: y * height}});
    inView = await seesPictures();
  }
}
check(inView, "a click on a point shows its picture");

const diagnosis = await opened("diagnosis"), rows = diagnosis.locator(".candidates tbody tr");
const button = name => diagnosis.getByRole("button", {name}).first();
check(await diagnosis.locator(".ladder .rung").count() > 1 && await diagnosis.locator(".ladder .floor").count() === 1, "the ladder has its rungs and the noise floor");
const all = Number((await button(/^all \d+/).innerText()).split(" ")[1]);
await button(/^show all \d+$/).click();
check(await rows.count() === all, "all candidates are shown: " + all);
const ruledOut = Number((await button(/^ruled out \d+/).innerText()).split(" ")[2]);
await button(/^ruled out/).click();
check(await rows.count() === ruledOut && (await rows.first().innerText()).includes("ruled out"), "or those that are ruled out: " + ruledOut);
await rows.first().hover();
check(/ruled out: would have been seen at a plausible size/.test(await diagnosis.locator("#tip").innerText()), "a row explains its verdict");
const signature = diagnosis.locator("section", {hasText: "What it would look like"}), before = await signature.locator("figcaption").first().innerText();
await signature.getByRole("button", {name: "smaller ›"}).click();
await happens(diagnosis.waitForFunction(old => [...document.querySelectorAll("section")].find(({innerText}) => innerText.startsWith("What it would look like"))
  .querySelector("figcaption").innerText !== old, before), "the next picture of a signature is shown");
const bent = diagnosis.locator("section", {hasText: "Joint error that would explain the misfit"}), words = () => bent.locator("figcaption").innerText();
await happens(bent.locator("figcaption", {hasText: "standard errors"}).waitFor(), "a joint's errors are drawn");
const base = await words();
if (await bent.locator("#bentBy").count()) {
  await choose(bent.locator("#bentBy"), "withSuggested");
  await happens(bent.locator("figcaption", {hasText: "standard errors"}).waitFor(), "and those that the suggested effects leave");
  check(await words() !== base, "which are others: " + await words());
}
for (const [name, page] of Object.entries({result, diagnosis})) {
  const links = page.locator("#contents a"), titles = await page.locator("section h2:visible").allInnerTexts();
  check((await links.allInnerTexts()).join() === titles.join() && titles.length > 4, "the " + name + "'s contents are its sections: " + titles.length);
  await links.last().click();
  check(await page.getByRole("heading", {name: titles.at(-1), exact: true}).evaluate(title => { const {top} = title.getBoundingClientRect(); return top >= 0 && top < innerHeight; }), "and lead to them");
}
await browser.close();
end();
