#include "geometry/Angles.hpp"
#include "model/DrawingPlaces.hpp"

namespace naocal {

namespace {

AngleRange angleRange(const JsonPlace& place, double lowerDegrees, double upperDegrees) {
  if (lowerDegrees > upperDegrees) {
    place.refuse("a lower limit not above the upper one");
  }
  return {radians(lowerDegrees), radians(upperDegrees)};
}

CoupledLimits coupledLimits(const JsonPlace& place, const Robot& robot, std::size_t joint) {
  allowOnly(place, {"on", "rowsDegrees"});
  CoupledLimits coupled;
  coupled.onJoint = jointAt(place.at("on"), robot);
  if (coupled.onJoint == joint) {
    place.at("on").refuse("another joint");
  }
  for (const JsonPlace& row : place.at("rowsDegrees").elements()) {
    const auto numbers = row.numbers(3, degreeRange, "angle, lower, upper");
    if (!coupled.angles.empty() && radians(numbers[0]) <= coupled.angles.back()) {
      row.refuse("an angle above that of the row before");
    }
    coupled.angles.push_back(radians(numbers[0]));
    coupled.ranges.push_back(angleRange(row, numbers[1], numbers[2]));
  }
  if (coupled.angles.empty()) {
    place.at("rowsDegrees").refuse("at least one row");
  }
  return coupled;
}

void readJoint(const JsonPlace& place, Robot& robot, std::size_t index) {
  allowOnly(place,
            {"axis", "limitsDegrees", "maxSpeedDegreesPerSecond", "restingDegrees", "drivenBy", "coupledLimits"});
  Joint& joint = robot.joints[index];
  joint.axis = vector3(place.at("axis"), directionRange);
  if (joint.axis.norm() == 0) {
    place.at("axis").refuse("a direction", "[0, 0, 0]");
  }
  joint.axis.normalize();
  const JsonPlace limits = place.at("limitsDegrees");
  const auto bounds = limits.numbers(2, degreeRange, "lower, upper");
  joint.limits = angleRange(limits, bounds[0], bounds[1]);
  joint.maxSpeed = radians(place.at("maxSpeedDegreesPerSecond").number({0.1, 10000, "degrees per second"}));
  if (const auto resting = place.find("restingDegrees")) {
    joint.resting = radians(resting->number(degreeRange));
  }
  const auto motor = place.find("drivenBy");
  joint.motor = motor ? jointAt(*motor, robot) : index;
  if (const auto coupled = place.find("coupledLimits")) {
    joint.coupled = coupledLimits(*coupled, robot, index);
  }
}

} // namespace

void readJoints(const JsonPlace& drawing, Robot& robot) {
  for (const auto& [name, place] : section(drawing, "joints")) {
    if (!robot.jointIndex(name)) {
      place.refuse("only joints of the tree", '"' + name + '"');
    }
  }
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    readJoint(drawing.at("joints").at(robot.joints[joint].name), robot, joint);
  }
  for (const Joint& joint : robot.joints) {
    if (robot.joints[joint.motor].motor != joint.motor) {
      drawing.at("joints").at(joint.name).at("drivenBy").refuse("a joint with a motor of its own");
    }
  }
}

} // namespace naocal
