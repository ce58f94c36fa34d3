#include "calibrate/FloorError.hpp"
#include "math/LinearAlgebra.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

namespace naocal {

namespace {

/// The error with the legs as in one picture; absent where it sees no floor board or the point lies behind.
std::optional<double> errorIn(const Picture& picture, const Measurements& measurements, const Model& model,
                              const CalibrationResult& result) {
  const auto sighting = std::find_if(picture.sightings.begin(), picture.sightings.end(),
                                     [&](const Sighting& s) { return measurements.targets[s.view.board()].onFloor; });
  if (sighting == picture.sightings.end()) {
    return std::nullopt;
  }
  Belief belief = believed(measurements, model, picture, result.unknowns);
  const std::size_t board = sighting->view.board();
  belief.ground().setZero();
  belief.boardPlacement(board) << 2, 0, 0, 0, 0, 0;
  for (std::size_t joint : sighting->view.joints()) {
    const std::size_t link = measurements.robot.joints[joint].link;
    const std::size_t head = measurements.robot.cameras[picture.camera].link;
    const auto towardsHead = linksTowards(measurements.robot, {head});
    if (std::find(towardsHead.begin(), towardsHead.end(), link) != towardsHead.end()) {
      belief.angle(joint) = 0;
    }
  }
  Posture torsoFromLink;
  posture(measurements.robot, belief, sighting->view.links(), torsoFromLink);
  const Attitude attitude = sighting->view.attitude(measurements.robot, belief, torsoFromLink);
  const Eigen::Vector3d point = attitude.opticalFromBoard.translation;
  if (point.z() < 0.1) {
    return std::nullopt;
  }
  const std::vector<Slope> all = slopes(measurements, model, picture, result.unknowns);
  std::vector<std::size_t> quantities;
  std::vector<Slope> physical;
  for (const Slope& slope : all) {
    if (slope.quantity < measurements.quantities.lens()) {
      physical.push_back(slope);
      quantities.push_back(slope.quantity);
    }
  }
  Eigen::MatrixXd columns(6, at(quantities.size()));
  sighting->view.motion(measurements.robot, attitude, belief, torsoFromLink, quantities, {}, columns);
  const Eigen::Vector3d normal = attitude.opticalFromWorld.rotation.col(2);
  Eigen::MatrixXd slip = Eigen::MatrixXd::Zero(2, result.unknowns.size());
  for (std::size_t i = 0; i < physical.size(); ++i) {
    const Eigen::Vector3d omega = columns.col(at(i)).head<3>();
    const Eigen::Vector3d motion = omega.cross(point) + columns.col(at(i)).tail<3>();
    // the ray stays, the floor moved: where it meets the floor now, in the floor's own axes
    const Eigen::Vector3d shift = point * (motion.dot(normal) / point.dot(normal)) - motion;
    slip.col(at(physical[i].unknown)) +=
        physical[i].value * (attitude.opticalFromWorld.rotation.transpose() * shift).head<2>();
  }
  return std::sqrt((slip * result.covariance * slip.transpose()).trace());
}

} // namespace

double floorErrorAt2m(const Measurements& measurements, const Model& model, const CalibrationResult& result) {
  std::vector<double> errors;
  for (const Picture& picture : measurements.pictures) {
    if (const auto error = errorIn(picture, measurements, model, result)) {
      errors.push_back(*error);
    }
  }
  if (errors.empty()) {
    return 0;
  }
  std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2), errors.end());
  return errors[errors.size() / 2];
}

} // namespace naocal
