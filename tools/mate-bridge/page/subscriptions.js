// What the views want to be told live: each key is subscribed to while some view shows it.
import {send, on} from "./connection.js";

const wishes = new Map(); // by view: {robot, keys}
let subscribed = new Map();

export function wish(view, robot, keys) {
  if (robot && keys.length) wishes.set(view, {robot, keys});
  else wishes.delete(view);
  follow();
}

function follow() {
  const wanted = new Map();
  for (const {robot, keys} of wishes.values()) for (const key of keys) wanted.set(robot + "\n" + key, {robot, key});
  for (const [id, one] of subscribed) if (!wanted.has(id)) send({do: "unsubscribe", ...one});
  for (const [id, one] of wanted) if (!subscribed.has(id)) send({do: "subscribe", ...one});
  subscribed = wanted;
}

// A bridge that came back knows nothing; the robots that it has are told right after.
on("robot", ({connected}) => { if (connected) follow(); });
const forget = isGone => {
  for (const [view, {robot}] of wishes) if (isGone(robot)) wishes.delete(view);
  for (const [id, {robot}] of subscribed) if (isGone(robot)) subscribed.delete(id);
};
on("robotGone", ({robot}) => forget(one => one === robot));
on("hello", ({robots}) => {
  subscribed = new Map();
  forget(one => !robots.includes(one));
});
