// The page's canvases.

readColours();
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", readColours);

// A canvas in `parent` (shared/figure.js); returns what redraws it.
function canvasFigure(parent, height, draw, label) {
  return parent.appendChild(figure({height, draw, label})).redraw;
}
