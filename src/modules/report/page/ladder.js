// The error on unseen poses after each addition, as bars that fall to the band of the noise.

function showLadder(parent) {
  const floor = data.steps[data.steps.length - 1].floor;
  const error = step => step.heldOut ?? step.rms; // of one pose none is left to try the fit on
  const most = 1.05 * Math.max(floor, ...data.steps.map(error));
  const place = value => 100 * value / most + "%";
  data.steps.forEach((step, i) => {
    const row = parent.appendChild(element("div", "rung")), axis = element("div", "axis");
    axis.appendChild(element("div", "band")).style.width = place(floor);
    axis.appendChild(element("div", "bar")).style.width = place(error(step));
    const dropped = step.dropped.map(label => " − " + label).join("");
    row.append(element("span", "", step.added ? "+ " + step.added + dropped : "base model"), axis,
      element("span", "number", px(error(step))));
    const previous = error(data.steps[i ? i - 1 : i]);
    tipOver(row, (step.added ? "with " + step.added : "base model") +
      (step.dropped.length ? ", which makes superfluous: " + step.dropped.join(", ") : "") +
      (step.heldOut === null ? "" : "\non unseen poses: " + px(step.heldOut) + (i ? " (" + px(previous) + " before)" : "")) + "\non the poses it was fitted to: " + px(step.rms) +
      " rms\n" + data.floorName + ": " + px(floor) + "\nchance that noise looks like something missing: " + chance(step.alarm));
  });
  const last = parent.appendChild(element("div", "rung")), axis = element("div", "axis");
  axis.appendChild(element("div", "band")).style.width = place(floor);
  last.append(element("span", "soft", data.floorName), axis, element("span", "number soft", px(floor)));
}

function showCommand(parent) {
  if (!data.suggested.length) return;
  parent.append(data.own ? copyBox("Calibrate with what is suggested (SET: the captures' folder; model.json: what stands below the first curve):",
    "naocal solve SET --model model.json -o result.json")
    : copyBox("Calibrate with what is suggested (SET: the captures' folder):",
      "naocal solve SET --with " + data.suggested.join(",") + " -o result.json"));
}
