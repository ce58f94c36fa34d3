#include "writer/Drawn.hpp"
#include "writer/Drawing.hpp"

namespace blind {

SessionPlan drawnPlan(const Item& item, Chance& chance) {
  SessionPlan plan;
  plan.poses = item.poses;
  plan.boards = 3 + chance.below(2);
  plan.mainSide = chance.below(2);
  plan.bothSides = item.poses >= 12 && item.group != "absorbed" && chance.uniform() < 0.5;
  plan.rests = chance.uniform() < 0.15;
  plan.restands = chance.uniform() < 0.25;
  plan.warmAnyhow = item.kind == "idle temperature";
  plan.sortedByKnee = item.kind == "sorted poses";
  plan.sameTemperature = item.kind == "constant temperature";
  plan.speed = item.kind == "no motion" ? 0 : plan.speed;
  plan.noise = noiseRegime(item.noise);
  if (item.group == "jitter") {
    plan.repeats = item.kind == "rest" ? RepeatKind::rest : RepeatKind::reapproach;
    plan.restands = false;
  }
  if (item.pictures) {
    constexpr double foundCorners = 0.1; // what a good detector leaves [px]
    plan.noise.pixel = foundCorners;
  }
  return plan;
}

Robot drawnRobot(const Drawing& drawing, std::size_t boards, Chance& chance) {
  Robot robot;
  robot.drawing = &drawing;
  robot.offsets.resize(static_cast<Eigen::Index>(drawing.joints.size()));
  for (double& offset : robot.offsets) {
    offset = chance.within(6.5 * radiansPerDegree);
  }
  for (std::size_t i = 0; i < drawing.joints.size(); ++i) {
    if (!drawing.joints[i].drivenBy.empty()) {
      robot.offsets[static_cast<Eigen::Index>(i)] = robot.offsets[drawing.joint(drawing.joints[i].drivenBy)];
    }
  }
  for (Eigen::Vector3d& turns : robot.mountTurns) {
    for (double& turn : turns) {
      turn = chance.within(2 * radiansPerDegree);
    }
  }
  robot.flaws.joints.resize(drawing.joints.size());
  robot.flaws.boards.resize(boards);
  return robot;
}

Robot withoutFlaws(Robot robot) {
  Flaws none;
  none.joints.resize(robot.flaws.joints.size());
  none.boards.resize(robot.flaws.boards.size());
  robot.flaws = none;
  return robot;
}

NoiseRegime noiseRegime(const std::string& name) {
  NoiseRegime regime;
  regime.name = name;
  regime.heavyTails = name == "heavy tails";
  regime.foreshortened = name == "foreshortening";
  regime.pictureBias = name == "picture bias" ? 0.1 : 0;
  regime.quantised = name == "quantised" || name.starts_with("stiction");
  if (name.starts_with("stiction")) {
    regime.stiction = std::stod(name.substr(9)) * radiansPerDegree;
  }
  if (name.starts_with("jitter")) { // as real encoders show it: in whole steps
    regime.quantised = true;
    regime.jitter = std::stod(name.substr(7)) * radiansPerDegree;
  }
  return regime;
}

} // namespace blind
