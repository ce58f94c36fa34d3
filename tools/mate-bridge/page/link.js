// The connection to the bridge in the header, and what is said when it goes.
import {state, notice} from "./state.js";
import {bridgeLost} from "./robots.js";
import {refreshStop} from "./stop.js";

const at = id => document.getElementById(id);
let wasConnected = false, lostAt = null, saidSo = false;

// `gone`: called once when it has gone.
export function showLink(connected, gone) {
  at("link").textContent = connected ? "bridge" : "bridge away";
  at("link").className = connected ? "" : "gone";
  at("link").title = connected ? "The panel is connected to mate-bridge." : "mate-bridge does not answer; it is tried again by itself. What is shown is the last that it told.";
  lostAt = connected ? null : lostAt ?? Date.now();
  if (lostAt && Date.now() - lostAt > 5000) otherBridge();
  if (!connected) {
    state.work = null;
    at("work").textContent = "";
    at("work").classList.remove("busy");
    if (wasConnected) {
      bridgeLost();
      refreshStop();
      gone();
    }
  }
  wasConnected = connected;
}

// A bridge that was started anew has another token, and mostly another port: this page cannot reach it any more.
async function otherBridge() {
  const answer = await fetch(location.pathname).catch(() => null);
  if (saidSo || (answer && answer.ok)) return;
  saidSo = true;
  notice(answer ? "mate-bridge was started anew and has another address: open the one that it prints. What stands here is the last that was told."
    : "mate-bridge has been away for some seconds. If it was started anew, open the address that it prints; what stands here is the last that was told.");
}
