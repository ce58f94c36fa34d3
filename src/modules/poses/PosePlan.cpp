#include "poses/PosePlan.hpp"

#include "captures/InputError.hpp"
#include "poses/PlanRefinement.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <mutex>
#include <numeric>
#include <tbb/parallel_for.h>

namespace naocal {

namespace {

/// Works on a plan: poses and boards, judged together.
class Planner {
public:
  Planner(const Robot& robot, std::vector<Board> boards, const std::map<std::string, CameraIntrinsics>& cameras,
          const PlanOptions& options, const std::function<void(const std::string&)>& tell)
      : robot_{robot}, cameras_{cameras}, options_{options}, tell_{tell}, draft_{{}, std::move(boards)} {}

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
    chooseAndRefine(candidates.attitudes);
    bringIntoOrder(result);
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

  /// Refines what is drafted, and once more from what is then the best selection.
  void refine(PlanDraft& draft, std::vector<SievedPose> attitudes, std::uint64_t seed) {
    PlanRefinement refinement{robot_, cameras_, options_, options_.poses.seed + seed};
    for (const bool again : {false, true}) {
      if (again) {
        attitudes.insert(attitudes.end(), draft.poses.begin(), draft.poses.end());
        draft.poses = PlanScore{robot_, draft.boards, cameras_, options_}.best(attitudes, options_.poses.count);
      }
      refinement.refinePoses(draft);
      if (options_.moveBoards) {
        refinement.refineBoards(draft);
      }
    }
    const std::lock_guard lock{telling_};
    tell_(fmt::format("refined: the worst offset's sigma is {:.4f} deg", worst(draft)));
  }

  double value(const PlanDraft& draft) const {
    const PlanScore here{robot_, draft.boards, cameras_, options_};
    return here.judge()(here.sum(draft.poses));
  }

  double worst(const PlanDraft& draft) const { // [deg]
    double result = 0;
    const PlanScore here{robot_, draft.boards, cameras_, options_};
    for (const auto& [joint, sigma] : here.sigmas(draft.poses, options_.known)) {
      result = std::max(result, degrees(sigma));
    }
    return result;
  }

  /// The quickest safe order; as they were selected where there is none.
  void bringIntoOrder(PosePlan& result) {
    const PlanScore here = score();
    const std::size_t count = draft_.poses.size();
    std::vector<std::optional<PoseWay>> ways(count * count);
    tbb::parallel_for(std::size_t{0}, count * count, [&](std::size_t i) {
      ways[i] = safeWay(robot_, here.scene(), options_.poses, draft_.poses[i / count], draft_.poses[i % count]);
    });
    std::vector<std::vector<std::optional<double>>> seconds(count, std::vector<std::optional<double>>(count));
    for (std::size_t i = 0; i < count * count; ++i) {
      if (ways[i]) {
        seconds[i / count][i % count] = ways[i]->seconds;
      }
    }
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    order = quickestOrder(seconds).value_or(order);
    std::vector<SievedPose> ordered;
    for (std::size_t i = 0; i < count; ++i) {
      ordered.push_back(draft_.poses[order[i]]);
      result.ways.push_back(i == 0 ? std::nullopt : ways[order[i - 1] * count + order[i]]);
    }
    draft_.poses = std::move(ordered);
  }

  void describe(PosePlan& result) const {
    const PlanScore here = score();
    const auto joints = static_cast<Eigen::Index>(robot_.joints.size());
    for (const SievedPose& attitude : draft_.poses) {
      Belief belief = here.scene().drawn();
      belief.values.head(joints) = attitude.belief.values.head(joints);
      result.poses.push_back({{options_.poses.supportFoot, belief.values.head(joints),
                               here.scene().sights(belief, posture(robot_, belief))},
                              Eigen::VectorXd::Zero(joints)});
      result.standing.push_back(attitude.standing);
    }
    result.supportFoot = options_.poses.supportFoot;
    result.boards = draft_.boards;
    result.sigma = here.sigmas(draft_.poses, false);
    result.sigmaKnown = here.sigmas(draft_.poses, true);
    result.sigmaOfRobots = here.sigmasOfRobots(draft_.poses);
    result.interaction = here.interaction(draft_.poses);
    result.options = options_;
  }

  const Robot& robot_;
  const std::map<std::string, CameraIntrinsics>& cameras_;
  const PlanOptions& options_;
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
