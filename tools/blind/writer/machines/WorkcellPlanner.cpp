#include "writer/machines/WorkcellPlanner.hpp"

#include "writer/machines/Reaching.hpp"

#include <Eigen/QR>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <stdexcept>

namespace blind {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr double pi = std::numbers::pi;

Vector3d drawVector(double range, RandomStream& chance) {
  return {chance.uniformWithin(range), chance.uniformWithin(range), chance.uniformWithin(range)};
}

/// A frame whose z axis points that way, turned anyhow about it.
Eigen::Matrix3d lookingAlong(const Vector3d& direction, RandomStream& chance) {
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), direction);
  return turn.toRotationMatrix() * rotationAbout(Vector3d::UnitZ(), chance.uniformWithin(pi));
}

/// A direction within a cone about z.
Vector3d withinCone(double opening, RandomStream& chance) {
  const double tilt = opening * std::sqrt(chance.uniform()), around = chance.uniformWithin(pi);
  return {std::sin(tilt) * std::cos(around), std::sin(tilt) * std::sin(around), std::cos(tilt)};
}

std::vector<Vector3d> boardPoints(double pitch) {
  constexpr int columns = 7, rows = 5;
  std::vector<Vector3d> points;
  for (int i = 0; i < columns * rows; ++i) {
    points.emplace_back(pitch * (i % columns - (columns - 1) / 2), pitch * (i / columns - (rows - 1) / 2), 0);
  }
  return points;
}

/// Distance from the base to the hand of the stretched machine [m].
double reachOf(const Machine& machine) {
  const MachineFlaws none{machine.joints.size()};
  const MachineBody body{machine, none};
  const VectorXd zero = VectorXd::Zero(static_cast<Index>(machine.joints.size()));
  return body.worldFromAttached(body.settled(zero), 0).shift.norm();
}

class Stager {
public:
  Stager(const Workcell& cell, RandomStream& chance)
      : cell_{cell}, chance_{chance}, sound_{cell.machine->joints.size()},
        body_{*cell.machine, sound_, cell.worldFromSole}, reach_{reachOf(*cell.machine)} {}
  Stager(const Stager&) = delete;

  /// True angles of a pose, and what is seen there.
  std::pair<VectorXd, std::vector<int>> drawPose();

private:
  std::optional<VectorXd> drawGoal(std::vector<int>& seen);
  std::vector<int> pointsInView(const VectorXd& angles) const;
  bool aboveFloor(const MachineBody::Posture& posture) const;

  const Workcell& cell_;
  RandomStream& chance_;
  MachineFlaws sound_;
  MachineBody body_;
  double reach_;
};

bool Stager::aboveFloor(const MachineBody::Posture& posture) const {
  if (cell_.machine->sole) {
    return true;
  }
  for (std::size_t i = 2; i < posture.links.size(); ++i) {
    if (posture.links[i].shift.z() < 0.05) {
      return false;
    }
  }
  return true;
}

std::vector<int> Stager::pointsInView(const VectorXd& angles) const {
  constexpr double margin = 4; // [px]
  WorkcellReading all;
  all.seen.resize(cell_.points.size());
  for (std::size_t i = 0; i < all.seen.size(); ++i) {
    all.seen[i] = static_cast<int>(i);
  }
  const VectorXd pixels = measure(cell_, body_, all, angles);
  std::vector<int> seen;
  for (const int point : all.seen) {
    const double x = pixels[2 * point], y = pixels[2 * point + 1]; // NaN behind the camera
    if (x > margin && x < LensDistortion::width - margin && y > margin && y < LensDistortion::height - margin) {
      seen.push_back(point);
    }
  }
  return seen;
}

/// Angles that reach a goal of the witness, drawn at random. Absent if it is out of reach.
std::optional<VectorXd> Stager::drawGoal(std::vector<int>& seen) {
  const VectorXd start = drawAngles(*cell_.machine, chance_);
  if (cell_.witness == Witness::touch) {
    seen = {chance_.below(static_cast<int>(cell_.places.size()))};
    const Vector3d& place = cell_.places[static_cast<std::size_t>(seen.front())];
    return reach(*cell_.machine, body_, start, [&](const MachineBody::Posture& posture) {
      return VectorXd{body_.worldFromAttached(posture, 0) * cell_.points.front() - place};
    });
  }
  if (cell_.witness == Witness::trackedPoints || cell_.witness == Witness::trackedFrame) {
    return start;
  }
  if (cell_.witness == Witness::footAndHead) { // the head looks at a place on the board
    const Vector3d place = cell_.worldFromStand * Vector3d{chance_.uniformWithin(0.1), chance_.uniformWithin(0.1), 0};
    return reach(*cell_.machine, body_, 0.6 * start, [&](const MachineBody::Posture& posture) {
      const Vector3d inCamera = (body_.worldFromAttached(posture, 0) * cell_.handFromTool).inverse() * place;
      return VectorXd{inCamera.head<2>() / std::abs(inCamera.z())};
    });
  }
  // the camera looks at a place near the board's middle, from within a cone about its normal
  constexpr double nearest = 0.35, farthest = 0.9, cone = 0.7, aside = 0.07; // [m, rad]
  const double distance = chance_.between(nearest, farthest);
  const Vector3d from = distance * withinCone(cone, chance_);
  const Vector3d target{chance_.uniformWithin(aside), chance_.uniformWithin(aside), 0};
  const Transform boardFromCamera{lookingAlong((target - from).normalized(), chance_), from};
  const bool wrist = carriesCamera(cell_.witness);
  const Transform worldFromTool = cell_.worldFromStand * (wrist ? boardFromCamera : boardFromCamera.inverse());
  const Transform worldFromHand = worldFromTool * cell_.handFromTool.inverse();
  return reach(*cell_.machine, body_, start, [&](const MachineBody::Posture& posture) {
    const Transform hand = body_.worldFromAttached(posture, 0);
    VectorXd miss{6};
    miss << hand.shift - worldFromHand.shift, worldFromHand.turn * rotationVector(worldFromHand.turn, hand.turn);
    return miss;
  });
}

std::pair<VectorXd, std::vector<int>> Stager::drawPose() {
  constexpr int tries = 4000;
  constexpr std::size_t fewest = 12; // corners
  for (int attempt = 0; attempt < tries; ++attempt) {
    std::vector<int> seen;
    const std::optional<VectorXd> angles = drawGoal(seen);
    if (!angles || !aboveFloor(body_.settled(*angles))) {
      continue;
    }
    if (seesBoard(cell_.witness)) {
      seen = pointsInView(*angles);
      if (seen.size() < fewest) {
        continue;
      }
    } else if (cell_.witness == Witness::trackedPoints) {
      seen = {0, 1, 2};
    }
    return {*angles, std::move(seen)};
  }
  throw std::runtime_error{"no pose is reached from which the witness sees enough"};
}

/// A reading of the motors at rest.
void readEncoders(const VectorXd& motors, const VectorXd& steps, WorkcellReading& reading) {
  reading.measured = motors;
  for (Index i = 0; i < motors.size(); ++i) {
    if (steps[i] > 0) {
      reading.measured[i] = std::round(motors[i] / steps[i]) * steps[i];
    }
  }
  reading.unread = motors - reading.measured;
}

/// How far a machine reaches [m], and in which direction it works.
struct Workplace {
  double reach;
  Vector3d ahead;
};

/// The hand is the camera's nominal mount; the board lies on a table or stands behind it.
void placeWristCamera(Workcell& cell, const Workplace& place, bool mountUncertain, RandomStream& chance) {
  cell.points = boardPoints(chance.between(0.025, 0.04));
  cell.handFromTool.turn = originTransform(Vector3d::Zero(), drawVector(2 * radiansPerDegree, chance)).turn;
  cell.handFromTool.shift = mountUncertain ? drawVector(mountSigma, chance) : Vector3d::Zero();
  const bool flat = chance.uniform() < 0.5;
  const Vector3d normal =
      flat ? Vector3d{Vector3d::UnitZ() - 0.2 * place.ahead} : Vector3d{0.3 * Vector3d::UnitZ() - place.ahead};
  cell.worldFromStand = {lookingAlong(normal.normalized(), chance),
                         (flat ? 0.45 : 0.9) * place.reach * place.ahead + (flat ? 0.02 : 0.4) * Vector3d::UnitZ()};
}

/// The camera looks at where the hand works.
void placeCameraBeside(Workcell& cell, const Workplace& place, RandomStream& chance) {
  cell.points = boardPoints(chance.between(0.02, 0.03));
  cell.handFromTool = {lookingAlong(withinCone(0.5, chance), chance), drawVector(0.06, chance)};
  const Vector3d camera = 1.3 * place.reach * place.ahead + chance.between(0.3, 0.7) * Vector3d::UnitZ();
  const Vector3d work = 0.45 * place.reach * place.ahead + 0.4 * Vector3d::UnitZ();
  cell.worldFromStand = {lookingAlong((work - camera).normalized(), chance), camera};
}

void placeTracker(Workcell& cell, const Workplace& place, RandomStream& chance) {
  for (int i = 0; i < 3; ++i) {
    cell.points.push_back(drawVector(0.08, chance) + Vector3d{0, 0, 0.05});
  }
  cell.handFromTool = {lookingAlong(withinCone(3, chance), chance), drawVector(0.08, chance)};
  cell.worldFromStand = {lookingAlong(withinCone(3, chance), chance),
                         3 * place.ahead + drawVector(0.5, chance) + Vector3d{0, 0, 1}};
}

/// The board on the floor is the world.
void placeFoot(Workcell& cell, const Workplace& place, RandomStream& chance) {
  cell.points = boardPoints(chance.between(0.05, 0.07));
  cell.handFromTool.turn = originTransform(Vector3d::Zero(), drawVector(2 * radiansPerDegree, chance)).turn;
  const double behind = chance.between(0.3, 0.5) * place.reach, aside = chance.uniformWithin(0.1);
  cell.worldFromSole = floorTransform(-behind, aside, chance.uniformWithin(0.3));
}

void placeContacts(Workcell& cell, const Workplace& place, RandomStream& chance) {
  cell.points.push_back(drawVector(0.03, chance) + Vector3d{0, 0, 0.08});
  for (int pair = 0; pair < 4; ++pair) {
    const double where = chance.uniformWithin(2), away = chance.between(0.35, 0.65) * place.reach;
    const double up = chance.between(0.1, 0.5) * place.reach, apart = chance.between(0.05, 0.15);
    const Vector3d first{away * std::cos(where), away * std::sin(where), up};
    cell.places.push_back(first);
    cell.places.push_back(first + apart * withinCone(pi, chance));
    cell.distances.emplace_back(2 * pair, 2 * pair + 1);
  }
}

} // namespace

VectorXd jointScale(const Machine& machine) {
  constexpr double metresPerRadian = 0.2; // of the drive of a rail
  VectorXd scale{static_cast<Index>(machine.joints.size())};
  for (Index i = 0; i < scale.size(); ++i) {
    scale[i] = machine.joints[static_cast<std::size_t>(i)].slides ? metresPerRadian : 1;
  }
  return scale;
}

JointScatter scatterOf(const WorkcellPlan& plan) {
  const double half = plan.scatter / std::sqrt(2.0);
  return {std::hypot(plan.encoderStep / std::sqrt(12.0), half), half};
}

WorkcellPlan drawWorkcellPlan(Witness witness, int poses, RandomStream& chance) {
  WorkcellPlan plan;
  plan.witness = witness;
  plan.poses = poses;
  const bool sixAxes = chance.uniform() < 0.5;
  switch (witness) {
  case Witness::wristCamera:
    plan.build = sixAxes ? MachineBuild::elbow : MachineBuild::offset;
    plan.mountUncertain = chance.uniform() < 0.5;
    break;
  case Witness::cameraBeside:
    plan.build = sixAxes ? MachineBuild::offset : MachineBuild::slender;
    break;
  case Witness::trackedPoints:
  case Witness::trackedFrame:
    plan.build = sixAxes ? MachineBuild::offset : MachineBuild::railed;
    break;
  case Witness::footAndHead:
    plan.build = MachineBuild::legged;
    break;
  case Witness::touch:
    plan.build = sixAxes ? MachineBuild::elbow : MachineBuild::slender;
    break;
  }
  plan.sigma = seesBoard(witness)
                   ? chance.between(0.1, 0.3)
                   : std::pow(10.0, witness == Witness::touch ? chance.between(-4.7, -4) : chance.between(-4.3, -3.3));
  plan.sigmaRotation = plan.sigma / 0.2;
  plan.sigmaTold = chance.uniform() < 0.5;
  const int encoders = chance.below(3); // exact, with a step that is told, or not
  plan.encoderStep = encoders == 0 ? 0 : 2 * pi / (1 << (13 + chance.below(4)));
  plan.stepTold = encoders == 1;
  plan.scatter = chance.uniform() < 0.5 ? 0 : chance.between(0.003, 0.015) * radiansPerDegree;
  plan.samples = chance.uniform() < 0.5 ? 1 : 3;
  plan.repeats = witness != Witness::touch && chance.uniform() < 0.3 ? RepeatKind::rest : RepeatKind::reapproach;
  return plan;
}

Workcell drawWorkcell(const Machine& machine, const WorkcellPlan& plan, RandomStream& chance) {
  Workcell cell;
  cell.witness = plan.witness;
  cell.machine = &machine;
  cell.flaws = MachineFlaws{machine.joints.size()};
  cell.offsets.resize(static_cast<Index>(machine.joints.size()));
  for (Index i = 0; i < cell.offsets.size(); ++i) {
    const bool slides = machine.joints[static_cast<std::size_t>(i)].slides;
    cell.offsets[i] = chance.uniformWithin(slides ? 0.01 : 2 * radiansPerDegree);
  }
  const double around = chance.uniformWithin(1.2);
  const Workplace place{reachOf(machine), {std::cos(around), std::sin(around), 0}};
  switch (plan.witness) {
  case Witness::wristCamera:
    placeWristCamera(cell, place, plan.mountUncertain, chance);
    break;
  case Witness::cameraBeside:
    placeCameraBeside(cell, place, chance);
    break;
  case Witness::trackedPoints:
  case Witness::trackedFrame:
    placeTracker(cell, place, chance);
    break;
  case Witness::footAndHead:
    placeFoot(cell, place, chance);
    break;
  case Witness::touch:
    placeContacts(cell, place, chance);
    break;
  }
  return cell;
}

WorkcellSession stageWorkcell(const Workcell& cell, const WorkcellPlan& plan, RandomStream& chance) {
  Stager stager{cell, chance};
  WorkcellSession session;
  const Index joints = cell.offsets.size();
  const auto drawEach = [&](auto draw) {
    VectorXd values{joints};
    for (double& value : values) {
      value = draw();
    }
    return values;
  };
  const double half = scatterOf(plan).pose;
  const VectorXd scale = jointScale(*cell.machine);
  double time = 0;
  int approaches = 0;
  for (int pose = 0; pose < plan.poses; ++pose) {
    const auto [angles, seen] = stager.drawPose();
    const VectorXd sticking = scale.cwiseProduct(drawEach([&] { return chance.normal(half); }));
    for (int sample = 0; sample < plan.samples; ++sample) {
      WorkcellReading reading;
      const bool rests = sample > 0 && plan.repeats == RepeatKind::rest;
      if (rests) {
        reading = session.back();
      } else {
        constexpr double control = 5e-4; // error of the motors' control [rad]
        reading.commanded = angles + cell.offsets;
        const VectorXd motors = reading.commanded + drawEach([&] { return chance.normal(control); });
        readEncoders(motors, plan.encoderStep * scale, reading);
        reading.stuck = sticking + scale.cwiseProduct(drawEach([&] { return chance.normal(half); }));
        reading.excursion = drawEach([&] { return 0.1 * chance.sign(); });
        reading.seen = seen;
        reading.approachNumber = approaches++;
      }
      reading.pose = pose;
      reading.repeat = sample;
      reading.kind = plan.repeats;
      time += rests ? 0.5 : chance.between(6, 14); // on the way here
      reading.time = time;
      session.push_back(std::move(reading));
    }
  }
  const MachineBody body = bodyOf(cell);
  for (WorkcellReading& reading : session) {
    reading.about = standFromHand(cell, body, reading, linkAngles(cell, reading)).turn;
  }
  return session;
}

void touchPlaces(const Workcell& cell, const WorkcellPlan& plan, WorkcellSession& session, RandomStream& chance) {
  const MachineBody body = bodyOf(cell);
  constexpr double nudge = 1e-6; // [rad]
  for (WorkcellReading& reading : session) {
    const Vector3d noise{chance.normal(plan.sigma), chance.normal(plan.sigma), chance.normal(plan.sigma)};
    const auto missed = [&](const WorkcellReading& one) {
      return Vector3d{measure(cell, body, one, linkAngles(cell, one)) - noise};
    };
    reading.measured += reading.unread; // the motor's position
    reading.unread.setZero();
    for (int round = 0; round < 8; ++round) {
      const Vector3d miss = missed(reading);
      Eigen::MatrixXd slopes{3, reading.measured.size()};
      for (Index i = 0; i < reading.measured.size(); ++i) {
        WorkcellReading nudged = reading;
        nudged.measured[i] += nudge;
        slopes.col(i) = (missed(nudged) - miss) / nudge;
      }
      reading.measured -= slopes.completeOrthogonalDecomposition().solve(miss);
    }
    readEncoders(VectorXd{reading.measured}, plan.encoderStep * jointScale(*cell.machine), reading);
  }
}

} // namespace blind
