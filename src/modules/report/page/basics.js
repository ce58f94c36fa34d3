// What every page needs: its data, elements, notes beside the pointer, text to copy.

const at = id => document.getElementById(id);
const data = JSON.parse(at("data").textContent);

function element(tag, className, text) {
  const result = document.createElement(tag);
  if (className) result.className = className;
  if (text !== undefined) result.textContent = text;
  return result;
}

const lengthOf = ([x, y]) => Math.hypot(x, y);

// The note `text` beside the pointer while it is over `part`.
function tipOver(part, text) {
  for (const event of ["pointermove", "pointerdown"]) part.addEventListener(event, where => showTip(where, text));
  part.addEventListener("pointerleave", hideTip);
}

// Text to take along: a box that copies itself.
function copyBox(title, text) {
  const frame = element("div", "copy"), button = element("button", "", "copy");
  const box = element("textarea");
  box.readOnly = true;
  box.spellcheck = false;
  box.value = text;
  box.rows = text.split("\n").length;
  button.type = "button";
  button.addEventListener("click", () => {
    box.select();
    button.textContent = document.execCommand("copy") ? "copied" : "press Ctrl-C";
  });
  box.setAttribute("aria-label", title);
  const head = frame.appendChild(element("p", "", title));
  head.append(button);
  frame.append(box);
  return frame;
}

// The head of a page: the headline, a sentence, figures to remember, and what to beware of.
function showVerdict(sentence, warnings) {
  at("headline").textContent = document.title = data.headline;
  at("sentence").textContent = sentence;
  for (const {figure, sentence} of data.facts) {
    const fact = at("facts").appendChild(element("div"));
    fact.append(element("dt", "", figure), element("dd", "", sentence));
  }
  warnings.forEach(warning => at("warnings").append(element("li", "", warning)));
}
