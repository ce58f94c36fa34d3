#include "poses/PosePlan.hpp"

#include "captures/InputError.hpp"
#include "poses/BoardPlaces.hpp"
#include "poses/Mirror.hpp"
#include "poses/MirroredPlan.hpp"
#include "poses/PlanRefinement.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <mutex>
#include <tbb/parallel_for.h>

namespace naocal {

namespace {

/// Works on a plan: poses and boards, judged together.
class Planner {
public:
  Planner(const Robot& robot, std::vector<Board> boards, const std::map<std::string, CameraIntrinsics>& cameras,
          const PlanOptions& options, const std::function<void(const std::string&)>& tell)
      : robot_{robot}, cameras_{cameras}, options_{options}, tell_{tell}, draft_{{}, std::move(boards)} {
    if (options_.mirrored) {
      const MirroredBoards mirror{draft_.boards, middleBetweenFeet(options_.poses.supportFoot)};
      for (std::size_t board = 0; board < draft_.boards.size(); ++board) {
        mirror.follow(draft_.boards, board);
      }
    }
  }

  PosePlan plan() {
    PosePlan result;
    tell_(fmt::format("sieving {} attitudes", options_.poses.tries));
    PoseCandidates candidates = poseCandidates(robot_, score().scene(), options_.poses);
    if (candidates.attitudes.size() < options_.poses.count) {
      throw InputError{fmt::format("expected {} stable poses that see a board, found {} among {} attitudes; put the "
                                   "boards nearer, try more candidates or ask for fewer poses",
                                   options_.poses.count, candidates.attitudes.size(), options_.poses.tries)};
    }
    if (options_.compare) {
      tell_("comparing what the criteria select");
      result.comparison = compareCriteria(robot_, draft_.boards, cameras_, options_, candidates.attitudes);
    }
    if (options_.criterion == Criterion::time) {
      chooseQuickest(candidates.attitudes);
    } else {
      chooseAndRefine(candidates.attitudes);
    }
    describe(result);
    result.sieve = candidates.sieve;
    return result;
  }

private:
  PlanScore score() const { return score(options_); }
  PlanScore score(const PlanOptions& options) const { return {robot_, draft_.boards, cameras_, options}; }

  void chooseAndRefine(const std::vector<SievedPose>& attitudes) {
    if (options_.criterion == Criterion::interaction) { // as the thesis has it: selected, not refined
      draft_.poses = score().best(attitudes, options_.poses.count);
      return;
    }
    std::vector<PlanDraft> drafts(options_.starts, draft_);
    tbb::parallel_for(std::size_t{0}, drafts.size(), [&](std::size_t i) {
      PlanOptions beginning = options_;
      beginning.criterion = static_cast<Criterion>(i % static_cast<std::size_t>(Criterion::interaction));
      drafts[i].poses = score(beginning).best(attitudes, options_.poses.count);
      refine(drafts[i], attitudes, i);
    });
    const auto better = [this](const PlanDraft& one, const PlanDraft& other) { return value(one) < value(other); };
    draft_ = *std::min_element(drafts.begin(), drafts.end(), better);
    for (std::size_t round = 1; round < options_.rounds; ++round) {
      refine(draft_, attitudes, options_.starts + round);
    }
  }

  /// As few poses as reach the sigma, and more as long as that saves time.
  void chooseQuickest(const std::vector<SievedPose>& attitudes) {
    constexpr double reached = 1e5; // [s]
    const std::size_t most = options_.poses.count;
    PlanDraft best;
    double least = std::numeric_limits<double>::infinity();
    for (options_.poses.count = 2; options_.poses.count <= most; ++options_.poses.count) {
      PlanDraft draft{score().best(attitudes, options_.poses.count), draft_.boards};
      refine(draft, attitudes, options_.poses.count);
      const double there = value(draft);
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
          fmt::format("expected at most {} poses to tell every offset to {:.3f} degrees, found {:.3f}; ask "
                      "for more poses or less",
                      most, degrees(options_.sigma), worst(best))};
    }
    draft_ = std::move(best);
    options_.poses.count = draft_.poses.size();
  }

  /// Refines what is drafted, and once more from what is then the best selection.
  void refine(PlanDraft& draft, std::vector<SievedPose> attitudes, std::uint64_t seed) {
    PlanRefinement refinement{robot_, cameras_, options_, options_.poses.seed + seed};
    for (const bool again : {false, true}) {
      if (again && options_.criterion != Criterion::time) {
        attitudes.insert(attitudes.end(), draft.poses.begin(), draft.poses.end());
        draft.poses = PlanScore{robot_, draft.boards, cameras_, options_}.best(attitudes, options_.poses.count);
      }
      refinement.refinePoses(draft);
      if (options_.moveBoards) {
        refinement.refineBoards(draft);
      }
    }
    const std::string found =
        fmt::format("refined {} poses: the worst offset's sigma is {:.4f} deg", draft.poses.size(), worst(draft));
    const std::lock_guard lock{telling_};
    tell_(found);
  }

  double value(const PlanDraft& draft) const {
    const PlanScore here{robot_, draft.boards, cameras_, options_};
    return here.value(here.sum(draft.poses), draft.poses);
  }

  double worst(const PlanDraft& draft) const { // [deg]
    const PlanScore here{robot_, draft.boards, cameras_, options_};
    return degrees(here.worstSigma(here.sum(draft.poses)));
  }

  void describe(PosePlan& result) {
    const PlanScore here = score();
    PosesInOrder ordered = inOrder(robot_, here.scene(), options_.poses, std::move(draft_.poses));
    draft_.poses = std::move(ordered.poses);
    result.ways = std::move(ordered.ways);
    result.supportFoot = options_.poses.supportFoot;
    result.boards = draft_.boards;
    result.sigma = here.sigmas(draft_.poses, false);
    result.sigmaKnown = here.sigmas(draft_.poses, true);
    result.sigmaOfRobots = here.sigmasOfRobots(draft_.poses);
    result.interaction = here.interaction(draft_.poses);
    result.tolerances = boardTolerances(robot_, draft_.boards, cameras_, options_, draft_.poses);
    result.kept = options_.kept.size();
    std::vector<SievedPose> all = here.kept();
    all.insert(all.end(), draft_.poses.begin(), draft_.poses.end());
    result.ways.insert(result.ways.begin(), result.kept, std::nullopt);
    const auto joints = static_cast<Eigen::Index>(robot_.joints.size());
    for (const SievedPose& attitude : all) {
      Belief belief = here.scene().drawn();
      belief.values.head(joints) = attitude.belief.values.head(joints);
      result.poses.push_back({{options_.poses.supportFoot, belief.values.head(joints),
                               here.scene().sights(belief, posture(robot_, belief))},
                              Eigen::VectorXd::Zero(joints)});
      result.standing.push_back(attitude.standing);
    }
    result.options = options_;
    if (options_.mirrored) {
      addMirrored(result, robot_, cameras_);
    }
  }

  const Robot& robot_;
  const std::map<std::string, CameraIntrinsics>& cameras_;
  PlanOptions options_;
  const std::function<void(const std::string&)>& tell_;
  PlanDraft draft_;
  std::mutex telling_;
};

} // namespace

PosePlan posePlan(const Robot& robot, std::vector<Board> boards, const std::map<std::string, CameraIntrinsics>& cameras,
                  const PlanOptions& options, const std::function<void(const std::string&)>& tell) {
  const std::function<void(const std::string&)> quietly = [](const std::string&) {};
  return Planner{robot, std::move(boards), cameras, options, tell ? tell : quietly}.plan();
}

} // namespace naocal
