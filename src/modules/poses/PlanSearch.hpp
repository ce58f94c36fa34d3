#pragma once

#include "poses/PlanRefinement.hpp"

#include <functional>
#include <mutex>

namespace naocal {

/// Searches the poses among candidates, and the boards' places, that a plan's criterion judges best.
class PlanSearch {
public:
  /// `tell`: what was found on the way, for people.
  PlanSearch(const Robot& robot, const std::map<std::string, CameraIntrinsics>& cameras, const PlanOptions& options,
             const std::function<void(const std::string&)>& tell)
      : robot_{robot}, cameras_{cameras}, options_{options}, tell_{tell} {}

  /// Begins with the boards where they are. The thesis's criterion and `discriminate` select only; `time` takes as few
  /// poses as reach its sigma, and more as long as that saves time (InputError where there are none); all others begin
  /// PlanOptions::starts times, refine, and go on with the best.
  PlanDraft found(const std::vector<Board>& boards, const std::vector<SievedPose>& attitudes);

private:
  PlanDraft refinedFromStarts(const std::vector<Board>& boards, const std::vector<SievedPose>& attitudes);
  PlanDraft quickest(const std::vector<Board>& boards, const std::vector<SievedPose>& attitudes);
  void refine(PlanDraft& draft, std::vector<SievedPose> attitudes, const PlanOptions& options, std::uint64_t seed);
  double value(const PlanDraft& draft, const PlanOptions& options) const;
  double worst(const PlanDraft& draft) const;

  const Robot& robot_;
  const std::map<std::string, CameraIntrinsics>& cameras_;
  const PlanOptions& options_;
  const std::function<void(const std::string&)>& tell_;
  std::mutex telling_;
};

} // namespace naocal
