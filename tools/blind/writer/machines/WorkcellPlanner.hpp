#pragma once

#include "world/machines/MachineBuilds.hpp"
#include "world/machines/Workcell.hpp"

#include <string>

namespace blind {

/// Session and noise of a machine.
struct WorkcellPlan {
  Witness witness = Witness::wristCamera;
  MachineBuild build = MachineBuild::elbow;
  int poses = 30, samples = 1;
  RepeatKind repeats = RepeatKind::reapproach;
  double sigma = 0.2;          // of a measurement per axis [px], [m]
  double sigmaRotation = 0;    // of a tracked frame per axis [rad]
  bool sigmaTold = true;       // the set gives it
  double encoderStep = 0;      // 0: exact readings [rad]
  bool stepTold = true;        // the set gives it
  double scatter = 0;          // of joints, 1 sigma; half of the variance is common to all approaches of a pose [rad]
  bool mountUncertain = false; // the camera on the wrist may be off in position, too
  double slipStep = 0;         // a motor's turn seen at the joint; 0: not told [rad]
};

constexpr double mountSigma = 0.005;   // told of an uncertain mount [m]
constexpr double distanceSigma = 2e-5; // of a distance between places [m]

/// The joints' random errors: motor position minus reading of one approach, and deflections [rad].
struct JointScatter {
  double approach = 0, pose = 0; // standard deviations
};
JointScatter scatterOf(const WorkcellPlan& plan);

/// By joint: what a random error of joints in radians is for it [rad], [m].
Eigen::VectorXd jointScale(const Machine& machine);

WorkcellPlan drawWorkcellPlan(Witness witness, int poses, RandomStream& chance);

/// A machine at its place without flaws; offsets within 2 degrees, mounts within 2 degrees.
Workcell drawWorkcell(const Machine& machine, const WorkcellPlan& plan, RandomStream& chance);

/// Poses from which the witness sees enough, and readings there. Throws std::runtime_error if none are found.
WorkcellSession stageWorkcell(const Workcell& cell, const WorkcellPlan& plan, RandomStream& chance);

/// Moves the readings of a machine with flaws to where its ball touches the places, missing them by the noise.
void touchPlaces(const Workcell& cell, const WorkcellPlan& plan, WorkcellSession& session, RandomStream& chance);

} // namespace blind
