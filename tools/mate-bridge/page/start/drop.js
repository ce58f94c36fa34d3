// Files that are dropped on the page or chosen: they are sent to the bridge, which opens them.
import {at, button, element} from "naocal/lib/dom.js";
import {on, sendBytes} from "../core/connection.js";
import {act, notice, state} from "../core/state.js";

/** @typedef {{name: string, file: File}} Dropped */

const part = 512 << 10; // [bytes] of a message; the bridge takes 1 MiB
let number = 0;
/** @type {null | {number: number, done: number, all: number, told: (() => void) | null, failed: boolean}} */
let upload = null;
/** @type {() => void} */
let changed = () => {};

export const onUpload = listener => { changed = listener; };

/** Progress of the present upload, 0 to 1; null: there is none. */
export const uploadProgress = () => upload && (upload.all ? upload.done / upload.all : 0);

on("uploaded", message => {
  if (!upload || message.number !== upload.number) return;
  upload.done = message.bytes;
  upload.told?.();
});
/** Gives the present upload up: the bridge has refused it, or has gone. */
export function endUpload() {
  if (!upload) return;
  upload.failed = true;
  upload.told?.();
}
on("refused", message => { if (upload && message.number === upload.number) endUpload(); });

/** Waits for the bridge's answer to what was sent. @param {boolean} sent */
async function answered(sent) {
  if (!sent) return false;
  await new Promise(resolve => { if (upload) upload.told = () => resolve(null); });
  changed();
  return Boolean(upload && !upload.failed);
}

/** The last part of a path. @param {string} path */
const lastOf = path => path.split("/").filter(Boolean).at(-1) ?? "";

/** The ending of a file's name, ".json"; "" without one. @param {string} path */
const endingOf = path => /[^.].*?(\.[^.]*)$/.exec(lastOf(path))?.[1].toLowerCase() ?? "";

/** What a file holds; null if it is no JSON: the bridge says what is wrong with it. @param {File} file */
const jsonOf = async file => { try { return JSON.parse(await file.text()); } catch { return null; } };

/** Puts a captures.json and pictures that were dropped without their folder into one: that of the result beside them. @param {Dropped[]} files */
async function placed(files) {
  const set = files.find(({name}) => name === "captures.json");
  if (!set) return files;
  const isDocument = name => /^[^/]+\.json$/i.test(name) && name !== "captures.json", document = files.find(({name}) => isDocument(name));
  const captures = (await jsonOf(set.file))?.captures, sets = document && (await jsonOf(document.file))?.inputs?.sets;
  /** @type {Map<string, string>} */
  const images = new Map();
  if (Array.isArray(captures)) for (const one of captures) if (typeof one?.image === "string") images.set(lastOf(one.image), one.image);
  const folder = Array.isArray(sets) && typeof sets[0] === "string" && lastOf(sets[0]) || "captures";
  return files.map(({name, file}) => isDocument(name) ? {name, file} : {name: folder + "/" + (name.includes("/") ? name : images.get(name) ?? name), file});
}

/** Sends files to the bridge. @param {Dropped[]} given */
export async function openFiles(given) {
  if (upload) return notice("Files are being read: wait until they are open.");
  const limits = state.start?.drop;
  if (!limits) return notice("The bridge is not connected: nothing was opened. The panel keeps trying.", "bridge");
  const endings = given.some(({name}) => lastOf(name) === "captures.json") ? limits.endingsOfSet : limits.endings;
  const isTaken = name => endings.includes(endingOf(name)) && !name.endsWith(limits.endingOfTruth);
  const files = await placed(given.filter(({name}) => isTaken(name))), all = files.reduce((sum, {file}) => sum + file.size, 0);
  if (!files.length) return notice("Nothing was opened: expected " + limits.expected + ".");
  if (files.length > limits.mostFiles || all > limits.mostBytes) {
    return notice("Nothing was opened: these are " + files.length + " files of " + Math.round(all / 1e6) + " MB, more than the page sends. Type the path of the folder instead.");
  }
  upload = {number: ++number, done: 0, all, told: null, failed: false};
  changed();
  try {
    let goes = await answered(act({do: "upload", number, files: files.map(({name, file}) => ({name, bytes: file.size}))}));
    let waiting = /** @type {Blob[]} */ (files.map(({file}) => file));
    while (goes && waiting.length) {
      const {bytes, rest} = nextPart(waiting);
      waiting = rest;
      if (bytes.size) goes = await answered(sendBytes({do: "uploadPart", number}, await bytes.arrayBuffer()));
    }
  } catch (error) {
    notice("The files could not be read: " + (error instanceof Error ? error.message : error));
  } finally {
    upload = null;
    changed();
  }
}

/** The next bytes of the files, and what is left. @param {Blob[]} files */
function nextPart(files) {
  const bytes = [], rest = [...files];
  for (let room = part; room > 0 && rest.length;) {
    const now = rest[0].slice(0, room);
    bytes.push(now);
    room -= now.size;
    if (now.size === rest[0].size) rest.shift();
    else rest[0] = rest[0].slice(now.size);
  }
  return {bytes: new Blob(bytes), rest};
}

// What was dropped: files and the files in folders.

/** @param {FileSystemEntry} entry @param {string} above @returns {Promise<Dropped[]>} */
async function filesOf(entry, above) {
  const name = above + entry.name;
  if (entry.isFile) return [{name, file: await new Promise((resolve, reject) => /** @type {FileSystemFileEntry} */ (entry).file(resolve, reject))}];
  const reader = /** @type {FileSystemDirectoryEntry} */ (entry).createReader(), files = [];
  for (;;) { // a reader gives at most a hundred entries at once
    /** @type {FileSystemEntry[]} */
    const some = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
    if (!some.length) return files;
    for (const one of some) files.push(...await filesOf(one, name + "/"));
    if (state.start && files.length > state.start.drop.mostFiles) return files;
  }
}

/** @param {DataTransferItem[]} items */
async function openItems(items) {
  const given = items.map(item => ({entry: item.webkitGetAsEntry(), file: item.getAsFile()})); // before the event ends
  try {
    await openFiles((await Promise.all(given.map(async ({entry, file}) => entry ? filesOf(entry, "") : file ? [{name: file.name, file}] : []))).flat());
  } catch (error) {
    notice("What was dropped could not be read: " + (error instanceof Error ? error.message : error));
  }
}

/** Opens the files of an input; in a chosen folder, names begin with the folder's. @param {HTMLInputElement} input */
const openChosen = input => openFiles([...(input.files ?? [])].map(file => ({name: file.webkitRelativePath || file.name, file})));

/** Buttons that choose a folder or files, with their inputs. @param {boolean} isBusy */
export const fileChoosers = isBusy => [true, false].flatMap(isFolder => {
  const words = isFolder ? "Choose a folder …" : "Choose files …";
  const input = element("input", {type: "file", multiple: true, hidden: true, "data-chooses": isFolder ? "folder" : "files", "aria-label": words, onchange: () => openChosen(input),
    ...(isFolder ? {webkitdirectory: true} : {accept: state.start?.drop.endings.join(",") ?? null})});
  return [button(words, () => input.click(), {disabled: isBusy}), input];
});

const hasFiles = event => event.dataTransfer?.types.includes("Files");
let within = 0; // entered elements less left ones

/** Takes files that are dropped anywhere on the page. */
export function takeDrops() {
  const shade = element("div", {id: "drop", hidden: true}, "Drop a capture set, a recording, a result with its captures, or a table with its robot's URDF");
  document.body.append(shade);
  const show = shown => { within = shown ? within : 0; at("drop").hidden = !shown; };
  document.addEventListener("dragenter", event => { if (hasFiles(event)) { ++within; show(true); } });
  document.addEventListener("dragleave", event => { if (hasFiles(event) && --within <= 0) show(false); });
  document.addEventListener("dragover", event => { if (hasFiles(event)) event.preventDefault(); });
  document.addEventListener("drop", event => {
    show(false);
    if (!hasFiles(event) || !event.dataTransfer) return;
    event.preventDefault();
    openItems([...event.dataTransfer.items].filter(({kind}) => kind === "file"));
  });
}
