// Map view: all views of the remaining misfit.
import {button, element, empty} from "naocal/lib/dom.js";
import {waitingWords} from "naocal/lib/format.js";
import {views} from "naocal/views/views.js";
import {state} from "../core/state.js";
import {captureAt} from "./finding.js";
import {draftFrom} from "./user-effect.js";

const title = "What each joint's error depends on";

export function showMap(parent, go) {
  const {diagnosis} = state;
  if (!diagnosis) {
    parent.replaceChildren(element("h1", {}, title), empty(waitingWords(state.fit), "How well would a curve of each joint explain the misfit?"));
    return;
  }
  const tools = {
    open: index => { // opens the capture of a clicked point
      state.chosen = captureAt(index);
      go("compare");
    },
    ownEffect: ({model}) => button("Turn into a custom effect", () => { draftFrom(model.define[0]); go("own"); }, {class: "small"}),
  };
  const sections = views.filter(({about}) => about === "misfit").map(view => ({...view, parts: (view.show(diagnosis, tools) ?? []).filter(part => part !== null)}))
    .filter(({parts}) => parts.length);
  parent.replaceChildren(element("h1", {}, title),
    ...(diagnosis.map.length ? [] : [empty("There is no map", "No joint of these captures moved enough for a curve.",
      element("span", {class: "controls next-steps"}, button("Suggest poses that move them", () => go("next"), {class: "main"})))]),
    ...sections.flatMap(section => [...(section.title === title ? [] : [element("h2", {}, section.title)]), ...section.parts]));
}
