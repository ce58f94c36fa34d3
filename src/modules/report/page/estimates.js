// Estimates with their error bars: one axis for each effect and unit.

function showEstimates(parent) {
  for (const {title, unit, rows} of data.groups) {
    parent.append(element("h3", "", title + (unit ? " [" + unit + "]" : "")));
    const ends = rows.flatMap(row => [row.low, row.high, 0]);
    const low = Math.min(...ends), high = Math.max(...ends), margin = 0.04 * (high - low || 1);
    const place = value => 100 * (value - low + margin) / (high - low + 2 * margin) + "%";
    const marks = ticks(low - margin, high + margin, 6);
    rows.forEach(row => parent.append(estimateRow(row, unit, place, marks)));
    const scale = element("div", "row");
    scale.append(element("span"), element("div", "ticks"));
    for (const mark of marks) {
      const number = scale.lastChild.appendChild(element("span", "", String(mark).replace("-", "−")));
      number.style.left = place(mark);
    }
    parent.append(scale);
  }
}

function estimateRow({name, value, sigma, low, high, learned}, unit, place, marks) {
  const row = element("div", "row"), axis = element("div", "axis");
  for (const mark of marks) {
    axis.appendChild(element("i", mark === 0 ? "zero" : "")).style.left = place(mark);
  }
  const bar = axis.appendChild(element("div", "bar"));
  bar.style.left = place(low);
  bar.style.right = "calc(100% - " + place(high) + ")";
  axis.appendChild(element("div", "dot")).style.left = place(value);
  const share = Math.round(100 * Math.max(0, learned));
  const told = element("span", learned < 0.5 ? "learned little" : "learned");
  told.append(element("span", "", share + " %"));
  told.style.setProperty("--share", share + "%");
  told.title = "learned from these captures";
  row.append(element("span", "", name), axis, element("span", "number", withError(value, sigma, unit)), told);
  return row;
}

function showWeak(parent) {
  if (!data.weak.length) return;
  parent.append(element("h3", "", "What these captures hardly tell"));
  const list = parent.appendChild(element("ul"));
  for (const {sentence, sigma, unit} of data.weak) {
    const left = unit === "rad" ? "± " + (sigma * 180 / Math.PI).toPrecision(2) + "° along this combination"
      : Math.round(100 * Math.min(1, sigma)) + " % of the uncertainty from before is left along this combination";
    list.append(element("li", "", sentence + " (" + left + ")"));
  }
}
