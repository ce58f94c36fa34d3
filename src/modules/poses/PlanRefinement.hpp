#pragma once

#include "poses/PlanScore.hpp"

namespace naocal {

/// What is being planned: poses, and boards in the support sole's frame.
struct PlanDraft {
  std::vector<SievedPose> poses;
  std::vector<Board> boards;
};

/// Moves what is drafted a little, again and again, ever less, as long as that is judged better.
class PlanRefinement {
public:
  PlanRefinement(const Robot& robot, const std::map<std::string, CameraIntrinsics>& cameras, const PlanOptions& options,
                 std::uint64_t seed)
      : robot_{robot}, cameras_{cameras}, options_{options}, random_{seed} {}

  /// Each pose in turn, within the ranges that poses are drawn from; it remains valid.
  void refinePoses(PlanDraft& draft);
  /// Each board in turn; it remains where a board may lie, and every pose sees one.
  void refineBoards(PlanDraft& draft);

private:
  double value(const PlanDraft& draft) const;
  double step(std::size_t attempt, std::size_t attempts);

  const Robot& robot_;
  const std::map<std::string, CameraIntrinsics>& cameras_;
  const PlanOptions& options_;
  std::mt19937_64 random_;
};

} // namespace naocal
