// Poses and captures by the names that people find them under.

const severalSets = new Set(data.poses.map(pose => pose.set)).size > 1;
const poseName = pose => (severalSets ? data.poses[pose].set + ", " : "") + "pose " + data.poses[pose].name;

// "pose P05\ncaptures 12 (top), 13 (bottom)"
const poseTip = pose => poseName(pose) + "\ncaptures " + data.poses[pose].pictures.map(picture =>
  data.pictures[picture].capture + " (" + data.pictures[picture].camera + ")").join(", ");

// "capture 12, pose P05"
const captureName = picture => "capture " + data.pictures[picture].capture + ", " + poseName(data.pictures[picture].pose);
