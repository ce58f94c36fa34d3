// Puts the page together.

const at = id => document.getElementById(id);

function showVerdict() {
  at("verdict").classList.toggle("usable", data.usable);
  at("headline").textContent = data.headline;
  document.title = "NAO " + data.robot + ": " + data.headline;
  at("about").textContent = "Calibration of a NAO " + data.robot + " from " + data.sets.join(", ");
  for (const {figure, sentence} of data.facts) {
    const fact = at("facts").appendChild(element("div"));
    fact.append(element("dt", "", figure), element("dd", "", sentence));
  }
  data.warnings.forEach(warning => at("warnings").append(element("li", "", warning)));
}

// The joints that moved enough to tell anything.
function movedJoints() {
  const names = new Set(data.pictures.flatMap(picture => Object.keys(picture.angles)));
  return [...names].filter(joint => {
    const angles = data.pictures.map(picture => picture.angles[joint]).filter(angle => angle !== undefined);
    return Math.max(...angles) - Math.min(...angles) > 1;
  });
}

function showAngles() {
  const joints = movedJoints();
  joints.forEach(joint => at("joint").append(element("option", "", joint)));
  at("joint").parentElement.hidden = !joints.length;
  if (!joints.length) {
    at("noAngles").textContent = "No joint angles: " + (data.missing.join("; ") || "no joint moved by more than 1°") + ".";
    return;
  }
  const redraw = showTrend(at("angles"), picture => picture.angles[at("joint").value], () => at("joint").value + " [°]",
    "mean errors over a joint's angle");
  at("joint").addEventListener("change", redraw);
}

function showPhotographs() {
  const kept = data.pictures.filter(picture => picture.photograph).length;
  at("photographs").textContent = kept === data.pictures.length ? ""
    : kept ? "Photographs of the " + kept + " worst pictures are part of this page."
    : "No photographs were kept with these captures: the frames are empty.";
}

function showAll() {
  showVerdict();
  showEstimates(at("estimates"));
  showWeak(at("weak"));
  showPhotographs();
  for (let i = 0; i < Math.min(picturesPerPage, data.pictures.length); ++i) slots.push(pictureSlot(at("pictures")));
  showPage();
  showFields(at("fields"));
  showGroups(at("poses"), byTime.map(picture => ({group: (severalSets ? picture.set + "/" : "") + picture.pose,
    corners: picture.corners, picture, name: pictureName(picture)})), "poses in the order they were first taken", "errors by pose");
  showGroups(at("boards"), [...boardViews].sort((a, b) => a.board < b.board ? -1 : a.board > b.board).map(view => ({group: view.board,
    corners: view.corners, picture: view.picture, name: "board " + view.board + " in " + pictureName(view.picture)})), "boards", "errors by board");
  showAngles();
  showTrend(at("times"), picture => picture.when, () => severalSets ? "time [s], sets one after the other" : "time [s]",
    "mean errors over time");
  at("origin").textContent = data.missing.join("; ");
}

for (const choice of document.getElementsByName("layer")) {
  choice.addEventListener("change", () => { layer = choice.value; redrawAll(); });
}
at("order").addEventListener("change", () => { firstShown = 0; showPage(); });
at("previous").addEventListener("click", () => turnPage(-1));
at("next").addEventListener("click", () => turnPage(1));
showAll();
