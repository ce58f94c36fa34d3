// Whether captures are of a robot: by the ids of head and body that they carry.
import {make} from "./elements.js";
import {robots, nameOf} from "./robots.js";

const toldBy = (keys, names) => names.map(name => keys.find(({key}) => key === name)?.value).find(value => typeof value === "string" && value);

function stands(keys, part, id) {
  const own = toldBy(keys, ["NaoInfo." + part + "Id"]), called = toldBy(keys, ["NaoInfo." + part + "Name"]);
  if (!id) return "unknown";
  if (own) return own === id ? "its" : "another's";
  return called === id ? "its" : "unknown"; // who has no name in id_map.json is called by its id
}

// Sentences for whoever puts a result of these captures on that robot.
export function whoseCaptures({headId, bodyId}, robot) {
  const keys = robots.get(robot)?.keys.get("tuhhSDK.base") || [], name = nameOf(robot);
  const parts = [["head", headId], ["body", bodyId]], how = parts.map(([part, id]) => stands(keys, part, id));
  const of = "These captures are of " + parts.map(([part, id]) => part + " " + (id || "(not written down)")).join(" and ");
  const warning = words => make("p", {class: "bad"}, words);
  if (how.includes("another's")) {
    const others = parts.filter((_, i) => how[i] === "another's").map(([part]) => part).join(" and ");
    return warning(of + ", but " + name + " has another " + others + ": its joints and cameras differ from these. Take captures with " + name + " itself.");
  }
  if (how.includes("unknown")) {
    const called = parts.map(([part]) => part + " " + (toldBy(keys, ["NaoInfo." + part + "Id", "NaoInfo." + part + "Name"]) || "(not told)")).join(" and ");
    return warning(of + "; " + name + " says of itself: " + called + ". Make sure that it is the same robot: another one's joints and cameras differ.");
  }
  return of + ": those of " + name + ".";
}
