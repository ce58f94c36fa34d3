// Poses and captures by the names that people find them under.

export function takenNames({poses, pictures}) {
  const severalSets = new Set(poses.map(({set}) => set)).size > 1;
  const poseName = pose => (severalSets ? poses[pose].set + ", " : "") + "pose " + poses[pose].name;
  return {
    poseName,
    // "pose P05\ncaptures 12 (top), 13 (bottom)"
    poseTip: pose => poseName(pose) + "\ncaptures " + poses[pose].pictures.map(picture =>
      pictures[picture].capture + " (" + pictures[picture].camera + ")").join(", "),
    // "capture 12, pose P05"
    captureName: picture => "capture " + pictures[picture].capture + ", " + poseName(pictures[picture].pose),
  };
}
