// Puts the page about a result together.

// Pictures of one pose share its joints' errors.
const poseOf = picture => (severalSets ? picture.set + "/" : "") + picture.pose;

// The joints that moved enough to tell anything, the strongest trend first.
function movedJoints() {
  const names = new Set(data.pictures.flatMap(picture => Object.keys(picture.angles)));
  const joints = [...names].map(name => ({name, points: trendPoints(picture => picture.angles[name], poseOf)}));
  return joints.filter(({points}) => {
    const angles = points.map(point => point.x);
    return Math.max(...angles) - Math.min(...angles) > 1;
  }).map(({name, points}) => ({name, strength: trendStrength(points)})).sort((a, b) => b.strength - a.strength);
}

function showAngles() {
  const joints = movedJoints(), choice = at("joint");
  joints.forEach(({name}) => choice.append(element("option", "", name)));
  choice.parentElement.hidden = !joints.length;
  if (data.missing.length) at("noAngles").textContent = "Joint angles are missing: " + data.missing.join("; ") + ".";
  else if (!joints.length) at("noAngles").textContent = "No joint moved by more than 1°.";
  if (!joints.length) return;
  choice.addEventListener("change", showTrend(at("angles"), {
    valueOf: picture => picture.angles[choice.value], groupOf: poseOf,
    xLabel: () => choice.value + " [°]", label: "mean errors over a joint's angle",
  }));
}

function showTimes() {
  showTrend(at("times"), {
    valueOf: picture => picture.when, groupOf: picture => poseOf(picture) + "/" + picture.repeat,
    xLabel: () => severalSets ? "time [s], sets one after the other" : "time [s]", label: "mean errors over time",
  });
}

function showPoses() {
  const members = byTime.map(picture =>
    ({group: poseOf(picture), corners: picture.corners, picture, name: pictureName(picture)}));
  showGroups(at("poses"), members, "poses in the order they were first taken", "errors by pose");
}

function showBoards() {
  const compared = (a, b) => a < b ? -1 : a > b ? 1 : 0;
  const views = [...boardViews].sort((a, b) => compared(a.board, b.board) || a.picture.when - b.picture.when);
  const members = views.map(({board, corners, picture}) =>
    ({group: board, corners, picture, name: "board " + board + " in " + pictureName(picture)}));
  showGroups(at("boards"), members, "boards", "errors by board");
}

function showPictures() {
  const count = data.pictures.length, kept = data.pictures.filter(picture => picture.photograph).length;
  at("photographs").textContent = kept === count ? ""
    : kept ? "Photographs of the " + kept + " worst pictures are part of this page."
    : "The frames are empty: " + (data.missing.join("; ") || "no photographs were kept with the captures") + ".";
  for (let i = 0; i < Math.min(picturesPerPage, count); ++i) slots.push(pictureSlot(at("pictures")));
  showPage();
}

at("layer").addEventListener("change", () => {
  layer = at("layer").value;
  showPage();
  redrawAll();
});
at("order").addEventListener("change", () => { firstShown = 0; showPage(); });
at("previous").addEventListener("click", () => turnPage(-1));
at("next").addEventListener("click", () => turnPage(1));
showVerdict((data.sentence ? data.sentence + " " : "") + "From " + data.sets.join(", ") + ".", data.warnings);
at("verdict").classList.add(data.verdict);
document.title = "NAO " + data.robot + ": " + data.headline;
showEstimates(at("estimates"));
showWeak(at("weak"));
showPictures();
showFields(at("fields"));
showPoses();
showBoards();
showAngles();
showTimes();
