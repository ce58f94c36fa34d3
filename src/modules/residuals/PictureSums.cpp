#include "residuals/ResidualsParts.hpp"

namespace naocal {

namespace {
Eigen::Index at(std::size_t i) {
  return static_cast<Eigen::Index>(i);
}
} // namespace

/// Sums over the corners of all boards in a picture, per quantity. False: a corner is nowhere.
bool Residuals::addSightings(const Picture& picture, const Prepared& prepared, const Belief& belief, Workspace& work,
                             PoseSystem& system) const {
  const Robot& robot = measurements_.robot;
  const Eigen::Index slots = at(prepared.quantities.size());
  for (std::size_t i = 0; i < picture.sightings.size(); ++i) {
    const Sighting& sighting = picture.sightings[i];
    const std::vector<std::size_t>& extras = prepared.extras[i];
    const Attitude attitude = sighting.view.attitude(robot, belief, work.torsoFromLink);
    if (!sighting.view.project(attitude, belief, sighting.corners, work.projected)) {
      return false;
    }
    work.extraRows.resize(2 * extras.size() * sighting.corners.size());
    for (std::size_t e = 0, row = 0; e < extras.size(); ++e) {
      for (std::size_t block = 0; block < sighting.corners.size(); ++block, row += 2) {
        View::extraRows(extras[e], attitude, belief, sighting.corners[block], work.projected[block],
                        work.extraRows[row], work.extraRows[row + 1]);
      }
    }
    sumUp(sighting.corners, work.projected, work.extraRows, extras.size(), noise_.pixel, loss_, work.sums);
    work.columns.resize(at(6 + extras.size()), slots);
    sighting.view.motion(robot, attitude, belief, work.torsoFromLink, prepared.quantities, extras, work.columns);
    work.gram.noalias() += work.columns.transpose() * (work.sums.gram * work.columns);
    work.gradient.noalias() += work.columns.transpose() * work.sums.gradient;
    work.cost += work.sums.cost;
    system.squares += work.sums.squares;
    system.numbers += 2 * work.sums.corners;
  }
  return true;
}

/// The other sole's height over the floor and its tilt are zero but for `FloorContact`; in units of pixels, as all sums
/// are.
///   height = -n . t, d(height) = -n . v;  n = the floor's normal in the sole, d(n) = omega x n
void Residuals::addFloorContact(const Picture& picture, const Prepared& prepared, const Belief& belief, Workspace& work,
                                PoseSystem& system) const {
  const Attitude attitude = picture.otherSole->attitude(measurements_.robot, belief, work.torsoFromLink);
  const Eigen::Vector3d normal = attitude.opticalFromWorld.rotation.col(2);
  work.columns.resize(6, at(prepared.quantities.size()));
  picture.otherSole->motion(measurements_.robot, attitude, belief, work.torsoFromLink, prepared.quantities, {},
                            work.columns);
  const Eigen::Vector3d scale =
      noise_.pixel * Eigen::Vector3d{1 / FloorContact::height, 1 / FloorContact::tilt, 1 / FloorContact::tilt};
  Eigen::Matrix<double, 3, 6> byMotion = Eigen::Matrix<double, 3, 6>::Zero();
  byMotion.row(0).tail<3>() = -normal.transpose();
  byMotion.bottomLeftCorner<2, 3>() = -crossMatrix(normal).topRows<2>();
  const Eigen::Vector3d residual =
      scale.cwiseProduct(Eigen::Vector3d{-normal.dot(attitude.opticalFromWorld.translation), normal.x(), normal.y()});
  const Eigen::MatrixXd rows = scale.asDiagonal() * (byMotion * work.columns);
  work.gram.noalias() += rows.transpose() * rows;
  work.gradient.noalias() += rows.transpose() * residual;
  work.cost += residual.squaredNorm() / (noise_.pixel * noise_.pixel);
  system.squares += residual.squaredNorm();
  system.numbers += 3;
}

/// Adds one picture's sums to its pose's, its quantities mapped to unknowns and deflections. False: a corner is
/// nowhere.
bool Residuals::addPicture(const Picture& picture, const Prepared& prepared, const Belief& belief,
                           const Reading& reading, std::size_t pose, Workspace& work, PoseSystem& system) const {
  const Eigen::Index slots = at(prepared.quantities.size());
  posture(measurements_.robot, belief, prepared.links, work.torsoFromLink);
  work.gram.setZero(slots, slots);
  work.gradient.setZero(slots);
  if (!addSightings(picture, prepared, belief, work, system)) {
    return false;
  }
  if (picture.otherSole) {
    addFloorContact(picture, prepared, belief, work, system);
  }
  for (const Prepared::Entry& a : prepared.entries) {
    if (a.slot < 0) {
      continue;
    }
    system.unknownGradient[a.local] += a.value * work.gradient[a.slot];
    for (const Prepared::Entry& b : prepared.entries) {
      if (b.slot >= 0) {
        system.unknownGram(a.local, b.local) += a.value * b.value * work.gram(a.slot, b.slot);
      }
    }
  }
  for (std::size_t j = 0; j < prepared.joints.size(); ++j) {
    const int deflection = deflection_[pose][reading.encoderError[prepared.joints[j]]];
    if (deflection < 0) {
      continue;
    }
    system.deflectionGradient[deflection] += work.gradient[at(j)];
    for (const Prepared::Entry& a : prepared.entries) {
      if (a.slot >= 0) {
        system.cross(a.local, deflection) += a.value * work.gram(a.slot, at(j));
      }
    }
    for (std::size_t k = 0; k < prepared.joints.size(); ++k) {
      const int other = deflection_[pose][reading.encoderError[prepared.joints[k]]];
      system.deflectionGram(deflection, other) += work.gram(at(j), at(k));
    }
  }
  return true;
}

} // namespace naocal
