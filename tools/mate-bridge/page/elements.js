// Elements, and files for the person.

// make("p", {class: "soft", onclick}, "text", child): properties that are functions are listeners.
export function make(tag, properties = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (typeof value === "function") made.addEventListener(name.slice(2), value);
    else if (name === "class") made.className = value;
    else if (name in made && typeof value !== "string") made[name] = value;
    else if (value !== undefined && value !== null) made.setAttribute(name, value);
  }
  made.append(...children.filter(child => child !== null && child !== undefined));
  return made;
}

export const button = (text, onclick, properties = {}) => make("button", {type: "button", onclick, ...properties}, text);

// A choice: [{value, text, group?}]; with an id a view that is drawn anew finds it again.
export function choice(label, options, chosen, changed, id) {
  const select = make("select", {...(id && {id}), onchange: () => changed(select.value)});
  const groups = new Map();
  for (const {value, text, group} of options) {
    const option = make("option", {value}, text);
    option.selected = value === chosen;
    if (!group) select.append(option);
    else {
      if (!groups.has(group)) groups.set(group, select.appendChild(make("optgroup", {label: group})));
      groups.get(group).append(option);
    }
  }
  return make("label", {}, label + " ", select);
}

// Draws anew, without taking the focus and the place in its text from an element with an id that is there again.
export function keepingFocus(parent, draw) {
  const before = document.activeElement, id = parent.contains(before) && before.id;
  const {selectionStart, selectionEnd} = before || {};
  draw();
  const after = id && document.getElementById(id);
  if (!after || after === document.activeElement) return;
  after.focus({preventScroll: true});
  if (typeof selectionStart === "number") after.setSelectionRange(selectionStart, selectionEnd);
}

export const renew = (parent, ...children) =>
  keepingFocus(parent, () => parent.replaceChildren(...children.filter(child => child !== null && child !== undefined)));

// A question that a person answers before anything happens; `yes`: words, or a button of its own.
export const confirmation = (words, yes, action, no) => make("div", {class: "confirm", role: "group", "aria-label": "confirm"}, ...[words].flat().map(line => typeof line === "string" ? make("p", {}, line) : line),
  make("p", {class: "controls"}, typeof yes === "string" ? button(yes, action, {class: "main"}) : yes, button("Not now", no)));

export const empty = (title, ...words) => make("div", {class: "empty"}, make("h2", {}, title), make("p", {}, ...words));

// What a browser saves as a file.
export function download(name, content, type) {
  const url = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], {type}));
  make("a", {href: url, download: name}).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

export const csv = rows => rows.map(row => row.map(cell => {
  const text = cell === null || cell === undefined ? "" : String(cell);
  return /[",\n]/.test(text) ? '"' + text.replaceAll('"', '""') + '"' : text;
}).join(",")).join("\n") + "\n";

// A table with a button that saves it.
export const csvTable = (table, name) => make("div", {class: "tabled"}, button("CSV", () => download(name + ".csv", csv(
  [...table.rows].map(row => [...row.cells].map(cell => cell.querySelector("input")?.value ?? cell.innerText.replaceAll("−", "-")))), "text/csv"),
  {class: "small", "aria-label": "save as CSV: " + name}), table);
