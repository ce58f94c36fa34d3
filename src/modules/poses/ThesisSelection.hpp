#pragma once

#include "poses/FloorSensor.hpp"
#include "poses/Interaction.hpp"
#include "poses/RandomAttitude.hpp"

namespace naocal {

/// The thesis's way to select poses, by what looks alike to the cameras over the floor.
class ThesisSelection {
public:
  /// `joints`: motors whose turns are to be told apart; `weights`: of joints and cameras by name, 1 where it has none.
  ThesisSelection(const Robot& robot, const Sole& support, const std::map<std::string, CameraIntrinsics>& cameras,
                  const std::vector<std::size_t>& joints, const std::map<std::string, double>& weights);

  Interaction interaction(const std::vector<SievedPose>& poses) const;
  /// InteractionJudge::chain.
  std::vector<std::size_t> chain(const std::vector<SievedPose>& poses, std::size_t count) const;

private:
  std::vector<Eigen::ArrayXd> interactions(const std::vector<SievedPose>& poses) const;

  FloorSensor sensor_;
  InteractionJudge judge_;
  Eigen::Index angles_; // per pose
};

} // namespace naocal
