// Live picture of a camera with the corners detected by the bridge: ring = measured, cross = predicted.
import {contextOf, element} from "naocal/lib/dom.js";
import {px} from "naocal/lib/format.js";
import {rms} from "naocal/lib/statistics.js";
import {drawCorner} from "naocal/plots/corners.js";

const corners = 700; // display time of detected corners [ms]

const made = new Map(); // by place on the page

// One camera per place; it keeps its last picture when the view is redrawn.
export function cameraAt(place, label) {
  if (!made.has(place)) made.set(place, new Camera(label));
  return made.get(place);
}

class Camera {
  constructor(label) {
    this.canvas = element("canvas", {width: 640, height: 480, role: "img", "aria-label": label});
    this.caption = element("figcaption", {}, "waiting for the first picture");
    this.rests = element("p", {class: "rests soft"}); // basis of the comparison
    this.times = [];
    this.found = null;
    this.decoding = false;
  }

  async show(file, {width, height, timestamp}) {
    if (this.decoding) return; // drops pictures while decoding
    this.decoding = true;
    let image;
    try {
      image = await createImageBitmap(file);
    } catch {
      this.caption.textContent = "this browser cannot read the robot's picture";
      return;
    } finally {
      this.decoding = false;
    }
    const {canvas, times} = this;
    if (canvas.width !== image.width || canvas.height !== image.height) Object.assign(canvas, {width: image.width, height: image.height});
    const context = contextOf(canvas);
    context.drawImage(image, 0, 0);
    image.close();
    const words = this.drawFound(context, timestamp);
    if (times.length && performance.now() - times[times.length - 1] > 3000) times.length = 0; // restarts the rate after a pause of 3 s
    times.push(performance.now());
    while (times.length > 30) times.shift();
    this.caption.textContent = width + " × " + height + " px" + rateOf(times) + words;
    if (words) this.rests.textContent = this.found.rests || "";
  }

  drawFound(context, now) {
    if (!this.found || Math.abs(now - this.found.timestamp) > corners) return "";
    const all = this.found.boards.flatMap(({measured, predicted}) => measured.filter((_, i) => i % 2 === 0).map((x, i) => {
      const y = measured[2 * i + 1], told = predicted.length > 0; // no prediction: the board is not on the floor, or hardly seen
      return {x, y, ...(told ? {endX: predicted[2 * i], endY: predicted[2 * i + 1]} : {})};
    }));
    const scale = context.canvas.width / 640;
    const scaled = all.map(one => Object.fromEntries(Object.entries(one).map(([name, value]) => [name, (value + 0.5) / scale])));
    context.save();
    context.scale(scale, scale);
    for (const halo of [true, false]) scaled.forEach(corner => drawCorner(context, corner, halo));
    context.restore();
    if (!all.length) return "; no board";
    const predicted = all.filter(({endX}) => endX !== undefined);
    return "; " + this.found.boards.map(({board}) => "board " + board).join(", ") + ": " + all.length + " corners, " + (!predicted.length ? "not predicted: not on the floor"
      : (predicted.length < all.length ? predicted.length + " of them " : "") + "predicted " + px(rms(predicted.map(({x, y, endX, endY}) => Math.hypot(endX - x, endY - y)))) + " off");
  }
}

// Frame rate; empty for the first picture.
function rateOf(times) {
  if (times.length < 2) return "";
  const rate = (1000 * (times.length - 1) / (times[times.length - 1] - times[0])).toFixed(0);
  return ", " + rate + (rate === "1" ? " picture a second" : " pictures a second");
}

// Keys of all images, and of the top and bottom camera.
export function cameraKeys(list) {
  const images = list.filter(({isImage}) => isImage).map(({key}) => key);
  const top = images.find(key => /top/i.test(key)), bottom = images.find(key => /bottom/i.test(key));
  return {images, chosen: [top || images[0] || null, bottom || null]};
}
