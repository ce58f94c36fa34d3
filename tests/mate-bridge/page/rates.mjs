// Frame rate of bridge and page for two cameras at 30 Hz, with overlays and plots. Images of a simulated robot are
// recorded first, as it cannot render that fast. A measurement, run by hand.
// Design limits of the panel: 2 s to the first picture, 15 Hz per camera.
// Usage: node rates.mjs NAOCAL-ROBOT MATE-BRIDGE NODE_MODULES CONFIGURATION
import {connect, createServer} from "node:net";
import {mkdirSync, readFileSync} from "node:fs";
import {join} from "node:path";
import {tools, check, panelOf, folder, quietPage, livePicture, end} from "./browser.mjs";
import {robotIn} from "./robotHere.mjs";

const [, , robotProgram, bridge, modules, configuration] = process.argv;
const {launch} = tools(modules), robot = robotIn(folder(), robotProgram, configuration, {periodSeconds: 1 / 30}), kept = folder();
const [subscribe, , update, requestList, list, , image] = [0, 1, 2, 3, 4, 5, 6];
const images = ["Brain.CameraCalibration.top_image", "Brain.CameraCalibration.bottom_image"], values = ["Motion.angles", "Brain.cameras"];

function frame(magic, version, header, type, body) {
  const head = Buffer.alloc(header);
  head.write(magic);
  head[4] = version;
  head[5] = type;
  head.writeUInt32LE(body.length, 8);
  return Buffer.concat([head, body]);
}
const debugFrame = (type, body) => frame("DMSG", 1, 16, type, Buffer.from(body));

// Splits received data into frames.
function reading(socket, header, told) {
  let bytes = Buffer.alloc(0);
  socket.on("data", data => {
    bytes = Buffer.concat([bytes, data]);
    while (bytes.length >= header && bytes.length >= header + bytes.readUInt32LE(8)) {
      const end = header + bytes.readUInt32LE(8);
      told(bytes[5], bytes.subarray(header, end));
      bytes = bytes.subarray(end);
    }
  });
  socket.on("error", () => {});
}
const keyOf = body => body.subarray(14, 14 + body.readUInt16LE(12)).toString();

// Records 20 images per camera, and the values.
const address = await robot.start(), pictures = new Map(images.map(key => [key, []])), latest = new Map();
await new Promise(resolve => {
  const socket = connect(join(address, "debug"));
  reading(socket, 16, (type, body) => {
    if (type === image) pictures.get(keyOf(body))?.push(Buffer.from(body));
    if (type === update) for (const one of JSON.parse(body)) latest.set(one.key, one);
    if (images.every(key => pictures.get(key).length >= 20) && values.every(key => latest.has(key))) { socket.destroy(); resolve(); }
  });
  for (const key of [...images, ...values]) socket.write(debugFrame(subscribe, key));
});
robot.kill();

// Fake robot that repeats the images at 30 Hz and the values at 83 Hz.
mkdirSync(join(kept, "robot"));
const begin = Date.now(), clients = new Set();
createServer(socket => {
  clients.add(socket);
  socket.on("close", () => clients.delete(socket));
  reading(socket, 16, type => {
    if (type === requestList) socket.write(debugFrame(list, JSON.stringify({keys: [...images.map(key => ({key, isImage: true})), ...values.map(key => ({key, isImage: false}))]})));
  });
}).listen(join(kept, "robot/debug"));
const {boards} = JSON.parse(readFileSync(join(configuration, "location/default/head/default/CalibrationRunner.json"), "utf8").replace(/\/\/.*$/gm, ""));
const [getMounts, getKeys, sendKeys, sendMounts] = [1, 2, 4, 5];
createServer(socket => reading(socket, 12, type => {
  if (type === getMounts) socket.write(frame("CONF", 2, 12, sendMounts, Buffer.from(JSON.stringify({keys: [{key: "Brain.CalibrationRunner", filename: ""}]}))));
  if (type === getKeys) socket.write(frame("CONF", 2, 12, sendKeys, Buffer.from(JSON.stringify({mountPoint: "Brain.CalibrationRunner", keys: [{key: "boards", value: boards}]}))));
})).listen(join(kept, "robot/config"));
let round = 0;
const send = bytes => clients.forEach(socket => socket.write(bytes));
setInterval(() => {
  ++round;
  for (const key of images) {
    const body = Buffer.from(pictures.get(key)[round % 20]);
    body.writeBigUInt64LE(BigInt(Date.now() - begin), 0);
    send(debugFrame(image, body));
  }
}, 1000 / 30);
setInterval(() => send(debugFrame(update, JSON.stringify(values.map(key => ({...latest.get(key), timestamp: Date.now() - begin}))))), 12);

const processor = pid => {
  const [user, system] = readFileSync("/proc/" + pid + "/stat", "utf8").split(" ").slice(13, 15).map(Number);
  return (user + system) / 100;
};
const panel = await panelOf(bridge, "--robot", join(kept, "robot")), browser = await launch();
const opened = Date.now(), page = await quietPage(browser, panel.address);
await livePicture(page);
const first = Date.now() - opened;
check(first < 2000, "the first live picture is there in less than 2 s: " + first + " ms");
for (const view of ["Calibrate", "Live"]) {
  await page.getByRole("button", {name: view, exact: true}).click();
  await livePicture(page);
  if (view === "Live") await page.getByLabel("Motion.angles").check();
  const before = processor(panel.pid);
  await page.waitForTimeout(10000);
  const captions = await page.locator(".camera figcaption").allInnerTexts();
  console.log("measured: " + view + ": " + captions.join("; ") + "; the bridge takes " + (10 * (processor(panel.pid) - before)).toFixed(0) + " % of a core");
  check(captions.length === 2 && captions.every(caption => Number(caption.match(/(\d+) pictures? a second/)?.[1]) >= 15), view + " shows 15 pictures a second or more of each camera");
}
await browser.close();
await panel.stop("SIGTERM");
end();
