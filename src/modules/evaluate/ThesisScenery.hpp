#pragma once

#include "evaluate/ThesisCell.hpp"
#include "poses/Scene.hpp"
#include "residuals/Measurements.hpp"

namespace naocal {

/// What lies on the floor, its placements in the left sole's frame, and when a camera sees it.
struct ThesisScenery {
  std::vector<Board> targets;
  std::map<std::string, CameraIntrinsics> cameras;
  SightLimits limits;
};

/// Boards: the four A2 boards of simulated sets. Grid: points every 0.25 m up to 4 m away, in tiles of one square metre
/// that are told apart by correspondence; a single point of a tile is seen as well.
ThesisScenery thesisScenery(ThesisFeature feature);

/// How a robot stands, its angles per joint [rad].
struct ThesisPose {
  SupportFoot foot = SupportFoot::left;
  Eigen::VectorXd angles;
};

/// What there is to see in the poses: all of it, in pictures by each camera, as often as the setting has samples.
Measurements everythingInSight(const Robot& robot, const ThesisScenery& scenery, const ThesisSetting& setting,
                               const std::vector<ThesisPose>& poses);

} // namespace naocal
