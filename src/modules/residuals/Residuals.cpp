#include "residuals/Residuals.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/Parallel.hpp"
#include "residuals/Workspace.hpp"

#include <algorithm>
#include <atomic>

namespace naocal {

namespace {

/// Takes a pose's normal equations apart, expressed at zero deflection.
void takeSums(const NormalEquations& sums, const Eigen::VectorXd& deflections, PoseSystem& system) {
  const Eigen::Index unknowns = at(system.unknowns.size()), joints = deflections.size();
  const Eigen::MatrixXd& gram = sums.gram();
  system.unknownGram = gram.topLeftCorner(unknowns, unknowns);
  system.unknownGradient = sums.gradient().head(unknowns);
  system.cross = gram.topRightCorner(unknowns, joints);
  system.deflectionGram = gram.bottomRightCorner(joints, joints);
  system.deflectionGradient = sums.gradient().tail(joints);
  if (joints == 0) {
    return;
  }
  const Eigen::VectorXd drop = system.deflectionGram * deflections;
  system.squares += deflections.dot(drop - 2 * system.deflectionGradient);
  system.deflectionGradient -= drop;
  system.unknownGradient -= system.cross * deflections;
}

/// Where a pose's deflections would rest if everything were linear, its unknowns moved `along`.
Eigen::VectorXd restingDeflections(const Eliminated& part, const Eigen::VectorXd& along = {}) {
  Eigen::VectorXd result = -part.half.rightCols<1>();
  result.noalias() -= part.half.leftCols(along.size()) * along;
  part.inner.matrixU().solveInPlace(result);
  return result;
}

} // namespace

/// What is believed at the picture's instant, and the values of its slopes there.
void Residuals::believe(const Picture& picture, const PreparedPicture& prepared, const Eigen::VectorXd& unknowns,
                        const Eigen::VectorXd& deflections, Workspace& work) const {
  work.belief = picture.drawn;
  prepared.slopes.addFixed(unknowns, work.belief);
  work.slopes = prepared.slopeValues.data();
  if (prepared.slopes.vary()) {
    work.varyingSlopes = prepared.slopeValues;
    work.slopes = work.varyingSlopes.data();
    work.drive(measurements_, model_, picture, unknowns);
    prepared.slopes.addVarying(model_, picture, unknowns, work.driven, work.scratch, work.belief,
                               work.varyingSlopes.data() + 1 + prepared.slopes.fixedCount());
  }
  for (std::size_t i = 0; i < prepared.joints.size(); ++i) {
    work.belief.angle(prepared.joints[i]) += deflections[at(prepared.deflections[i])];
  }
}

/// Adds the sums over a picture's corners to those of its pose. False: a corner is nowhere.
bool Residuals::addPicture(const Picture& picture, const PreparedPicture& prepared, Workspace& work,
                           PosePart& part) const {
  posture(measurements_.robot, work.belief, prepared.links, work.torsoFromLink);
  if (picture.otherSole) {
    addFloorContact(picture, prepared, work, part);
  }
  if (prepared.torso) {
    addImuReading(picture, prepared, work, part);
  }
  return std::all_of(prepared.groups.begin(), prepared.groups.end(),
                     [&](const PreparedPicture::Group& group) { return addGroup(picture, group, work, part); });
}

/// Adds the corners of a sighting to the workspace's sums over corners. False: one of them is nowhere.
bool Residuals::addCorners(const Sighting& sighting, const std::vector<std::size_t>& extras, Attitude& attitude,
                           Workspace& work) const {
  sighting.view.placeBoard(work.linkFromBoard(sighting.view.board()), attitude);
  if (!sighting.view.project(attitude, work.belief, sighting.corners, work.projected)) {
    return false;
  }
  work.extraRows.clear();
  for (std::size_t extra : extras) {
    for (std::size_t block = 0; block < sighting.corners.size(); ++block) {
      ExtraRow& row = work.extraRows.emplace_back();
      View::extraRows(extra, attitude, work.belief, sighting.corners[block], work.projected[block], row.u, row.v);
    }
  }
  work.corners.add(sighting.corners, work.projected, work.extraRows, noise_.pixel,
                   {cornerShare(noise_, sighting.repeats), sighting.repeats}, loss_);
  return true;
}

bool Residuals::addGroup(const Picture& picture, const PreparedPicture::Group& group, Workspace& work,
                         PosePart& part) const {
  const View& path = picture.sightings[group.sightings.front()].view;
  Attitude attitude = path.pathAttitude(measurements_.robot, work.belief, work.torsoFromLink);
  if (std::find(group.extras.begin(), group.extras.end(), rowTimeExtra) != group.extras.end()) {
    path.setDrift(measurements_.robot, work.belief, work.torsoFromLink, picture.instant.velocity, attitude);
  }
  work.corners.clear(group.extras.size());
  for (std::size_t index : group.sightings) {
    if (!addCorners(picture.sightings[index], group.extras, attitude, work)) {
      return false;
    }
  }
  work.motion.resize(at(6 + group.extras.size()), at(group.quantities.size()));
  path.motion(measurements_.robot, attitude, work.belief, work.torsoFromLink, group.quantities, group.extras,
              work.motion);
  work.add(work.corners.gram(), work.corners.gradient(), work.motion, group);
  work.cost += work.corners.cost();
  part.squares += work.corners.squares();
  part.numbers += 2 * work.corners.corners();
  part.freedom += 2 * work.corners.freedom();
  return true;
}

Residuals::State Residuals::start(const Eigen::VectorXd& unknowns) const {
  State state{unknowns, {}};
  for (const PosePart& pose : columns_) {
    state.deflections.push_back(Eigen::VectorXd::Zero(at(pose.joints.size())));
  }
  return state;
}

/// Adds all of a pose's pictures to the workspace's sums. False: a corner is nowhere.
bool Residuals::addPose(std::size_t pose, const State& state, const Eigen::VectorXd& deflections, Workspace& work,
                        PosePart& part) const {
  part.squares = part.numbers = part.freedom = 0;
  for (const Reading& reading : measurements_.poses[pose].readings) {
    for (std::size_t index : reading.pictures) {
      const Picture& picture = measurements_.pictures[index];
      const PreparedPicture& ready = prepared_[index];
      believe(picture, ready, state.unknowns, deflections, work);
      if (!addPicture(picture, ready, work, part)) {
        return false;
      }
    }
  }
  part.loss = work.cost;
  return true;
}

/// A pose's sums at these deflections, which are then eliminated. False: one of its corners is nowhere.
bool Residuals::lineariseAt(std::size_t pose, const State& state, const Eigen::VectorXd& inSigmas, PoseSystem& system,
                            Eliminated& part) const {
  Workspace& work = Workspace::ofThisThread(measurements_);
  const Eigen::VectorXd deflections = roots_[pose] * inSigmas;
  work.sums.clear(at(system.unknowns.size() + system.joints.size()));
  work.wantsRows = false;
  if (!addPose(pose, state, deflections, work, system)) {
    return false;
  }
  takeSums(work.sums, deflections, system);
  eliminate(system, noise_, roots_[pose], part);
  return true;
}

/// Goes on from a pose's sums to where its deflections rest.
void Residuals::settle(std::size_t pose, State& state, PoseSystem& system, Eliminated& part) const {
  constexpr int most = 20;
  constexpr double little = 1e-4; // of the cost, which a step would gain
  Eigen::VectorXd& here = state.deflections[pose];
  for (int step = 0; step < most; ++step) {
    Eigen::VectorXd there = restingDeflections(part);
    const double gained = 0.5 * (part.inner.matrixU() * (there - here)).squaredNorm();
    if (!(gained > little)) {
      return;
    }
    PoseSystem onward{columns_[pose], {}, {}, {}, {}, {}};
    Eliminated onwardPart;
    if (!lineariseAt(pose, state, there, onward, onwardPart) ||
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
  inParallel(columns_.size(), [&](std::size_t pose) {
    Workspace& work = Workspace::ofThisThread(measurements_);
    PoseRows& rows = result[pose];
    static_cast<PosePart&>(rows) = columns_[pose];
    const Eigen::VectorXd deflections = roots_[pose] * state.deflections[pose];
    work.rows.clear(at(rows.unknowns.size() + rows.joints.size()));
    work.wantsRows = true;
    if (!possible || !addPose(pose, state, deflections, work, rows)) {
      possible = false;
      return;
    }
    work.rows.take(deflections, rows);
  });
  return possible ? std::optional{std::move(result)} : std::nullopt;
}

/// Poses side by side. False: one of them is impossible.
template <class AtPose> bool Residuals::linearisePoses(Linear& result, const AtPose& atPose) const {
  if (result.poses.empty()) {
    for (const PosePart& columns : columns_) {
      result.poses.push_back({columns, {}, {}, {}, {}, {}});
    }
    result.eliminated.resize(columns_.size());
  }
  std::atomic<bool> possible = true;
  inParallel(columns_.size(), [&](std::size_t pose) {
    if (possible && !atPose(pose, result.poses[pose], result.eliminated[pose])) {
      possible = false;
    }
  });
  return possible;
}

/// Poses in their order, and the priors.
void Residuals::addUp(const State& state, Linear& result) const {
  const Eigen::VectorXd inPrior = state.unknowns.cwiseQuotient(sigmas_);
  result.cost = 0.5 * inPrior.squaredNorm();
  result.gradient = inPrior.cwiseQuotient(sigmas_);
  result.hessian = sigmas_.cwiseAbs2().cwiseInverse().asDiagonal();
  for (std::size_t pose = 0; pose < columns_.size(); ++pose) {
    const PoseSystem& system = result.poses[pose];
    const Eliminated& part = result.eliminated[pose];
    result.cost += 0.5 * (system.loss + state.deflections[pose].squaredNorm());
    result.gradient(system.unknowns) += part.unknownGradient;
    result.hessian(system.unknowns, system.unknowns) += part.hessian;
  }
  for (std::size_t i = 0; i < free_.size(); ++i) {
    if (!free_[i]) {
      result.gradient[at(i)] = 0;
      result.hessian.row(at(i)).setZero();
      result.hessian.col(at(i)).setZero();
      result.hessian(at(i), at(i)) = 1;
    }
  }
}

std::optional<Residuals::Linear> Residuals::linearised(const State& state) const {
  std::optional<Linear> result{std::in_place};
  const bool possible = linearisePoses(*result, [&](std::size_t pose, PoseSystem& system, Eliminated& part) {
    return lineariseAt(pose, state, state.deflections[pose], system, part);
  });
  if (!possible) {
    return std::nullopt;
  }
  addUp(state, *result);
  return result;
}

bool Residuals::linearise(State& state, Linear& result) const {
  const bool possible = linearisePoses(result, [&](std::size_t pose, PoseSystem& system, Eliminated& part) {
    if (!lineariseAt(pose, state, state.deflections[pose], system, part)) {
      return false;
    }
    if (!columns_[pose].joints.empty()) {
      settle(pose, state, system, part);
    }
    return true;
  });
  if (possible) {
    addUp(state, result);
  }
  return possible;
}

Residuals::State Residuals::moved(const State& state, const Linear& linear, const Eigen::VectorXd& step) const {
  State result{state.unknowns + step, {}};
  for (std::size_t pose = 0; pose < columns_.size(); ++pose) {
    if (columns_[pose].joints.empty()) {
      result.deflections.emplace_back();
      continue;
    }
    const Eliminated& part = linear.eliminated[pose];
    Eigen::VectorXd along = Eigen::VectorXd::Zero(part.half.cols() - 1);
    for (std::size_t i = 0; i < columns_[pose].unknowns.size(); ++i) {
      along[at(i)] = step[at(columns_[pose].unknowns[i])];
    }
    result.deflections.push_back(restingDeflections(part, along));
  }
  return result;
}

} // namespace naocal
