// What is followed of every robot, whichever view is shown: how it stands, and whether it moves.
import {wish} from "./subscriptions.js";
import {state} from "./state.js";

export const stateKey = "Brain.calibration", playerKey = "Motion.player";
export const healthKey = "Motion.health"; // {battery: 0..1, charging, joint: the hottest, temperature [°C]}
export const running = phase => !["idle", "finished", "failed"].includes(phase);

export function followAll() {
  for (const [robot, {list, connected}] of state.robots) {
    wish("all " + robot, connected ? robot : null, [healthKey, stateKey, playerKey].filter(name => list.some(({key}) => key === name)));
  }
}
