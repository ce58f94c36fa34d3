// The joint by driver map: how well a curve of a joint over a driver explains what is left over.

function showMap(parent) {
  at("overMap").hidden = !data.map.length;
  if (!data.map.length) return;
  const best = bestOf(data.map);
  at("mapWords").textContent = best.evidence > 0
    ? "Best: " + best.joint + " over " + driverWords(best.driver) + " (evidence " + tenths(best.evidence) + ")."
    : "Here it is empty: nothing is left.";
  canvasFigure(parent, mapHeight(data.map), (context, width, height) => drawMap(context, width, height, data.map),
    "evidence by joint and driver");
}
