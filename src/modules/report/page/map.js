// The joint by driver map: how well a curve of a joint over a driver explains what is left over.

const driverWords = name => name === "t" ? "time" : name === "approach" ? "how it was approached"
  : name === "T" ? "its temperature" : name === "qd" ? "its speed"
  : name.startsWith("tau_") ? "the torque on " + name.slice(4) : "the angle of " + name;

function showMap(parent) {
  at("overMap").hidden = !data.map.length;
  if (!data.map.length) return;
  const joints = [...new Set(data.map.map(cell => cell.joint))];
  const rank = name => joints.includes(name) ? 0 : name.startsWith("tau_") ? 1 : 2;
  const drivers = [...new Set(data.map.map(cell => cell.driver))].sort((a, b) => rank(a) - rank(b));
  const best = data.map.reduce((a, b) => a.evidence > b.evidence ? a : b);
  at("mapWords").textContent = best.evidence > 0
    ? "Best: " + best.joint + " over " + driverWords(best.driver) + " (evidence " + tenths(best.evidence) + ")."
    : "Here it is empty: nothing is left.";
  canvasFigure(parent, width => 112 + joints.length * Math.max(13, Math.min(22, width / 40)),
    (context, width, height) => drawMap(context, width, height, {joints, drivers, best}), "evidence by joint and driver");
}

function drawMap(context, width, height, {joints, drivers, best}) {
  context.font = "11px system-ui, sans-serif";
  const left = 95, top = 110, wide = (width - left - 2) / drivers.length, high = (height - top - 2) / joints.length;
  const most = Math.max(6, best.evidence); // 6: below it nothing deserves the darkest
  context.textBaseline = "middle";
  context.textAlign = "right";
  context.fillStyle = colours.soft;
  joints.forEach((joint, row) => context.fillText(joint, left - 6, top + (row + 0.5) * high));
  const every = Math.ceil(12 / wide);
  context.textAlign = "left";
  drivers.forEach((driver, column) => {
    if (column % every) return;
    context.save();
    context.translate(left + (column + 0.5) * wide, top - 5);
    context.rotate(-Math.PI / 2);
    context.fillText(driver, 0, 0);
    context.restore();
  });
  const gap = wide > 6 ? 1 : 0;
  return data.map.map(cell => {
    const x = left + drivers.indexOf(cell.driver) * wide, y = top + joints.indexOf(cell.joint) * high;
    context.fillStyle = colours.panel;
    context.fillRect(x, y, wide - gap, high - 1);
    context.fillStyle = colours.blue;
    context.globalAlpha = Math.sqrt(Math.max(0, cell.evidence) / most);
    context.fillRect(x, y, wide - gap, high - 1);
    context.globalAlpha = 1;
    if (cell === best && cell.evidence > 0) {
      context.strokeStyle = colours.orange;
      context.lineWidth = 2;
      context.strokeRect(x, y, wide - gap, high - 1);
    }
    return {
      x: x + wide / 2, y: y + high / 2, tip: () => cell.joint + " over " + driverWords(cell.driver) + "\nevidence " +
        tenths(cell.evidence) + ", alone " + chance(cell.pValue),
    };
  });
}
