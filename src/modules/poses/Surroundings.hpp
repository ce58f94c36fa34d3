#pragma once

#include "residuals/Model.hpp"

#include <vector>

namespace naocal {

/// Where a robot stood last and what lies around it, by a fit: where it would take further poses.
struct Surroundings {
  SupportFoot supportFoot = SupportFoot::left;
  Placement sole;            // in the fit's world
  std::vector<Board> boards; // on the floor, seen in the last set; placements in the sole's frame
};

/// One for each foot that the last set stands on (of both feet, the left one); none where no board lies on the floor.
std::vector<Surroundings> surroundings(const std::vector<CaptureSet>& sets, const Measurements& measurements,
                                       const Model& model, const Eigen::VectorXd& unknowns);

} // namespace naocal
