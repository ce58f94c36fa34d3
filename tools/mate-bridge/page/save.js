// A robot's writing of what was set on it into its own files: always asked for first, and never answered.
import {confirmation} from "./elements.js";
import {act, say} from "./state.js";
import {nameOf} from "./robots.js";

// `more`: what else to say; `leave`: takes the question away; `asked`: called once the robot was asked.
export const savingOn = (robot, more, leave, asked = () => {}) =>
  confirmation(["Write everything that was set on " + nameOf(robot) + " into its own configuration files?", ...more], "Save on " + nameOf(robot), () => {
    if (act({do: "save", robot})) {
      asked();
      say("Asked " + nameOf(robot) + " to save. (HULKs' protocol has no answer to this.)");
    }
    leave();
  }, leave);
