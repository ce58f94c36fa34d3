// Connection status in the header, and the notice after losing the bridge.
import {at} from "naocal/lib/dom.js";
import {endNotice, notice, state} from "./core/state.js";
import {refreshStop} from "./robots/controls.js";
import {bridgeLost} from "./robots/robots.js";

let wasConnected = false, lostAt = null, saidSo = false;

// `gone`: called once per loss of connection.
export function showLink(connected, gone) {
  at("link").textContent = connected ? "bridge" : "bridge away";
  at("link").className = connected ? "" : "gone";
  at("link").title = connected ? "The panel is connected to mate-bridge." : "mate-bridge does not answer; the panel keeps trying. It shows the last known state.";
  lostAt = connected ? null : lostAt ?? Date.now();
  if (connected) endNotice("bridge");
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

// A restarted bridge has a new token and usually another port, so this page cannot reach it.
async function otherBridge() {
  const answer = await fetch(location.pathname).catch(() => null);
  if (saidSo || (answer && answer.ok)) return;
  saidSo = true;
  notice(answer ? "mate-bridge was restarted at another address: open the address that it prints. This page shows the last known state."
    : "mate-bridge has been away for some seconds. If it was restarted, open the address that it prints. This page shows the last known state.", "bridge");
}
