// A camera's live picture; its place stays as large before and after it comes.
import {make} from "./elements.js";

export class Camera {
  constructor(label) {
    this.canvas = make("canvas", {width: 640, height: 480, role: "img", "aria-label": label});
    this.caption = make("figcaption", {}, "waiting for the first picture");
    this.times = [];
  }

  async show(file, {width, height}) {
    let image;
    try {
      image = await createImageBitmap(file);
    } catch {
      this.caption.textContent = "the robot sent a picture that this browser cannot read";
      return;
    }
    const {canvas, times} = this;
    if (canvas.width !== image.width || canvas.height !== image.height) Object.assign(canvas, {width: image.width, height: image.height});
    canvas.getContext("2d").drawImage(image, 0, 0);
    image.close();
    times.push(performance.now());
    while (times.length > 30) times.shift();
    const rate = times.length > 1 ? 1000 * (times.length - 1) / (times[times.length - 1] - times[0]) : 0;
    this.caption.textContent = width + " × " + height + " px, " + rate.toFixed(0) + " pictures a second";
  }
}

// Which of a robot's pictures are its two cameras'.
export function cameraKeys(list) {
  const images = list.filter(({isImage}) => isImage).map(({key}) => key);
  const top = images.find(key => /top/i.test(key)), bottom = images.find(key => /bottom/i.test(key));
  return {images, chosen: [top || images[0] || null, bottom || null]};
}
