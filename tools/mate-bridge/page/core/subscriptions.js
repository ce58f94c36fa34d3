// Live subscriptions: a key is subscribed while a view shows it.
import {on, send} from "./connection.js";

const wanted = new Map(); // by view: {robot, keys}
let subscribed = new Map();

export function want(view, robot, keys) {
  if (robot && keys.length) wanted.set(view, {robot, keys});
  else wanted.delete(view);
  follow();
}

function follow() {
  const keys = new Map();
  for (const {robot, keys: own} of wanted.values()) for (const key of own) keys.set(robot + "\n" + key, {robot, key});
  for (const [id, one] of subscribed) if (!keys.has(id)) send({do: "unsubscribe", ...one});
  for (const [id, one] of keys) if (!subscribed.has(id)) send({do: "subscribe", ...one});
  subscribed = keys;
}

// Renews subscriptions: a restarted bridge has none and lists its robots first.
on("robot", ({connected}) => { if (connected) follow(); });
const forget = isGone => {
  for (const [view, {robot}] of wanted) if (isGone(robot)) wanted.delete(view);
  for (const [id, {robot}] of subscribed) if (isGone(robot)) subscribed.delete(id);
};
on("robotGone", ({robot}) => forget(one => one === robot));
on("hello", ({robots}) => {
  subscribed = new Map();
  forget(one => !robots.includes(one));
});
