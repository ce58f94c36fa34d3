// Errors by pose or by board: a dot for each member, a dash for the rms of a group.

// members: {group, corners, picture, name}; groups stand in the order of their first member.
function showGroups(parent, members, xLabel, label) {
  const groups = new Map();
  for (const member of members) {
    if (!groups.has(member.group)) groups.set(member.group, []);
    groups.get(member.group).push(member);
  }
  canvasFigure(parent, () => 280, (context, width, height) => {
    const values = members.map(member => rms(member.corners));
    const highest = 1.08 * values.reduce((a, b) => Math.max(a, b), 1e-3);
    const box = {left: 45, right: width - 5, top: 30, bottom: height - 40};
    const {x, y, line} = axes(context, box, [-0.5, groups.size - 0.5], [0, highest], {title: "rms error [px]"});
    const targets = [];
    [...groups].forEach(([name, list], place) => {
      const half = Math.min(20, 0.4 * (x(1) - x(0)));
      list.forEach((member, i) => {
        const across = list.length > 1 ? (i / (list.length - 1) - 0.5) * 1.2 * half : 0;
        targets.push({x: x(place) + across, y: y(rms(member.corners)), picture: member.picture,
          tip: () => member.name + "\n" + px(rms(member.corners)) + " rms; all of " + name + ": " +
            px(rms(list.flatMap(other => other.corners)))});
      });
      context.strokeStyle = colours.predicted;
      context.lineWidth = 3;
      const level = y(rms(list.flatMap(member => member.corners)));
      line(x(place) - Math.max(half, 2), level, x(place) + Math.max(half, 2), level);
    });
    context.fillStyle = colours.measured;
    context.globalAlpha = 0.65;
    for (const target of targets) { context.beginPath(); context.arc(target.x, target.y, 2.5, 0, 7); context.fill(); }
    context.globalAlpha = 1;
    noiseLine(context, box, y, highest);
    groupNames(context, [...groups.keys()], box, x, xLabel);
    return targets;
  }, label);
}

// What the corners' noise alone would leave.
function noiseLine(context, box, y, highest) {
  const level = Math.SQRT2 * data.pixelNoise;
  if (level > highest) return;
  context.strokeStyle = context.fillStyle = colours.soft;
  context.lineWidth = 1;
  context.setLineDash([6, 4]);
  context.beginPath();
  context.moveTo(box.left, y(level));
  context.lineTo(box.right, y(level));
  context.stroke();
  context.setLineDash([]);
  context.textAlign = "right";
  context.textBaseline = "bottom";
  context.fillText("corner noise alone", box.right, y(level) - 2);
}

// Names where they fit, else only what stands along the axis.
function groupNames(context, names, box, x, xLabel) {
  context.fillStyle = colours.soft;
  context.textAlign = "center";
  context.textBaseline = "top";
  const room = x(1) - x(0), widest = Math.max(...names.map(name => context.measureText(name).width));
  if (widest + 6 < room) names.forEach((name, place) => context.fillText(name, x(place), box.bottom + 6));
  context.fillText(xLabel, (box.left + box.right) / 2, box.bottom + 22);
}
