#include "poses/PlanSearch.hpp"

#include "io/InputError.hpp"
#include "math/Parallel.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace naocal {

namespace {

PlanOptions ofDrawnRobot(PlanOptions options) {
  options.wornRobots = 0;
  return options;
}

} // namespace

PlanDraft PlanSearch::found(const std::vector<Board>& boards, const std::vector<SievedPose>& attitudes) {
  if (options_.criterion == Criterion::time) {
    return quickest(boards, attitudes);
  }
  if (options_.criterion == Criterion::interaction || options_.criterion == Criterion::discriminate) {
    return {PlanScore{robot_, boards, cameras_, options_}.best(attitudes, options_.poses.count), boards};
  }
  return refinedFromStarts(boards, attitudes);
}

/// Selected for worn robots too, first refined for the drawn one: refining for worn ones takes many times as long.
PlanDraft PlanSearch::refinedFromStarts(const std::vector<Board>& boards, const std::vector<SievedPose>& attitudes) {
  const PlanOptions drawn = ofDrawnRobot(options_);
  std::vector<PlanDraft> drafts(options_.starts, PlanDraft{{}, boards});
  inParallel(drafts.size(), [&](std::size_t i) {
    PlanOptions beginning = options_;
    beginning.criterion = static_cast<Criterion>(i % static_cast<std::size_t>(Criterion::interaction));
    drafts[i].poses = PlanScore{robot_, boards, cameras_, beginning}.best(attitudes, options_.poses.count);
    refine(drafts[i], attitudes, drawn, i);
  });
  PlanDraft best = *std::min_element(drafts.begin(), drafts.end(), [&](const PlanDraft& one, const PlanDraft& other) {
    return value(one, options_) < value(other, options_);
  });
  for (std::size_t round = 1; round < options_.rounds; ++round) {
    refine(best, attitudes, options_, options_.starts + round);
  }
  return best;
}

PlanDraft PlanSearch::quickest(const std::vector<Board>& boards, const std::vector<SievedPose>& attitudes) {
  constexpr double reached = 1e5; // [s]
  PlanOptions options = ofDrawnRobot(options_);
  PlanDraft best;
  double least = std::numeric_limits<double>::infinity();
  for (options.poses.count = 2; options.poses.count <= options_.poses.count; ++options.poses.count) {
    PlanDraft draft{PlanScore{robot_, boards, cameras_, options}.best(attitudes, options.poses.count), boards};
    refine(draft, attitudes, options, options.poses.count);
    const double there = value(draft, options);
    if (there > least && least < reached) {
      break;
    }
    if (there < least) {
      least = there;
      best = std::move(draft);
    }
  }
  if (least > reached) {
    throw InputError{
        fmt::format("expected at most {} poses to tell every offset to {:.3f} degrees, found {:.3f}; ask for more "
                    "poses or less",
                    options_.poses.count, degrees(options_.sigma), worst(best))};
  }
  return best;
}

/// Refines what is drafted, and once more from what is then the best selection.
void PlanSearch::refine(PlanDraft& draft, std::vector<SievedPose> attitudes, const PlanOptions& options,
                        std::uint64_t seed) {
  PlanRefinement refinement{robot_, cameras_, options, options.poses.seed + seed};
  for (const bool again : {false, true}) {
    if (again && options.criterion != Criterion::time) {
      attitudes.insert(attitudes.end(), draft.poses.begin(), draft.poses.end());
      draft.poses = PlanScore{robot_, draft.boards, cameras_, options}.best(attitudes, options.poses.count);
    }
    refinement.refinePoses(draft);
    if (options.moveBoards) {
      refinement.refineBoards(draft);
    }
  }
  const std::string found =
      fmt::format("refined {} poses: the worst offset's sigma is {:.4f} deg", draft.poses.size(), worst(draft));
  const std::lock_guard lock{telling_};
  tell_(found);
}

double PlanSearch::value(const PlanDraft& draft, const PlanOptions& options) const {
  const PlanScore here{robot_, draft.boards, cameras_, options};
  return here.value(here.sum(draft.poses), draft.poses);
}

double PlanSearch::worst(const PlanDraft& draft) const { // [deg]
  const PlanScore here{robot_, draft.boards, cameras_, options_};
  return degrees(here.worstSigma(here.sum(draft.poses)));
}

} // namespace naocal
