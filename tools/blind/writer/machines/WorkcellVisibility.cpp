#include "writer/machines/WorkcellVisibility.hpp"

#include <cmath>
#include <functional>
#include <map>

namespace blind {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

/// Something that a calibration estimates besides the effects.
struct Nuisance {
  std::function<void(Workcell&, double)> change;
  double sigma; // prior
};

/// The six motions of a transform in its own frame.
void addPlacement(std::vector<Nuisance>& result, Transform Workcell::*member) {
  constexpr double anywhere = 10; // [m, rad]
  for (int axis = 0; axis < 3; ++axis) {
    result.push_back({[member, axis](Workcell& cell, double by) {
                        cell.*member = cell.*member * Transform{Eigen::Matrix3d::Identity(), by * Vector3d::Unit(axis)};
                      },
                      anywhere});
    result.push_back(
        {[member, axis](Workcell& cell, double by) {
           cell.*member = cell.*member * Transform{rotationAbout(Vector3d::Unit(axis), by), Vector3d::Zero()};
         },
         anywhere});
  }
}

/// Of the foot; the board is the world.
void addFloorPlacement(std::vector<Nuisance>& result) {
  constexpr double anywhere = 10; // [m, rad]
  for (int axis = 0; axis < 3; ++axis) {
    result.push_back({[axis](Workcell& cell, double by) {
                        const auto along = [&](int which) { return axis == which ? by : 0; };
                        cell.worldFromSole = cell.worldFromSole * floorTransform(along(0), along(1), along(2));
                      },
                      anywhere});
  }
}

void addMount(std::vector<Nuisance>& result, bool uncertain) {
  constexpr double turnSigma = 0.05; // [rad]
  for (int axis = 0; axis < 3; ++axis) {
    result.push_back({[axis](Workcell& cell, double by) {
                        cell.handFromTool.turn = cell.handFromTool.turn * rotationAbout(Vector3d::Unit(axis), by);
                      },
                      turnSigma});
    if (uncertain) {
      result.push_back({[axis](Workcell& cell, double by) { cell.handFromTool.shift[axis] += by; }, mountSigma});
    }
  }
}

void addPoints(std::vector<Nuisance>& result, std::vector<Vector3d> Workcell::*member, std::size_t count,
               double sigma) {
  for (std::size_t point = 0; point < count; ++point) {
    for (int axis = 0; axis < 3; ++axis) {
      result.push_back(
          {[member, point, axis](Workcell& cell, double by) { (cell.*member)[point][axis] += by; }, sigma});
    }
  }
}

std::vector<Nuisance> nuisancesOf(const Workcell& cell, const WorkcellPlan& plan) {
  constexpr double offsetSigma = 0.1, markerSigma = 0.1, anywhere = 10; // [rad], [m], [m]
  std::vector<Nuisance> result;
  for (Index joint = 0; joint < cell.offsets.size(); ++joint) {
    result.push_back({[joint](Workcell& changed, double by) { changed.offsets[joint] += by; }, offsetSigma});
  }
  if (carriesCamera(cell.witness)) {
    addMount(result, plan.mountUncertain);
  } else if (cell.witness == Witness::cameraBeside || cell.witness == Witness::trackedFrame) {
    addPlacement(result, &Workcell::handFromTool);
  } else {
    addPoints(result, &Workcell::points, cell.points.size(), markerSigma);
  }
  if (cell.witness == Witness::footAndHead) {
    addFloorPlacement(result);
  } else if (cell.witness == Witness::touch) {
    addPoints(result, &Workcell::places, cell.places.size(), anywhere);
  } else {
    addPlacement(result, &Workcell::worldFromStand);
  }
  return result;
}

Index rowCount(const Workcell& cell, const WorkcellReading& reading) {
  const auto seen = static_cast<Index>(reading.seen.size());
  switch (cell.witness) {
  case Witness::wristCamera:
  case Witness::cameraBeside:
  case Witness::footAndHead:
    return 2 * seen;
  case Witness::trackedFrame:
    return 6;
  case Witness::trackedPoints:
  case Witness::touch:
    break;
  }
  return 3 * seen;
}

/// Derivative of all measurements by what `change` does to the cell.
VectorXd slopeBy(const Workcell& cell, const WorkcellSession& session, const Nuisance& nuisance) {
  constexpr double nudge = 1e-5; // [rad, m]
  Workcell before = cell, after = cell;
  nuisance.change(before, -nudge);
  nuisance.change(after, nudge);
  return (stackMeasurements(after, session) - stackMeasurements(before, session)) / (2 * nudge);
}

/// Derivatives by the true angle of each joint, at every reading [1/rad], [1/m].
Eigen::MatrixXd byJoints(const Workcell& cell, const WorkcellSession& session) {
  const Index joints = cell.offsets.size();
  Eigen::MatrixXd result{stackMeasurements(cell, session).size(), joints};
  for (Index joint = 0; joint < joints; ++joint) {
    result.col(joint) =
        -slopeBy(cell, session, {[joint](Workcell& changed, double by) { changed.offsets[joint] += by; }, 1});
  }
  return result;
}

/// Noise of the readings of one pose, which begin at rows `first`.
PoseNoise poseNoise(const Workcell& cell, const WorkcellPlan& plan, const Eigen::MatrixXd& joints,
                    const std::vector<std::pair<const WorkcellReading*, Index>>& members) {
  const JointScatter scatter = scatterOf(plan);
  const VectorXd scale = jointScale(*cell.machine);
  std::map<int, Index> approaches;
  Index size = 0;
  for (const auto& [reading, first] : members) {
    approaches.try_emplace(reading->approachNumber, static_cast<Index>(approaches.size()));
    size += rowCount(cell, *reading);
  }
  const auto parts = static_cast<Index>(approaches.size()) + 1;
  PoseNoise result{{}, Eigen::MatrixXd::Zero(size, parts * joints.cols()), VectorXd{size}};
  Index at = 0;
  for (const auto& [reading, first] : members) {
    const Index height = rowCount(cell, *reading);
    const Eigen::MatrixXd moved = joints.middleRows(first, height) * scale.asDiagonal();
    const Index approach = joints.cols() * approaches.at(reading->approachNumber);
    result.shared.block(at, approach, height, joints.cols()) = scatter.approach * moved;
    result.shared.block(at, (parts - 1) * joints.cols(), height, joints.cols()) = scatter.pose * moved;
    for (Index i = 0; i < height; ++i) {
      const bool turn = cell.witness == Witness::trackedFrame && i >= 3;
      result.rows.push_back(first + i);
      result.weights[at + i] = std::pow(turn ? plan.sigmaRotation : plan.sigma, -2);
    }
    at += height;
  }
  return result;
}

} // namespace

VectorXd stackMeasurements(const Workcell& cell, const WorkcellSession& session) {
  const MachineBody body = bodyOf(cell);
  std::vector<double> values;
  for (const WorkcellReading& reading : session) {
    const VectorXd measured = measure(cell, body, reading, linkAngles(cell, reading));
    values.insert(values.end(), measured.begin(), measured.end());
  }
  const VectorXd distances = placeDistances(cell);
  values.insert(values.end(), distances.begin(), distances.end());
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size()));
}

ProjectedProduct workcellVisibility(const Workcell& cell, const WorkcellSession& session, const WorkcellPlan& plan) {
  const Eigen::MatrixXd joints = byJoints(cell, session);
  std::map<int, std::vector<std::pair<const WorkcellReading*, Index>>> poses;
  Index row = 0;
  for (const WorkcellReading& reading : session) {
    poses[reading.pose].emplace_back(&reading, row);
    row += rowCount(cell, reading);
  }
  std::vector<PoseNoise> noise;
  for (const auto& [pose, members] : poses) {
    noise.push_back(poseNoise(cell, plan, joints, members));
  }
  for (; row < joints.rows(); ++row) {
    noise.push_back({{row}, Eigen::MatrixXd::Zero(1, 1), VectorXd::Constant(1, std::pow(distanceSigma, -2))});
  }
  const std::vector<Nuisance> nuisances = nuisancesOf(cell, plan);
  const auto count = static_cast<Index>(nuisances.size());
  Eigen::MatrixXd unknowns{joints.rows(), count};
  VectorXd priors{count};
  for (Index i = 0; i < count; ++i) {
    const Nuisance& nuisance = nuisances[static_cast<std::size_t>(i)];
    unknowns.col(i) = slopeBy(cell, session, nuisance);
    priors[i] = std::pow(nuisance.sigma, -2);
  }
  return {std::move(noise), std::move(unknowns), priors};
}

} // namespace blind
