// A robot behind a slow network (100 ms round trip, 2 % packet loss, 1 Mbit/s), over TCP with a secret: the secret is
// requested, pictures and values arrive, a parameter is set, the network fails and returns. Proves that the panel
// reports the state, reconnects, and does not need the secret again. Skipped without network namespaces (root and
// /dev/net/tun).
// Usage: node network.mjs NAOCAL-ROBOT MATE-BRIDGE NODE_MODULES CONFIGURATION PICTURES SLOW_LINK
import {cpSync, existsSync, writeFileSync} from "node:fs";
import {execFileSync, spawn} from "node:child_process";
import {join} from "node:path";
import {tools, skip, check, happens, panelOf, folder, quietPage, livePicture, portrait, started, end} from "./browser.mjs";

const [, , robotProgram, bridge, modules, configuration, pictures, slowLink] = process.argv;
const {launch, axe} = tools(modules), here = folder(), space = "naocal-" + process.pid;
const ip = (...words) => execFileSync("ip", words, {stdio: "ignore"});

if (process.getuid() !== 0 || !existsSync("/dev/net/tun")) skip("no namespaces can be made here");
try { ip("netns", "add", space); } catch { skip("no namespaces can be made here"); }
process.on("exit", () => { try { ip("netns", "del", space); } catch { /* already deleted */ } });

// 50 ms in each direction.
async function connectNetwork() {
  const link = await started(slowLink, space, "50", "2", "1000");
  ip("addr", "add", "10.231.77.1/30", "dev", "slow0");
  ip("link", "set", "slow0", "up");
  for (const words of [["addr", "add", "10.231.77.2/30", "dev", "slow1"], ["link", "set", "slow1", "up"], ["link", "set", "lo", "up"]]) ip("-n", space, ...words);
  return link;
}

cpSync(configuration, join(here, "configuration"), {recursive: true});
writeFileSync(join(here, "configuration/location/default/access.json"), JSON.stringify({address: "0.0.0.0", secret: "open sesame", trustedNetwork: false}));
let link = await connectNetwork();
const robot = spawn("ip", ["netns", "exec", space, robotProgram, "--configuration", join(here, "configuration"), "--state", join(here, "state"), "--recordings", join(here, "recordings")], {stdio: "ignore"});
process.on("exit", () => robot.kill("SIGKILL"));

const panel = await panelOf(bridge, "--robot", "10.231.77.2"), browser = await launch();
const page = await quietPage(browser, panel.address);
const tab = name => page.getByRole("button", {name, exact: true}).click();

// Wrong and correct secret.
const secret = page.getByLabel("secret of 10.231.77.2");
await secret.waitFor();
await portrait(page, axe, pictures, "secret");
await secret.fill("open bar");
await page.evaluate(async () => { // another client connects to another robot meanwhile
  const socket = new WebSocket(location.href.replace(/^http/, "ws").replace(/#.*$/, "") + "live");
  await new Promise(resolve => { socket.onopen = resolve; });
  socket.send(JSON.stringify({do: "connect", robot: "/nowhere"}));
  await new Promise(resolve => { socket.onmessage = ({data}) => { if (typeof data === "string" && data.includes("/nowhere")) resolve(); }; });
  socket.close();
});
await page.getByLabel("disconnect from /nowhere").waitFor();
await page.keyboard.type("ley");
check(await secret.inputValue() === "open barley", "a secret that is half typed stays while another robot has news");
await page.getByLabel("disconnect from /nowhere").click();
await page.getByLabel("disconnect from /nowhere").waitFor({state: "detached"});
await page.getByRole("button", {name: "Send secret"}).click();
await happens(page.getByText("closed the connection").first().waitFor(), "a wrong secret is refused, and said to be");
await page.locator(".robot.connected").waitFor();
await secret.waitFor();
await secret.fill("open sesame");
const told = Date.now();
await page.getByRole("button", {name: "Send secret"}).click();
await livePicture(page);
console.log("measured: over the slow network, from the secret to the first live picture: " + (Date.now() - told) + " ms");
await page.waitForTimeout(6000);
console.log("measured: over the slow network: " + (await page.locator(".camera figcaption").allInnerTexts()).join("; "));
await page.screenshot({path: join(pictures, "slow-network.png")});

// A parameter can be set while data are queued.
await tab("Configuration");
await page.getByLabel("filter modules").fill("CalibrationRunner");
await page.getByRole("button", {name: "Brain.CalibrationRunner", exact: true}).click();
await page.getByLabel("repeats", {exact: true}).fill("3");
const set = Date.now();
await page.getByRole("button", {name: "set repeats"}).click();
await happens(page.waitForFunction(() => document.getElementById("parameter-repeats")?.value === "3" && !document.querySelector(".edited")), "a parameter is set over a slow network");
console.log("measured: over the slow network, from setting a parameter to the robot's answer: " + (Date.now() - set) + " ms");

// The network fails and returns.
await link.stop("SIGKILL");
await happens(page.getByText(/Nothing can be set until it is back/).waitFor(), "the panel says that the robot is gone");
await tab("Calibrate");
await page.locator(".camera figcaption", {hasText: "last picture received"}).first().waitFor();
link = await connectNetwork();
const back = Date.now();
await page.locator(".robot.connected").waitFor();
await livePicture(page);
console.log("measured: from the network's return to the first picture: " + (Date.now() - back) + " ms");
check(await secret.count() === 0, "the secret is not asked for again");
await browser.close();
await panel.stop("SIGTERM");
await link.stop("SIGTERM");
end();
