#include "estimation/Residuals.hpp"

#include "math/LinearAlgebra.hpp"
#include "math/Parallel.hpp"
#include "math/Statistics.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <utility>

namespace naocal {

namespace {

/// The chain from the torso to the floor, if the IMU tilt is an unknown and a reading was recorded.
std::optional<ObservationChain> torsoOverFloor(const Measurements& measurements, const Model& model,
                                               const ImageObservation& picture) {
  const bool wanted = std::any_of(model.terms().begin(), model.terms().end(),
                                  [](const Term& term) { return term.effect.name == "imuTilt"; });
  const bool onFloor =
      std::any_of(picture.observations.begin(), picture.observations.end(), [&](const BoardObservation& observation) {
        return measurements.targets[observation.view.board()].inWorld;
      });
  if (!wanted || !onFloor || picture.instant.imu.hasNaN()) {
    return std::nullopt;
  }
  const bool right = picture.instant.supportFoot == SupportFoot::right;
  return ObservationChain::betweenLinks(measurements.robot, measurements.quantities, 0,
                                        measurements.robot.findSole(right ? "right" : "left")->link);
}

} // namespace

Residuals::Residuals(const Measurements& measurements, const Model& model, const Noise& noise, const Loss& loss)
    : measurements_{measurements}, model_{model}, noise_{noise}, pictures_{measurements, model, noise, loss},
      sigmas_{model.sigmas()}, free_(model.unknownCount(), true), prepared_(measurements.pictures.size()),
      columns_(measurements.poses.size()), roots_(measurements.poses.size()) {
  parallelFor(prepared_.size(), [&](std::size_t i) {
    prepared_[i].slopes = EffectJacobian{measurements, model, measurements.pictures[i]};
    prepared_[i].torso = torsoOverFloor(measurements, model, measurements.pictures[i]);
  });
  parallelFor(columns_.size(), [&](std::size_t pose) {
    columns_[pose] = listColumns(measurements.poses[pose]);
    roots_[pose] = jointErrorRoot(columns_[pose], noise_);
    for (const EncoderSample& reading : measurements.poses[pose].readings) {
      for (std::size_t index : reading.pictures) {
        prepareImage(measurements, measurements.pictures[index], columns_[pose].unknowns, prepared_[index]);
      }
    }
  });
}

/// Unknowns that a pose depends on, and one deflection per joint on its paths and encoder error.
PosePart Residuals::listColumns(const PoseGroup& pose) {
  PosePart part;
  std::vector<bool> moves(model_.unknownCount(), false);
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> deflections; // keyed by (motor, encoder error)
  const bool latent = noise_.encoder > 0 || noise_.pose > 0 || noise_.stance > 0 || noise_.reapproach > 0;
  for (const EncoderSample& reading : pose.readings) {
    for (std::size_t index : reading.pictures) {
      PreparedImage& picture = prepared_[index];
      for (const StateDerivative& slope : picture.slopes.entries()) {
        moves[slope.unknown] = true;
      }
      if (latent) {
        picture.joints = observedJoints(measurements_.robot, measurements_.pictures[index]);
      }
      for (std::size_t joint : picture.joints) {
        deflections[{measurements_.robot.joints[joint].motor, reading.encoderError[joint]}];
      }
    }
  }
  for (auto& [joint, number] : deflections) {
    number = part.joints.size();
    part.joints.push_back(joint.first);
    part.errors.push_back(joint.second);
    part.errorScales.push_back(pose.encoderErrors[joint.second].scale);
    part.stances.push_back(pose.encoderErrors[joint.second].stance);
  }
  for (const EncoderSample& reading : pose.readings) {
    for (std::size_t index : reading.pictures) {
      for (std::size_t joint : prepared_[index].joints) {
        prepared_[index].deflections.push_back(
            deflections.at({measurements_.robot.joints[joint].motor, reading.encoderError[joint]}));
      }
    }
  }
  for (std::size_t unknown = 0; unknown < moves.size(); ++unknown) {
    if (moves[unknown]) {
      part.unknowns.push_back(unknown);
    }
  }
  return part;
}

namespace {

/// Splits a pose's normal equations into blocks, re-expressed at zero deflection.
void splitNormalEquations(const NormalEquations& sums, const Eigen::VectorXd& deflections, PoseSystem& system) {
  const Eigen::Index unknowns = eigenIndex(system.unknowns.size()), joints = deflections.size();
  const Eigen::MatrixXd& gram = sums.gram();
  system.unknownGram = gram.topLeftCorner(unknowns, unknowns);
  system.unknownGradient = sums.gradient().head(unknowns);
  system.jointErrorCross = gram.topRightCorner(unknowns, joints);
  system.jointErrorGram = gram.bottomRightCorner(joints, joints);
  system.jointErrorGradient = sums.gradient().tail(joints);
  if (joints == 0) {
    return;
  }
  const Eigen::VectorXd drop = system.jointErrorGram * deflections;
  system.squares += deflections.dot(drop - 2 * system.jointErrorGradient);
  system.jointErrorGradient -= drop;
  system.unknownGradient -= system.jointErrorCross * deflections;
}

/// Minimising deflections of a pose in the linearised problem, with its unknowns moved by `along`.
Eigen::VectorXd minimizingDeflections(const MarginalSystem& part, const Eigen::VectorXd& along = {}) {
  Eigen::VectorXd result = -part.half.rightCols<1>();
  result.noalias() -= part.half.leftCols(along.size()) * along;
  part.inner.matrixU().solveInPlace(result);
  return result;
}

} // namespace

Residuals::State Residuals::startState(const Eigen::VectorXd& unknowns) const {
  State state{unknowns, {}};
  for (const PosePart& pose : columns_) {
    state.deflections.push_back(Eigen::VectorXd::Zero(eigenIndex(pose.joints.size())));
  }
  return state;
}

/// Adds all pictures of a pose to the workspace's sums. False if a corner has no projection.
bool Residuals::addPose(std::size_t pose, const State& state, const Eigen::VectorXd& deflections,
                        PictureWorkspace& work, PosePart& part) const {
  part.squares = part.numbers = part.freedom = 0;
  for (const EncoderSample& reading : measurements_.poses[pose].readings) {
    for (std::size_t index : reading.pictures) {
      const ImageObservation& picture = measurements_.pictures[index];
      const PreparedImage& ready = prepared_[index];
      pictures_.predictState(picture, ready, state.unknowns, deflections, work);
      if (!pictures_.add(picture, ready, work, part)) {
        return false;
      }
    }
  }
  part.loss = work.cost;
  return true;
}

/// Sums a pose at these deflections and marginalises them. False if a corner has no projection.
bool Residuals::linearizeAt(std::size_t pose, const State& state, const Eigen::VectorXd& inSigmas, PoseSystem& system,
                            MarginalSystem& part) const {
  PictureWorkspace& work = PictureWorkspace::ofThread(measurements_);
  const Eigen::VectorXd deflections = roots_[pose] * inSigmas;
  work.sums.clear(eigenIndex(system.unknowns.size() + system.joints.size()));
  work.wantsRows = false;
  if (!addPose(pose, state, deflections, work, system)) {
    return false;
  }
  splitNormalEquations(work.sums, deflections, system);
  marginalize(system, noise_, roots_[pose], part);
  return true;
}

/// Iterates from a pose's sums until its deflections converge.
void Residuals::settleDeflections(std::size_t pose, State& state, PoseSystem& system, MarginalSystem& part) const {
  constexpr int most = 20;
  constexpr double little = 1e-4; // cost decrease per step
  Eigen::VectorXd& here = state.deflections[pose];
  for (int step = 0; step < most; ++step) {
    Eigen::VectorXd there = minimizingDeflections(part);
    const double gained = 0.5 * (part.inner.matrixU() * (there - here)).squaredNorm();
    if (!(gained > little)) {
      return;
    }
    PoseSystem onward{columns_[pose], {}, {}, {}, {}, {}};
    MarginalSystem onwardPart;
    if (!linearizeAt(pose, state, there, onward, onwardPart) ||
        !(onward.loss + there.squaredNorm() < system.loss + here.squaredNorm())) {
      return;
    }
    here.swap(there);
    system = std::move(onward);
    part = std::move(onwardPart);
  }
}

std::optional<std::vector<PoseRows>> Residuals::rows(const State& state) const {
  std::vector<PoseRows> result(columns_.size());
  std::atomic<bool> possible = true;
  parallelFor(columns_.size(), [&](std::size_t pose) {
    PictureWorkspace& work = PictureWorkspace::ofThread(measurements_);
    PoseRows& rows = result[pose];
    static_cast<PosePart&>(rows) = columns_[pose];
    const Eigen::VectorXd deflections = roots_[pose] * state.deflections[pose];
    work.rows.clear(eigenIndex(rows.unknowns.size() + rows.joints.size()));
    work.wantsRows = true;
    if (!possible || !addPose(pose, state, deflections, work, rows)) {
      possible = false;
      return;
    }
    work.rows.takeRows(deflections, rows);
  });
  return possible ? std::optional{std::move(result)} : std::nullopt;
}

/// Linearises poses in parallel. False if one is infeasible.
template <class AtPose> bool Residuals::linearisePoses(Linear& result, const AtPose& atPose) const {
  if (result.poses.empty()) {
    for (const PosePart& columns : columns_) {
      result.poses.push_back({columns, {}, {}, {}, {}, {}});
    }
    result.eliminated.resize(columns_.size());
  }
  std::atomic<bool> possible = true;
  parallelFor(columns_.size(), [&](std::size_t pose) {
    if (possible && !atPose(pose, result.poses[pose], result.eliminated[pose])) {
      possible = false;
    }
  });
  return possible;
}

/// Sums the poses in order, and adds the priors.
void Residuals::sumPoses(const State& state, Linear& result) const {
  const Eigen::VectorXd inPrior = state.unknowns.cwiseQuotient(sigmas_);
  result.cost = 0.5 * inPrior.squaredNorm();
  result.gradient = inPrior.cwiseQuotient(sigmas_);
  result.hessian = sigmas_.cwiseAbs2().cwiseInverse().asDiagonal();
  for (std::size_t pose = 0; pose < columns_.size(); ++pose) {
    const PoseSystem& system = result.poses[pose];
    const MarginalSystem& part = result.eliminated[pose];
    result.cost += 0.5 * (system.loss + state.deflections[pose].squaredNorm());
    result.gradient(system.unknowns) += part.unknownGradient;
    result.hessian(system.unknowns, system.unknowns) += part.hessian;
  }
  for (std::size_t i = 0; i < free_.size(); ++i) {
    if (!free_[i]) {
      result.gradient[eigenIndex(i)] = 0;
      result.hessian.row(eigenIndex(i)).setZero();
      result.hessian.col(eigenIndex(i)).setZero();
      result.hessian(eigenIndex(i), eigenIndex(i)) = 1;
    }
  }
}

std::optional<Residuals::Linear> Residuals::linearize(const State& state) const {
  std::optional<Linear> result{std::in_place};
  const bool possible = linearisePoses(*result, [&](std::size_t pose, PoseSystem& system, MarginalSystem& part) {
    return linearizeAt(pose, state, state.deflections[pose], system, part);
  });
  if (!possible) {
    return std::nullopt;
  }
  sumPoses(state, *result);
  return result;
}

bool Residuals::linearize(State& state, Linear& result) const {
  const bool possible = linearisePoses(result, [&](std::size_t pose, PoseSystem& system, MarginalSystem& part) {
    if (!linearizeAt(pose, state, state.deflections[pose], system, part)) {
      return false;
    }
    if (!columns_[pose].joints.empty()) {
      settleDeflections(pose, state, system, part);
    }
    return true;
  });
  if (possible) {
    sumPoses(state, result);
  }
  return possible;
}

Residuals::State Residuals::applyStep(const State& state, const Linear& linear, const Eigen::VectorXd& step) const {
  State result{state.unknowns + step, {}};
  for (std::size_t pose = 0; pose < columns_.size(); ++pose) {
    if (columns_[pose].joints.empty()) {
      result.deflections.emplace_back();
      continue;
    }
    const MarginalSystem& part = linear.eliminated[pose];
    Eigen::VectorXd along = Eigen::VectorXd::Zero(part.half.cols() - 1);
    for (std::size_t i = 0; i < columns_[pose].unknowns.size(); ++i) {
      along[eigenIndex(i)] = step[eigenIndex(columns_[pose].unknowns[i])];
    }
    result.deflections.push_back(minimizingDeflections(part, along));
  }
  return result;
}

/// Calls visit(pose, picture, work) for every picture in pose order, with the workspace at the picture's state. Ends
/// early, and returns false, where a visit does.
template <class Visit> bool Residuals::visitPictures(const State& state, const Visit& visit) const {
  PictureWorkspace& work = PictureWorkspace::ofThread(measurements_);
  for (std::size_t pose = 0; pose < columns_.size(); ++pose) {
    const Eigen::VectorXd deflections = roots_[pose] * state.deflections[pose];
    for (const EncoderSample& reading : measurements_.poses[pose].readings) {
      for (std::size_t index : reading.pictures) {
        pictures_.predictState(measurements_.pictures[index], prepared_[index], state.unknowns, deflections, work);
        if (!visit(pose, index, work)) {
          return false;
        }
      }
    }
  }
  return true;
}

std::optional<std::vector<BoardMotionSums>> Residuals::boardMotions(const State& state) const {
  std::vector<BoardMotionSums> result;
  const bool possible = visitPictures(state, [&](std::size_t pose, std::size_t index, PictureWorkspace& work) {
    const Eigen::Index columns = eigenIndex(columns_[pose].unknowns.size() + columns_[pose].joints.size());
    for (const PreparedImage::Group& group : prepared_[index].groups) {
      for (std::size_t observation : group.observations) {
        BoardMotionSums motion{.picture = index, .observation = observation, .pose = pose};
        motion.cross.setZero(6, columns);
        if (!pictures_.addMotion(measurements_.pictures[index].observations[observation], group, work, motion)) {
          return false;
        }
        result.push_back(std::move(motion));
      }
    }
    return true;
  });
  return possible ? std::optional{std::move(result)} : std::nullopt;
}

std::vector<BoardResidual> Residuals::boardResiduals(const State& state) const {
  std::vector<BoardResidual> result;
  visitPictures(state, [&](std::size_t, std::size_t index, PictureWorkspace& work) {
    for (std::size_t i = 0; i < measurements_.pictures[index].observations.size(); ++i) {
      result.push_back(pictures_.boardResidual(index, i, work));
    }
    return true;
  });
  return result;
}

std::vector<WitnessResidual> Residuals::witnessResiduals(const State& state) const {
  std::vector<WitnessResidual> result;
  if (measurements_.witnessCount == 0) {
    return result;
  }
  visitPictures(state, [&](std::size_t, std::size_t index, PictureWorkspace& work) {
    for (std::size_t i = 0; i < measurements_.pictures[index].witnesses.size(); ++i) {
      result.push_back(pictures_.witnessResidual(index, i, work));
    }
    return true;
  });
  return result;
}

std::vector<double> collectDistances(const std::vector<BoardResidual>& residuals) {
  std::vector<double> distances;
  for (const BoardResidual& board : residuals) {
    for (Eigen::Index i = 0; i < board.residual.cols(); ++i) {
      distances.push_back(board.residual.col(i).norm());
    }
  }
  return distances;
}

ResidualSummary summarizeDistances(std::vector<double> distances) {
  ResidualSummary result{0, 0, distances.size()};
  if (distances.empty()) {
    return result;
  }
  double squares = 0;
  for (const double distance : distances) {
    squares += distance * distance;
  }
  result.rmsPx = result.medianPx = std::sqrt(squares / static_cast<double>(distances.size()));
  if (!std::isfinite(result.rmsPx)) { // NaN has no order
    return result;
  }
  result.medianPx = medianOf(distances);
  return result;
}

} // namespace naocal
