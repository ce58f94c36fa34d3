// What the page shows, as flat lists of corners and of boards in pictures.

// Which error is shown: "reported" with the joints' readings as they are, "fitted" with readings moved within their
// noise.
let layer = "reported";

const corners = []; // {picture, board, id, u, v, reported: [du, dv], fitted: [du, dv], weight}
const boardViews = []; // {picture, board, corners}
for (const picture of data.pictures) {
  picture.corners = [];
  for (const view of picture.boards) {
    const seen = view.ids.map((id, i) => ({
      picture, board: view.board, id,
      u: view.measured[2 * i], v: view.measured[2 * i + 1],
      reported: view.reported.slice(2 * i, 2 * i + 2), fitted: view.fitted.slice(2 * i, 2 * i + 2),
      weight: view.weight ? view.weight[i] : 1,
    }));
    boardViews.push({picture, board: view.board, corners: seen});
    picture.corners.push(...seen);
    corners.push(...seen);
  }
}

// Sets one after the other, each from its own first picture on.
let laterSetsStart = 0;
for (const set of new Set(data.pictures.map(picture => picture.set))) {
  const own = data.pictures.filter(picture => picture.set === set);
  const times = own.map(picture => picture.time);
  const first = times.reduce((a, b) => Math.min(a, b)), last = times.reduce((a, b) => Math.max(a, b));
  own.forEach(picture => { picture.when = laterSetsStart + picture.time - first; });
  laterSetsStart += 1.05 * (last - first) + 1;
}

const severalSets = new Set(data.pictures.map(picture => picture.set)).size > 1;
const byTime = [...data.pictures].sort((a, b) => a.when - b.when);

const rms = list => Math.sqrt(mean(list.map(corner => lengthOf(corner[layer]) ** 2)));
const meanError = list => [mean(list.map(corner => corner[layer][0])), mean(list.map(corner => corner[layer][1]))];

// "capture 17, pose P05 (repeat 1), top camera"
function pictureName(picture) {
  return (severalSets ? picture.set + ", " : "") + "capture " + picture.capture + ", pose " + (picture.pose || "–") +
    (picture.repeat ? " (repeat " + picture.repeat + ")" : "") + ", " + picture.camera + " camera";
}
