#pragma once

#include "robot/Robot.hpp"

#include <Eigen/Core>
#include <optional>

namespace naocal {

/// Numbers of things beside boards that have quantities of their own.
struct SceneCounts {
  std::size_t trackers = 0, markers = 0, frames = 0, places = 0;
  bool hasLinkSteps = false; // whether the fixed steps between links are quantities
};

/// Index of each quantity in the flat vector of a `ModelState`.
class StateLayout {
public:
  StateLayout(std::size_t jointCount, std::size_t lengthCount, std::size_t boardCount, const SceneCounts& scene = {})
      : joints_{jointCount}, lengths_{lengthCount}, boards_{boardCount}, scene_{scene} {}

  std::size_t angle(std::size_t joint) const { return joint; }                // [rad]
  std::size_t axis(std::size_t joint) const { return joints_ + 3 * joint; }   // 3 components
  std::size_t length(std::size_t index) const { return 4 * joints_ + index; } // [m]
  std::size_t mountTranslation() const { return 4 * joints_ + lengths_; }     // x, y, z [m] in the mount's link
  std::size_t mountRotation() const { return mountTranslation() + 3; }        // rx, ry, rz [rad] relative to nominal
  std::size_t lens() const { return mountRotation() + 3; }                    // fx, fy, cx, cy, k1, k2, p1, p2, k3
  std::size_t rowTime() const { return lens() + 9; }                          // time between rows of the picture [s]
  std::size_t imuTilt() const { return rowTime() + 1; }                       // roll, pitch of the IMU [rad]
  std::size_t worldFromSupport() const { return imuTilt() + 2; }              // worldFromSole, as a Placement
  std::size_t board(std::size_t index) const { return worldFromSupport() + 6 + 8 * index; } // Placement, scale, bow [m]
  std::size_t tracker(std::size_t index) const { return board(boards_) + 7 * index; }       // Placement, scale
  std::size_t marker(std::size_t index) const { return tracker(scene_.trackers) + 3 * index; } // x, y, z [m]
  std::size_t frame(std::size_t index) const { return marker(scene_.markers) + 6 * index; }    // Placement
  std::size_t place(std::size_t index) const { return frame(scene_.frames) + 3 * index; }      // x, y, z [m]
  std::size_t linkStep(std::size_t joint) const { return place(scene_.places) + 6 * joint; }   // x, y, z, rx, ry, rz
  std::size_t size() const { return linkStep(scene_.hasLinkSteps ? joints_ : 0); }

  /// Joint whose link step a quantity is, if it is one.
  std::optional<std::size_t> jointOfStep(std::size_t quantity) const {
    return quantity >= linkStep(0) ? std::optional{(quantity - linkStep(0)) / 6} : std::nullopt;
  }
  /// Board whose placement or shape a quantity is, if it is one.
  std::optional<std::size_t> boardOf(std::size_t quantity) const {
    return quantity >= board(0) && quantity < tracker(0) ? std::optional{(quantity - board(0)) / 8} : std::nullopt;
  }
  /// Whether a quantity belongs to a tracker, marker, frame or place.
  bool isOfInstrument(std::size_t quantity) const { return quantity >= tracker(0) && quantity < linkStep(0); }

  std::size_t jointCount() const { return joints_; }
  std::size_t lengthCount() const { return lengths_; }
  std::size_t boardCount() const { return boards_; }
  const SceneCounts& scene() const { return scene_; }

private:
  std::size_t joints_, lengths_, boards_;
  SceneCounts scene_;
};

/// State of robot and scene at one instant, for one camera: plain numbers that effects correct.
///
/// The derivative of the picture with respect to each of them is analytic (camera/ObservationChain.hpp).
class ModelState {
public:
  explicit ModelState(const StateLayout& quantities)
      : values{Eigen::VectorXd::Zero(static_cast<Eigen::Index>(quantities.size()))}, quantities_{quantities} {}

  double& angle(std::size_t joint) { return at(quantities_.angle(joint)); }
  double angle(std::size_t joint) const { return at(quantities_.angle(joint)); }
  auto axis(std::size_t joint) { return segment3(quantities_.axis(joint)); }
  auto axis(std::size_t joint) const { return segment3(quantities_.axis(joint)); }
  double& length(std::size_t index) { return at(quantities_.length(index)); }
  double length(std::size_t index) const { return at(quantities_.length(index)); }
  auto mountTranslation() { return segment3(quantities_.mountTranslation()); }
  auto mountTranslation() const { return segment3(quantities_.mountTranslation()); }
  auto mountRotation() { return segment3(quantities_.mountRotation()); }
  auto mountRotation() const { return segment3(quantities_.mountRotation()); }
  auto lens() { return values.segment<9>(static_cast<Eigen::Index>(quantities_.lens())); }
  auto lens() const { return values.segment<9>(static_cast<Eigen::Index>(quantities_.lens())); }
  double& rowTime() { return at(quantities_.rowTime()); }
  double rowTime() const { return at(quantities_.rowTime()); }
  auto imuTilt() { return values.segment<2>(static_cast<Eigen::Index>(quantities_.imuTilt())); }
  auto imuTilt() const { return values.segment<2>(static_cast<Eigen::Index>(quantities_.imuTilt())); }
  /// worldFromSole of the support foot: x, y, z [m], roll, pitch, yaw [rad].
  auto worldFromSupport() { return segment6(quantities_.worldFromSupport()); }
  auto worldFromSupport() const { return segment6(quantities_.worldFromSupport()); }
  /// linkFromBoard (worldFromBoard for a floor board): x, y, z [m], roll, pitch, yaw [rad].
  auto boardPlacement(std::size_t board) { return segment6(quantities_.board(board)); }
  auto boardPlacement(std::size_t board) const { return segment6(quantities_.board(board)); }
  double& boardScale(std::size_t board) { return at(quantities_.board(board) + 6); }
  double boardScale(std::size_t board) const { return at(quantities_.board(board) + 6); }
  double& boardBow(std::size_t board) { return at(quantities_.board(board) + 7); }
  double boardBow(std::size_t board) const { return at(quantities_.board(board) + 7); }
  /// worldFromTracker against its reference: x, y, z [m], roll, pitch, yaw [rad]; and scale - 1 of its readings.
  auto trackerPlacement(std::size_t tracker) { return segment6(quantities_.tracker(tracker)); }
  auto trackerPlacement(std::size_t tracker) const { return segment6(quantities_.tracker(tracker)); }
  double& trackerScale(std::size_t tracker) { return at(quantities_.tracker(tracker) + 6); }
  double trackerScale(std::size_t tracker) const { return at(quantities_.tracker(tracker) + 6); }
  /// A marker in its link [m].
  auto marker(std::size_t marker) { return segment3(quantities_.marker(marker)); }
  auto marker(std::size_t marker) const { return segment3(quantities_.marker(marker)); }
  /// linkFromFrame against its reference.
  auto framePlacement(std::size_t frame) { return segment6(quantities_.frame(frame)); }
  auto framePlacement(std::size_t frame) const { return segment6(quantities_.frame(frame)); }
  /// A place in the world [m].
  auto place(std::size_t place) { return segment3(quantities_.place(place)); }
  auto place(std::size_t place) const { return segment3(quantities_.place(place)); }
  /// Deviation of the fixed step to a joint: parentFromJoint * T(x, y, z) * Rx(rx) * Ry(ry) * Rz(rz).
  auto linkStep(std::size_t joint) { return segment6(quantities_.linkStep(joint)); }
  auto linkStep(std::size_t joint) const { return segment6(quantities_.linkStep(joint)); }

  const StateLayout& layout() const { return quantities_; }

  Eigen::VectorXd values;

private:
  double& at(std::size_t i) { return values[static_cast<Eigen::Index>(i)]; }
  double at(std::size_t i) const { return values[static_cast<Eigen::Index>(i)]; }
  Eigen::VectorXd::FixedSegmentReturnType<3>::Type segment3(std::size_t i) {
    return values.segment<3>(static_cast<Eigen::Index>(i));
  }
  Eigen::VectorXd::ConstFixedSegmentReturnType<3>::Type segment3(std::size_t i) const {
    return values.segment<3>(static_cast<Eigen::Index>(i));
  }
  Eigen::VectorXd::FixedSegmentReturnType<6>::Type segment6(std::size_t i) {
    return values.segment<6>(static_cast<Eigen::Index>(i));
  }
  Eigen::VectorXd::ConstFixedSegmentReturnType<6>::Type segment6(std::size_t i) const {
    return values.segment<6>(static_cast<Eigen::Index>(i));
  }

  StateLayout quantities_;
};

/// Nominal robot: all angles zero, nominal camera mount, boards at the origins of their frames.
ModelState nominalState(const Robot& robot, const StateLayout& quantities);

/// Sets every joint to its `Joint::restAngle`, or to the nearest angle within its limits.
void moveToRest(const Robot& robot, ModelState& modelState);

} // namespace naocal
