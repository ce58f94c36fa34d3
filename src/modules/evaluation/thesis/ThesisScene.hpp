#pragma once

#include "data/Capture.hpp"
#include "evaluation/thesis/ThesisProgram.hpp"
#include "evaluation/thesis/ThesisSetting.hpp"
#include "poses/candidates/PlanningScene.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace naocal {

/// Targets on the floor, placements in the left sole's frame, and visibility limits.
struct ThesisScene {
  std::vector<Board> targets;
  std::map<std::string, CameraIntrinsics> cameras;
  VisibilityLimits limits;
  bool hasHorizonTest = false; // pictures need to pass passesHorizonTest
};

/// The scene of a feature; `patterns`: of ThesisFeature::file. Boards: the four A2 boards of simulated sets. Grid:
/// points every 0.25 m up to 4 m away, in tiles of one square metre with known correspondence; single points of a tile
/// are visible too.
ThesisScene makeThesisScene(ThesisFeature feature, const std::vector<FloorPattern>& patterns);

/// Floor points as the thesis's program sees them: by the bottom camera, if the picture passes the horizon test, and
/// wherever they lie in the image.
ThesisScene makeProgramScene(const std::vector<FloorPattern>& patterns);

/// Number of coinciding points of a feature.
std::size_t copiesOf(ThesisFeature feature);

} // namespace naocal
