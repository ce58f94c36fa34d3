// WebSocket connection to the bridge; reconnects automatically.

const listeners = new Map();
let socket, pause = 500;
/** @type {(connected: boolean) => void} */
let stateChanged = () => {};

// on("fit", message => ...); binary messages include their bytes: on("picture", (head, blob) => ...)
export function on(kind, listener) {
  if (!listeners.has(kind)) listeners.set(kind, []);
  listeners.get(kind).push(listener);
}

const dispatch = (message, more) => (listeners.get(message.kind) || []).forEach(listener => listener(message, more));

// Returns false if not connected; nothing was sent.
export function send(request) {
  if (!socket || socket.readyState !== WebSocket.OPEN) return false;
  socket.send(JSON.stringify(request));
  return true;
}

// Sends a request with bytes behind it.
export function sendBytes(request, bytes) {
  if (!socket || socket.readyState !== WebSocket.OPEN) return false;
  socket.send(new Blob([JSON.stringify(request) + "\n", bytes]));
  return true;
}

export function connect(changed) {
  stateChanged = changed;
  socket = new WebSocket(location.href.replace(/^http/, "ws").replace(/#.*$/, "") + "live");
  socket.binaryType = "arraybuffer";
  socket.onopen = () => { pause = 500; stateChanged(true); };
  socket.onmessage = ({data}) => typeof data === "string" ? dispatch(JSON.parse(data)) : received(new Uint8Array(data));
  socket.onclose = () => {
    stateChanged(false);
    setTimeout(() => connect(changed), pause);
    pause = Math.min(5000, 1.5 * pause);
  };
}

// A binary message: one line of JSON, then the file.
function received(bytes) {
  const end = bytes.indexOf(10);
  dispatch(JSON.parse(new TextDecoder().decode(bytes.subarray(0, end))), new Blob([bytes.subarray(end + 1)]));
}
