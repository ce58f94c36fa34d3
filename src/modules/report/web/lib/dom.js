// DOM elements, tooltips and file downloads.

/**
 * element("p", {class: "soft", onclick}, "text", child): function properties become event listeners;
 * null and undefined children are skipped.
 * @template {keyof HTMLElementTagNameMap} T
 * @param {T} tag
 * @param {Record<string, any>} [properties]
 * @param {...(Node | string | number | null | undefined)} children
 * @returns {HTMLElementTagNameMap[T]}
 */
export function element(tag, properties = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (typeof value === "function") made.addEventListener(name.slice(2), value);
    else if (name === "class") made.className = value;
    else if (name in made && typeof value !== "string") Object.assign(made, {[name]: value});
    else if (value !== undefined && value !== null) made.setAttribute(name, value);
  }
  made.append(...present(children));
  return made;
}

/** @param {(Node | string | number | null | undefined)[]} children */
const present = children => children.filter(child => child !== null && child !== undefined).map(child => typeof child === "number" ? String(child) : child);

/** Shorthand for getElementById. @param {string} id @returns {any} */
export const at = id => document.getElementById(id);

/** @param {HTMLCanvasElement} canvas */
export const contextOf = canvas => /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));

/** @param {string} text */
export const bold = text => element("b", {}, text);

/** A legend key: the mark as it is drawn in figures. @param {string} name */
export const key = name => element("span", {class: "key " + name});

/** @param {string} text @param {(event: any) => void} onclick @param {Record<string, any>} [properties] */
export const button = (text, onclick, properties = {}) => element("button", {type: "button", onclick, ...properties}, text);

/** @typedef {{value: string, text: string, group?: string}} Option */

/**
 * A labelled select; with an id, redrawing restores its focus.
 * @param {string} label
 * @param {Option[]} options
 * @param {string} chosen
 * @param {(value: string) => void} changed
 * @param {string} [id]
 */
export function choice(label, options, chosen, changed, id) {
  const select = element("select", {...(id && {id}), onchange: () => changed(select.value)});
  const groups = new Map();
  for (const {value, text, group} of options) {
    const option = element("option", {value}, text);
    option.selected = value === chosen;
    if (!group) select.append(option);
    else {
      if (!groups.has(group)) groups.set(group, select.appendChild(element("optgroup", {label: group})));
      groups.get(group).append(option);
    }
  }
  return element("label", {}, label + " ", select);
}

/** Last selected value, by id of the select. @type {Map<string, string>} */
const chosenLast = new Map();

/**
 * A select with the selected content below it; only the content if there is one option. Recreated with the same id, it
 * restores the last selection.
 * @param {string} id
 * @param {string} label
 * @param {Option[]} options
 * @param {(value: string) => Node} show
 * @param {string} [first] initial value
 */
export function choosing(id, label, options, show, first = options[0].value) {
  const last = chosenLast.get(id), begin = options.some(({value}) => value === last) ? /** @type {string} */ (last) : first;
  const shown = element("div", {}, show(begin));
  if (options.length < 2) return shown;
  return element("div", {}, element("p", {class: "controls"}, choice(label, options, begin, value => {
    chosenLast.set(id, value);
    shown.replaceChildren(show(value));
  }, id)), shown);
}

/**
 * Redraws; focus and text selection move to the new element with the same id.
 * @param {Element} parent
 * @param {() => void} draw
 */
export function keepingFocus(parent, draw) {
  const before = /** @type {any} */ (document.activeElement), id = parent.contains(before) && before.id;
  const {selectionStart, selectionEnd} = before || {};
  draw();
  const after = id && at(id);
  if (!after || after === document.activeElement) return;
  after.focus({preventScroll: true});
  if (typeof selectionStart === "number") after.setSelectionRange(selectionStart, selectionEnd);
}

/** @param {Element} parent @param {...(Node | string | null | undefined)} children */
export const renew = (parent, ...children) => keepingFocus(parent, () => parent.replaceChildren(...present(children)));

let opener = ""; // label of the button that opened the last dialog

/**
 * A dialog that opens and takes the focus as soon as it is in the page. It is not modal, for a Stop button outside must
 * stay in reach: a shade covers what is below `--above`, Tab stays within, Escape calls `leave`. When it goes, the focus
 * returns to the button that opened it.
 * @param {Record<string, any>} properties
 * @param {(() => void) | null} leave null: it can only be answered
 * @param {...(Node | string)} children
 */
export function question(properties, leave, ...children) {
  const dialog = element("dialog", {...properties, onkeydown: (/** @type {KeyboardEvent} */ event) => {
    const parts = /** @type {HTMLElement[]} */ ([...dialog.querySelectorAll("button:not(:disabled), input:not([hidden]), select, textarea, summary")].filter(part => part.checkVisibility())), place = parts.indexOf(/** @type {any} */ (document.activeElement));
    if (event.key === "Escape" && leave) leave();
    else if (event.key === "Tab" && parts.length) parts[(place + (event.shiftKey ? parts.length - 1 : 1)) % parts.length].focus();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }}, ...children);
  const before = document.activeElement;
  if (!before?.closest("dialog")) opener = before?.textContent ?? "";
  queueMicrotask(() => {
    if (!dialog.isConnected) return;
    dialog.show();
    new MutationObserver((_, observer) => {
      if (dialog.isConnected) return;
      observer.disconnect();
      if (document.activeElement === document.body && !document.querySelector("dialog[open]")) {
        [...document.querySelectorAll("button")].find(one => one.textContent === opener)?.focus({preventScroll: true});
      }
    }).observe(document.body, {childList: true, subtree: true});
  });
  return dialog;
}

/**
 * A dialog that asks for a confirmation, with the focus on "Not now"; `yes`: label of the confirming button, or the
 * button itself.
 * @param {string | Node | (string | Node)[]} words
 * @param {string | Node} yes
 * @param {(() => void) | null} action
 * @param {() => void} no
 */
export const confirmation = (words, yes, action, no) => question({class: "confirm", "aria-label": "confirm"}, no,
  ...[words].flat().map(line => typeof line === "string" ? element("p", {}, line) : line),
  element("p", {class: "controls"}, typeof yes === "string" ? button(yes, /** @type {any} */ (action), {class: "main"}) : yes, button("Not now", no, {autofocus: true})));

/** @param {string} title @param {...(string | Node)} words */
export const empty = (title, ...words) => element("div", {class: "empty"}, element("h2", {}, title), element("p", {}, ...words));

/** @param {{clientX: number, clientY: number}} event @param {string} text */
export function showTip(event, text) {
  const tip = at("tip");
  tip.hidden = false;
  tip.textContent = text;
  tip.style.left = Math.max(4, Math.min(event.clientX + 14, innerWidth - tip.offsetWidth - 8)) + "px";
  tip.style.top = (event.clientY + 18 + tip.offsetHeight < innerHeight ? event.clientY + 18
                                                                     : event.clientY - tip.offsetHeight - 12) + "px";
}
export const hideTip = () => { at("tip").hidden = true; };

/** Shows a tooltip while the pointer is over `part`. @template {HTMLElement} E @param {E} part @param {string} text */
export function tipOver(part, text) {
  part.addEventListener("pointermove", where => showTip(where, text));
  part.addEventListener("pointerdown", where => showTip(where, text));
  part.addEventListener("pointerleave", hideTip);
  return part;
}

/** Read-only text box whose content can be copied. @param {string} title @param {string} text */
export function copyBox(title, text) {
  const box = element("textarea", {readOnly: true, spellcheck: false, rows: text.split("\n").length, "aria-label": title});
  box.value = text;
  const copy = button("copy", () => {
    box.select();
    copy.textContent = document.execCommand("copy") ? "copied" : "press Ctrl-C";
  });
  return element("div", {class: "copy"}, element("p", {}, title, copy), box);
}

/** Offers content as a file download. @param {string} name @param {Blob | string} content @param {string} [type] */
export function download(name, content, type) {
  const url = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], {type}));
  element("a", {href: url, download: name}).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

const isMeasure = /** @param {string} text */ text => /^[+-]?[\d.]+(e[+-]?\d+)?( ± [\d.]+(e[+-]?\d+)?)?( ?[°\w/%²]*)?$/i.test(text);

/** Comma-separated values. An apostrophe before a text that spreadsheets would take for a formula makes it a text.
 * @param {any[][]} rows */
export const csv = rows => rows.map(row => row.map(cell => {
  const given = cell === null || cell === undefined ? "" : String(cell);
  const text = /^[\s]*[=+\-@]|^[\t\r]/.test(given) && !isMeasure(given) ? "'" + given : given;
  return /[",\r\n]/.test(text) ? '"' + text.replaceAll('"', '""') + '"' : text;
}).join(",")).join("\n") + "\n";

/** A table with a button that saves it as CSV. @param {HTMLTableElement} table @param {string} name */
export const csvTable = (table, name) => element("div", {class: "tabled"}, button("CSV", () => download(name + ".csv", csv(
  [...table.rows].map(row => [...row.cells].map(cell => cell.querySelector("input")?.value ?? cell.innerText.replaceAll("−", "-")))), "text/csv"),
  {class: "small", "aria-label": "save as CSV: " + name}), table);
