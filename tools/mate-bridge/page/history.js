// HULKs' order, in which robots send one number per joint.
const arm = side => ["ShoulderPitch", "ShoulderRoll", "ElbowYaw", "ElbowRoll", "WristYaw", "Hand"].map(name => side + name);
const leg = side => ["HipYawPitch", "HipRoll", "HipPitch", "KneePitch", "AnklePitch", "AnkleRoll"].map(name => side + name);
const joints = ["HeadYaw", "HeadPitch", ...arm("L"), ...leg("L"), ...leg("R"), ...arm("R")];

// What one key had over time: its numbers by name, as many entries as `most`.
export class History {
  constructor(most) {
    this.most = most;
    this.times = [];
    this.series = new Map(); // by name: one number or null per time
    this.last = undefined;
  }

  add(time, value) {
    this.last = value;
    const found = new Map();
    numbersIn(value, "", found);
    if (this.times.length && time <= this.times[this.times.length - 1]) {
      if (time < this.times[this.times.length - 1] - 1) { this.times = []; this.series.clear(); } // the robot was started anew
      else return;
    }
    this.times.push(time);
    for (const name of found.keys()) if (!this.series.has(name)) this.series.set(name, new Array(this.times.length - 1).fill(null));
    for (const [name, values] of this.series) values.push(found.has(name) ? found.get(name) : null);
    if (this.times.length > 1.2 * this.most) {
      this.times = this.times.slice(-this.most);
      for (const [name, values] of this.series) this.series.set(name, values.slice(-this.most));
    }
  }

  names() { return [...this.series.keys()]; }

  // The last seconds, as uPlot takes them; of many entries every second, third ... one.
  since(seconds, names) {
    const begin = this.times[this.times.length - 1] - seconds, most = 600;
    let first = 0;
    while (this.times[first] < begin) ++first;
    const every = Math.max(1, Math.ceil((this.times.length - first) / most));
    const part = list => list.filter((_, i) => i >= first && (i - first) % every === 0);
    return [part(this.times), ...names.map(name => part(this.series.get(name)))];
  }

  // All of it as a table, names first.
  rows() {
    return [["time [s]", ...this.names().map(name => name || "value")], ...this.times.map((time, i) => [time, ...[...this.series.values()].map(values => values[i])])];
  }

  // The last value for people, shortened.
  text() {
    const text = JSON.stringify(this.last, (key, value) => typeof value === "number" && !Number.isInteger(value) ? Number(value.toPrecision(6)) : value);
    return text === undefined ? "" : text.length > 400 ? text.slice(0, 400) + " …" : text;
  }
}

// Every number in a value by its way through it: "[2]", ".x"; truths count as 0 and 1.
function numbersIn(value, name, found) {
  if (found.size >= 64) return;
  if (typeof value === "number") found.set(name, value);
  else if (typeof value === "boolean") found.set(name, Number(value));
  else if (Array.isArray(value)) value.forEach((one, i) => numbersIn(one, name + (value.length === joints.length ? (name ? "." : "") + joints[i] : "[" + i + "]"), found));
  else if (value && typeof value === "object") for (const key of Object.keys(value)) numbersIn(value[key], name ? name + "." + key : key, found);
}
