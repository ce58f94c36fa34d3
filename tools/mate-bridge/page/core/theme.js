// Light or dark theme: the system's or the selected one.
import {at} from "naocal/lib/dom.js";
import {readColours} from "naocal/lib/figure.js";

// A cookie, because cookies are shared by all ports of a host and the next bridge uses another port.
function setTheme(theme) {
  document.documentElement.dataset.theme = theme;
  document.cookie = "naocal-theme=" + theme + "; path=/; max-age=31536000; samesite=strict";
  readColours();
}
const [, remembered] = document.cookie.match(/naocal-theme=(light|dark)/) || [];
if (remembered) document.documentElement.dataset.theme = remembered;
at("theme").addEventListener("click", () => {
  const dark = document.documentElement.dataset.theme ? document.documentElement.dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
  setTheme(dark ? "light" : "dark");
});
at("theme").title = "light or dark";
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", readColours);
readColours();
