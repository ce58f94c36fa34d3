#pragma once

#include "evaluate/ThesisCell.hpp"
#include "poses/Scene.hpp"

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

/// As many stable poses as wanted, in each of which all of 40 robots drawn with offsets up to 6.5 degrees see enough
/// (24 corners), chosen one by one: each the one that, on average over such robots, tells most about the offsets beside
/// those before it (largest determinant; corners within 0.3 px, an encoder's noise marginalised). The first three are
/// the poses for three. Throws InputError when there are not that many.
std::vector<Eigen::VectorXd> thesisPoses(const Robot& robot, ThesisFeature feature, std::size_t count);

} // namespace naocal
