// Exports the session as one HTML file: all views with content, canvases as images.
import {contextOf, download, element} from "naocal/lib/dom.js";
import {notice, state} from "./state.js";

let views = [];
export const offerViews = given => { views = given; }; // [{name, show(parent), own?: exports the view as displayed}]

const titleNow = () => "naocal session" + (state.set ? ", " + state.set.names.join(", ") : "");

// What the page is about, who wrote it and when, what is said of the fit, and the contents.
function head(contents) {
  const {set, start, fit} = state;
  const written = "Written by " + (start?.program ?? "naocal") + ", " + new Date().toISOString().slice(0, 16).replace("T", " ") + " UTC";
  const robots = [set && set.headId ? "robot with head " + set.headId : "", ...state.robots.keys()].filter(Boolean).join(", ");
  return element("header", {}, element("h1", {}, titleNow()), element("p", {class: "soft"}, [written, robots].filter(Boolean).join("; ") + "."),
    fit ? element("p", {}, element("b", {}, fit.headline), " " + fit.sentence) : "", element("nav", {"aria-label": "contents"}, contents));
}

const pause = () => new Promise(resolve => setTimeout(resolve, 60));

export async function saveSession() {
  const page = element("main"), contents = element("ol"), stage = document.body.appendChild(element("div", {class: "stage", "aria-hidden": "true"}));
  stage.inert = true;
  try {
    for (const {name, show, shows} of views) {
      if (!shows()) continue;
      const parent = stage.appendChild(element("section"));
      show(parent);
      for (let i = 0; i < 4; ++i) await pause(); // figures are drawn after layout
      await Promise.all([...parent.querySelectorAll("img")].map(image => image.decode().catch(() => {})));
      const id = "view-" + page.children.length;
      contents.append(element("li", {}, element("a", {href: "#" + id}, name)));
      page.append(element("section", {id}, element("p", {class: "soft"}, name), still(parent)));
      parent.remove();
    }
    page.prepend(head(contents));
    const style = await (await fetch("panel.css")).text(), title = titleNow();
    const theme = document.documentElement.dataset.theme;
    download("session.html", "<!doctype html>\n<html lang=\"en\"" + (theme ? " data-theme=\"" + theme + "\"" : "") + "><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">" +
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; img-src data:\">" + element("title", {}, title).outerHTML +
      "<style>" + style + "main { display: block; padding: 1rem 1.4rem; } section { margin-bottom: 3rem; } img.drawing { width: 100%; }</style></head><body>" + page.outerHTML + "</body></html>\n", "text/html");
  } catch (error) {
    notice("The session could not be written: " + (error instanceof Error ? error.message : error) + ".");
  } finally {
    stage.remove();
  }
}

// Static copy: canvases become images, selects text; buttons are removed.
function still(parent) {
  const copy = parent.cloneNode(true), drawn = [...parent.querySelectorAll("canvas")];
  [...copy.querySelectorAll("canvas")].forEach((canvas, i) => canvas.replaceWith(element("img", {src: drawn[i].toDataURL("image/png"),
    alt: drawn[i].getAttribute("aria-label") || "", class: "drawing"})));
  const pictures = [...parent.querySelectorAll("img")];
  [...copy.querySelectorAll("img[src^='taken/']")].forEach(image => {
    const original = pictures.find(one => one.src === image.src), canvas = element("canvas", {width: original.naturalWidth || 1, height: original.naturalHeight || 1});
    contextOf(canvas).drawImage(original, 0, 0);
    image.src = canvas.toDataURL("image/jpeg", 0.8);
  });
  const choices = [...parent.querySelectorAll("select")];
  [...copy.querySelectorAll("select")].forEach((select, i) => select.replaceWith(choices[i].selectedOptions[0]?.text || ""));
  const fields = [...parent.querySelectorAll("input[type=text], textarea")];
  [...copy.querySelectorAll("input[type=text], textarea")].forEach((field, i) => field.replaceWith(element("code", {}, fields[i].value)));
  for (const part of copy.querySelectorAll("button, input, textarea, .save, .ring, .paths, .strip, progress")) {
    if (part.matches("button.plain, .rung")) part.replaceWith(element("span", {class: part.className}, ...part.childNodes));
    else part.remove();
  }
  for (const part of copy.querySelectorAll("[id]")) part.removeAttribute("id");
  return copy;
}
