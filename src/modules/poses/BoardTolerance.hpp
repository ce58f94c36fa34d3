#pragma once

#include "poses/PlanScore.hpp"

namespace naocal {

/// How far a board may be off its place, the others at theirs, before a pose sees no board any more or the worst
/// offset's sigma grows by a tenth.
struct BoardTolerance {
  double shift = 0; // in any of eight directions [m], at most 0.3
  double turn = 0;  // either way [rad], at most 45 degrees
};

/// Per board.
std::vector<BoardTolerance> boardTolerances(const Robot& robot, const std::vector<Board>& boards,
                                            const std::map<std::string, CameraIntrinsics>& cameras,
                                            const PlanOptions& options, const std::vector<SievedPose>& poses);

} // namespace naocal
