// Drives the analysis in a real browser: opens a set with a hidden effect, adds the effect by a click, and checks that
// the displayed error falls to the noise; a custom effect; undo; pages of other origins are refused.
// Proves that page, bridge and library work together, and saves screenshots of every view; numbers are not validated.
// Usage: node analysis.mjs NAOCAL MATE-BRIDGE NODE_MODULES PICTURES
import {createServer} from "node:http";
import {cpSync, mkdirSync, readFileSync, writeFileSync} from "node:fs";
import {join} from "node:path";
import {tools, check, happens, panelOf, run, folder, quietPage, portrait, px, patientPage, until, end} from "./browser.mjs";

const [, , naocal, bridge, modules, pictures] = process.argv;
const {launch, axe} = tools(modules), here = folder();
run(naocal, "simulate", join(here, "flawed"), "--hidden-flaw", "--poses", "30", "--samples", "2", "--repeat-kind", "reapproach", "--seed", "1");
const truth = JSON.parse(readFileSync(join(here, "flawed.truth.json")));
const {effect, at} = truth.effects.find(one => !["jointOffset", "cameraRotation", "cameraTranslation"].includes(one.effect));
const flaw = effect + "@" + at;

const panel = await panelOf(bridge, join(here, "flawed"));
const browser = await launch();
const opened = Date.now(), page = await quietPage(browser, panel.address);
const tab = name => page.getByRole("button", {name, exact: true}).click();
const rungs = page.locator(".ladder .rung"), idle = () => page.waitForFunction(() => document.getElementById("work").textContent === "");

await page.getByRole("heading", {name: "Where the prediction fails"}).waitFor();
console.log("measured: from opening to the first fit on the screen: " + (Date.now() - opened) + " ms");
// Compare says what is missing, with the picture of its cause, as soon as the search has found it.
const found = page.locator(".finding"), sentence = () => found.locator("p").first().innerText();
check(["Searching for what is missing …", "An effect is missing in the model."].includes(await found.locator("h2").innerText()), "no verdict is shown before the search has ended");
await found.getByText("An effect is missing in the model.").waitFor();
console.log("measured: from opening to the finding on the screen: " + (Date.now() - opened) + " ms");
check((await sentence()).startsWith(flaw + " is missing"), "the finding names the hidden flaw: " + await sentence());
check(await page.getByRole("img", {name: "error without " + flaw, exact: true}).isVisible() && await page.getByRole("img", {name: "error with " + flaw, exact: true}).isVisible(), "the error is drawn without and with it");
check(await found.getByRole("button", {name: "Add " + flaw, exact: true}).isVisible(), "and it can be added where it is said");
await portrait(page, axe, pictures, "compare-finding");
const drawn = page.getByRole("img", {name: "error without " + flaw, exact: true}), size = await drawn.boundingBox(), captionBefore = await page.locator(".split figcaption").first().innerText();
let pointed = captionBefore;
for (let x = 0.1; x < 0.98 && pointed === captionBefore; x += 0.02) {
  for (let y = 0.15; y < 0.85 && pointed === captionBefore; y += 0.04) {
    await drawn.click({position: {x: x * size.width, y: y * size.height}});
    pointed = await page.locator(".split figcaption").first().innerText();
  }
}
check(pointed !== captionBefore, "a click on a pose of the cause shows its capture: " + pointed);
await tab("Learn");
await page.getByRole("heading", {name: "An effect is missing in the model."}).waitFor();
await idle();
const before = px(await rungs.first().innerText());
check((await page.locator(".candidates tbody tr").first().innerText()).includes(flaw), "the first candidate is the hidden flaw, " + flaw);
await portrait(page, axe, pictures, "learn");

// Adding it shows the new fit before the candidates have been tested.
const clicked = Date.now();
await page.evaluate(() => { // records changes of the view
  const view = document.getElementById("view");
  window.seen = [];
  new MutationObserver(() => window.seen.push({rows: view.querySelectorAll(".candidates tbody tr").length, dimmed: view.classList.contains("earlier"), note: view.querySelector(".waiting")?.textContent}))
    .observe(view, {childList: true, subtree: true, attributes: true});
});
await page.getByRole("button", {name: "add " + flaw, exact: true}).click();
await rungs.nth(1).waitFor();
console.log("measured: from the click to the new fit on the screen: " + (Date.now() - clicked) + " ms with 60 captures of 30 poses and two cameras");
await page.locator(".ladder .rung:nth-child(1) .bar:not(.open)").first().waitFor();
await page.waitForFunction(() => !document.querySelector(".ladder .bar.open"));
await idle();
const seen = await page.evaluate(() => window.seen), dimmed = seen.filter(one => one.dimmed);
check(seen.every(({rows}) => rows > 0) && dimmed.length && dimmed.every(({note}) => /^Testing \d+ possible causes …$/.test(note)) && !seen.at(-1).dimmed,
  "the candidates stay in sight, dimmed, until the new ones are there: " + dimmed[0]?.note);
const after = px(await rungs.nth(1).innerText()), floor = px(await page.locator(".ladder .floor").innerText());
check(after < 0.6 * before && after < 1.3 * floor, "the shown held-out error falls to the noise: " + before + " px, " + after + " px, noise " + floor + " px");
check((await page.locator("h1").innerText()).startsWith("Nothing") || !(await page.locator("h1").innerText()).includes("is missing in the model"), "nothing is missing any more");
await portrait(page, axe, pictures, "learn-adequate");

// Clicking a point shows its capture.
await tab("Compare");
const scatter = page.locator(".scatter canvas"), caption = page.locator(".split figcaption").first();
const box = await scatter.boundingBox(), first = await caption.innerText();
let other = first;
for (let x = 0.15; x < 0.95 && other === first; x += 0.02) {
  for (let y = 0.3; y < 0.75 && other === first; y += 0.05) {
    await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
    await page.waitForFunction(() => document.querySelector(".split figcaption").textContent);
    other = await caption.innerText();
  }
}
check(other !== first, "a click on a point shows its capture: " + other);
// A capture, a pose or a board is left out as a step of the model, and Undo takes it back.
const leave = page.getByRole("button", {name: /^leave out capture/}).first(), leftOut = (await leave.getAttribute("aria-label")).replace("leave out capture ", ""), models = await rungs.count();
await leave.click();
await happens(page.locator(".ladder .rung", {hasText: "+ leftOut@capture:" + leftOut}).waitFor(), "capture " + leftOut + " is left out, as a step of the model");
await happens(page.locator("#model").getByRole("button", {name: "remove leftOut@capture:" + leftOut}).waitFor(), "and it is listed as left out");
check(await page.getByRole("button", {name: /^leave out pose/}).count() > 0 && await page.getByRole("button", {name: /^leave out board/}).count() > 0, "so can a pose or a board be");
await page.getByRole("button", {name: "Undo", exact: true}).click();
await page.waitForFunction(at => document.querySelectorAll(".ladder .rung")[at].getAttribute("aria-current") === "step", models - 1);
await idle();
await page.locator("#overX").selectOption({label: "the angle of LKneePitch [°]"});
await portrait(page, axe, pictures, "compare");
// Every drawing can be saved as PNG and SVG.
const saved = async click => {
  const [file] = await Promise.all([page.waitForEvent("download"), click()]);
  const path = join(here, file.suggestedFilename());
  await file.saveAs(path);
  return {name: file.suggestedFilename(), content: readFileSync(path)};
};
const svg = await saved(() => page.getByRole("button", {name: /^save as SVG: error/}).click({force: true}));
check(svg.name.endsWith(".svg") && svg.content.includes("<svg") && (svg.content.toString().match(/<(path|rect)/g) || []).length > 500, "a drawing is saved as SVG, with its points: " + svg.name);
const png = await saved(() => page.getByRole("button", {name: /^save as PNG: error/}).click({force: true}));
check(png.content.subarray(1, 4).toString() === "PNG", "a drawing is saved as PNG");
await tab("Map");
await page.locator("#view h2", {hasText: "On the boards"}).waitFor();
check((await page.locator("#view h2").allInnerTexts()).join() === "Curves,Joint error that would explain the misfit,Within the pictures,On the boards", "the map shows the other ways to look at what is left");
await page.locator("#bent").selectOption("LKneePitch");
const bent = page.getByRole("img", {name: /^error of LKneePitch over/}), bentBox = await bent.boundingBox();
check(await page.getByRole("img", {name: /^shape of board/}).count() > 1, "each board's shape is drawn");
await portrait(page, axe, pictures, "map");
let left = false; // whether a click on a point has left the view
for (let x = 0.2; x < 0.95 && !left; x += 0.03) {
  for (let y = 0.2; y < 0.85 && !left; y += 0.1) {
    await bent.click({position: {x: x * bentBox.width, y: y * bentBox.height}});
    left = page.url().endsWith("#compare");
  }
}
check(left, "a click on a deflection shows its capture");
await tab("Result");
await portrait(page, axe, pictures, "result");
const bars = await saved(() => page.getByRole("button", {name: "save as SVG: joint offset", exact: true}).click());
check(bars.content.includes("LKneePitch") && bars.content.includes("±"), "estimates are saved as a drawing");
const rows = (await saved(() => page.getByRole("button", {name: "CSV", exact: true}).click())).content.toString().split("\n");
check(rows[0].startsWith("effect,at,unit,value") && rows.some(row => row.startsWith("joint offset,LKneePitch,°,")), "estimates are saved as a table");

// Next poses, comparison with other captures, and the files of the command line.
await tab("Next poses");
await page.getByLabel("How many").selectOption("2");
await page.getByRole("button", {name: "Suggest poses"}).click();
await page.locator(".standing").first().waitFor();
await idle();
check(await page.locator(".standing").count() === 2, "as many poses are suggested as were asked for: " + await page.locator(".standing").count());
await page.waitForTimeout(300);
await portrait(page, axe, pictures, "next");
run(naocal, "simulate", join(here, "others"), "--hidden-flaw", "--poses", "8", "--samples", "2", "--seed", "2", "--robot-seed", "1");
await tab("Files");
await page.getByLabel("path of other captures").fill(join(here, "others"));
await page.getByRole("button", {name: "Compare", exact: true}).last().click();
const typing = page.getByLabel("path of what to open");
await typing.focus(); // types while the bridge starts and ends tasks
for (const part of ["/captures/", "sus1u2r"]) {
  await page.keyboard.type(part, {delay: 20});
  await page.getByText("from their predictions over").waitFor();
  await idle();
}
check(await typing.inputValue() === "/captures/sus1u2r" && page.url().endsWith("#files"), "what is typed stays where it is typed while the bridge works: " + await typing.inputValue());
await typing.fill("");
await portrait(page, axe, pictures, "files");
const result = JSON.parse((await saved(() => page.getByRole("button", {name: "result.json"}).click())).content);
check(result.format === "naocal-result" && result.effects.some(one => one.effect === effect && one.at === at), "the result is saved as naocal solve writes it");
const session = (await saved(() => page.getByRole("button", {name: "session.html"}).click())).content.toString();
check(!session.includes("<script") && (session.match(/<img /g) || []).length >= 8 && session.includes("Where the prediction fails"), "the session is one page: " + Math.round(session.length / 1e5) / 10 + " MB");
writeFileSync(join(pictures, "session.html"), session);
const kept = JSON.parse((await saved(() => page.getByRole("button", {name: "session.json"}).click())).content);
check(kept.format === "naocal-session" && kept.ladder.length > 1 && kept.ladder.some(one => one.with.includes(effect + "@" + at)), "and a file to go on from, with all models that were tried");
const alone = await patientPage(browser, {viewport: {width: 1200, height: 900}});
await alone.goto("file://" + join(pictures, "session.html"));
const sessionHead = await alone.locator("header").innerText(), linked = await alone.locator("nav a").evaluateAll(links => links.filter(link => !document.querySelector(link.getAttribute("href"))).length);
check(/^naocal session, .*\s+Written by naocal [\d.]+, \d{4}-\d\d-\d\d \d\d:\d\d UTC/.test(sessionHead) && sessionHead.includes("Model\nCompare") && linked === 0,
  "it begins with what it is, who wrote it when, and its contents: " + sessionHead.slice(0, 200));
await alone.screenshot({path: join(pictures, "session.png"), fullPage: true});
await alone.close();

// A custom effect: an error shows its position; a valid effect can be added.
await tab("Custom effect");
await page.getByLabel("Correction [rad]").fill("a*sin(3*q) + b*abs(tua)");
await page.locator("#ownPointer mark").waitFor();
check((await page.locator("#ownPointer").innerText()).includes("letter 20"), "a broken expression shows where: " + (await page.locator("#ownVerdict").innerText()));
check(await page.locator("#ownAdd").isDisabled(), "a broken expression cannot be added");
await portrait(page, axe, pictures, "own-broken");
await page.getByLabel("Correction [rad]").fill("a*sin(3*q) + b*abs(tau)");
await page.getByText("This can be added").waitFor();
await page.locator("#ownAdd").click();
await rungs.nth(2).waitFor();
await page.getByText("Your effects").waitFor();
await portrait(page, axe, pictures, "own");
await page.keyboard.press("Escape");
await page.locator("#undo").click();
await page.locator(".ladder li:nth-child(2) .rung[aria-current=step]").waitFor();
await idle();
check(await page.getByRole("button", {name: "remove kneeCable@LKneePitch"}).count() === 0, "undo takes the custom effect out of the model");

// A failed fit is reported to all later pages; a set with photographs.
run(naocal, "simulate", join(here, "photographed"), "--poses", "6", "--samples", "1", "--images", "--seed", "3");
writeFileSync(join(here, "model.json"), JSON.stringify({format: "naocal-model", version: 1, with: ["elasticity@LKneePitsch"]}));
const second = await panelOf(bridge, join(here, "photographed"), join(here, "model.json"));
for (const time of ["first", "second"]) {
  const late = await quietPage(browser, second.address);
  await late.getByRole("heading", {name: "These captures could not be fitted"}).waitFor();
  check((await late.locator("#view").innerText()).includes("LKneePitsch"), "why there is no fit is said to the " + time + " who comes");
  await late.close();
}

// Captures of the same name, opened in succession, have their own photographs.
const viewer = await quietPage(browser, second.address), desks = new Set();
viewer.on("request", request => { if (request.url().includes("/picture/")) desks.add(request.url().split("?")[1]); });
mkdirSync(join(here, "again"));
cpSync(join(here, "photographed"), join(here, "again/photographed"), {recursive: true});
for (const [count, path] of [[1, "photographed"], [2, "again/photographed"]]) {
  await viewer.getByRole("button", {name: "Files", exact: true}).last().click();
  await viewer.getByLabel("path of what to open").fill(join(here, path));
  await viewer.getByRole("button", {name: "Open", exact: true}).click();
  await until(() => desks.size >= count);
}
check(desks.size === 2, "photographs of captures that are opened later are asked for anew: " + [...desks].join());
await viewer.close();

// A page of another site can neither connect to the bridge nor read from it, even with its address.
const stranger = createServer((request, response) => { response.setHeader("Content-Type", "text/html"); response.end("<!doctype html><title>x</title>"); });
await new Promise(resolve => stranger.listen(0, "127.0.0.1", resolve));
const own = await quietPage(browser, second.address), photograph = second.address + "picture/photographed/0";
check(await own.evaluate(async address => (await fetch(address)).status, photograph) === 200, "the panel's own page gets a photograph");
await own.close();
const foreign = await patientPage(browser), asked = new Map(), answered = new Map(); // by request id: URL, and status of the bridge's reply (hidden from the page by the browser)
const inspector = await foreign.context().newCDPSession(foreign);
inspector.on("Network.requestWillBeSent", ({requestId, request}) => asked.set(requestId, request.url));
inspector.on("Network.responseReceivedExtraInfo", ({requestId, statusCode}) => answered.set(requestId, statusCode)); // may precede the request's event
const statusesOf = () => Object.fromEntries([...answered].filter(([id]) => asked.get(id)?.startsWith(second.address)) // excludes the other site's own page
  .map(([id, status]) => [asked.get(id).slice(second.address.length), status]));
await inspector.send("Network.enable");
await foreign.goto("http://127.0.0.1:" + stranger.address().port + "/");
const tried = await foreign.evaluate(async address => ({
  live: await new Promise(resolve => {
    const socket = new WebSocket(address.replace("http", "ws") + "live");
    socket.onopen = () => resolve("open");
    socket.onclose = () => resolve("closed");
  }),
  read: await fetch(address, {mode: "no-cors"}).then(() => "read", () => "refused"),
  image: await new Promise(resolve => {
    const image = new Image();
    image.onload = () => resolve("shown");
    image.onerror = () => resolve("refused");
    image.src = address + "picture/photographed/0";
  }),
  script: await new Promise(resolve => {
    const script = document.createElement("script");
    script.onload = () => resolve("run");
    script.onerror = () => resolve("refused");
    script.src = address + "panel.js";
    document.head.append(script);
  }),
}), second.address);
check(JSON.stringify(tried) === '{"live":"closed","read":"refused","image":"refused","script":"refused"}', "a stranger's page gets nothing: " + JSON.stringify(tried));
await until(() => Object.keys(statusesOf()).length >= 3);
const statuses = statusesOf();
check(["", "picture/photographed/0", "panel.js"].every(path => statuses[path] === 403), "the bridge itself refuses it: " + JSON.stringify(statuses));
await second.stop("SIGTERM");
const unknown = await fetch(panel.address.replace(/[0-9a-f]{32}/, "0".repeat(32)));
check(unknown.status === 404, "another token finds nothing");
stranger.close();

// The bridge survives invalid paths, and replies while opening captures.
const answers = await page.evaluate(async path => {
  const socket = new WebSocket(location.href.replace(/^http/, "ws").replace(/#.*$/, "") + "live"), kinds = [];
  await new Promise(resolve => { socket.onopen = resolve; });
  const until = kind => new Promise(resolve => { socket.onmessage = ({data}) => { const told = JSON.parse(data); if (["stand", "refused", "opened"].includes(told.kind)) kinds.push(told.kind); if (told.kind === kind) resolve(); }; });
  const ask = request => socket.send(JSON.stringify(request));
  ask({do: "open", paths: ["x".repeat(5000)]});
  await until("refused");
  ask({do: "open", paths: [path]});
  ask({do: "stand", number: 1, angles: {}});
  await until("opened");
  if (!kinds.includes("stand")) await until("stand"); // small sets may be open before the reply
  socket.close();
  return kinds.join();
}, join(here, "flawed"));
check(["refused,stand,opened", "refused,opened,stand"].includes(answers), "a path that cannot be is refused, and the bridge answers while it opens captures: " + answers);
await rungs.first().waitFor();
await idle();

// The theme is stored, keys are listed, and the key u does nothing while the model is hidden.
await page.locator("#theme").click();
const theme = () => page.evaluate(() => document.documentElement.dataset.theme), chosen = await theme();
await page.reload();
await rungs.first().waitFor();
check(await theme() === chosen, "the theme is remembered: " + chosen);
await page.keyboard.press("?");
await page.getByRole("dialog").getByText("Stop: every calibration ends").waitFor();
check(await page.evaluate(() => !document.querySelector("dialog:modal")), "the list of keys leaves Stop in reach");
await page.screenshot({path: join(pictures, "keys.png")});
await page.getByRole("button", {name: "Close", exact: true}).click();
await tab("Custom effect");
await page.getByText("This can be added").waitFor();
await page.locator("#ownAdd").click();
await page.getByText("This is in the model already").waitFor();
await idle();
await tab("Live");
await page.locator("#model").waitFor({state: "hidden"});
await page.keyboard.press("u");
await page.waitForTimeout(300);
await tab("Learn");
await page.locator(".ladder li:nth-child(2) .rung").waitFor();
check(await page.locator(".ladder li:nth-child(2) .rung[aria-current=step]").count() === 1, "u leaves a model alone that is not shown");

// After the bridge ends, the panel says so and keeps its content.
await panel.stop("SIGKILL");
await page.getByText("bridge away").waitFor();
await tab("Compare");
await page.getByRole("heading", {name: "Where the prediction fails"}).waitFor();
await page.locator("#undo").click();
await page.getByText("The bridge is not connected").waitFor();
await page.screenshot({path: join(pictures, "bridge-away.png")});
await page.locator("#notice button").click();
await happens(page.getByText("If it was restarted, open the address that it prints").waitFor(), "the panel says what to do when the bridge was started anew");
await browser.close();
end();
