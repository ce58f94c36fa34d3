// The choice of a joint and a driver, and of the model whose residuals are shown.

let leftModel = "asGiven";

// Offers the models in each choice of the page; a change redraws all figures.
function offerModels() {
  for (const choice of document.querySelectorAll("select.model")) {
    choice.parentElement.parentElement.hidden = !data.left.withSuggested;
    choice.addEventListener("change", () => {
      leftModel = choice.value;
      for (const other of document.querySelectorAll("select.model")) other.value = leftModel;
      redrawAll();
    });
  }
}

function showWhatIf(parent) {
  const ranked = jointsByTrend(data);
  at("overWhatIf").hidden = !ranked.length;
  if (!ranked.length) return;
  const joint = at("bent"), driver = at("driver"), caption = element("figcaption");
  ranked.forEach(({joint: name}) => joint.append(element("option", "", name)));
  const first = data.candidates.length ? data.candidates[0].label.split("@")[1] : "";
  joint.selectedIndex = Math.max(0, ranked.findIndex(({joint: name}) => name === first)); // several joints move pictures alike
  const chosen = () => ranked[joint.selectedIndex].offered[driver.selectedIndex].driver;
  const redraw = canvasFigure(parent, 340, (context, width, height) =>
    drawWhatIf(context, width, height, {data, model: leftModel, joint: joint.value, driver: chosen(), caption}), "deflection of a joint over a driver");
  parent.append(caption);
  const offer = () => {
    driver.replaceChildren(...ranked[joint.selectedIndex].offered.map(({driver: {what}}) => element("option", "", what)));
    redraw();
  };
  joint.addEventListener("change", offer);
  driver.addEventListener("change", redraw);
  offer();
}
