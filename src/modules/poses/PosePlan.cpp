#include "poses/PosePlan.hpp"

#include "io/InputError.hpp"
#include "poses/BoardPlaces.hpp"
#include "poses/Mirror.hpp"
#include "poses/MirroredPlan.hpp"
#include "poses/PlanSearch.hpp"

#include <fmt/format.h>

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
    thin(candidates.attitudes);
    if (options_.compare) {
      tell_("comparing what the criteria select");
      result.comparison = compareCriteria(robot_, draft_.boards, cameras_, options_, candidates.attitudes);
    }
    draft_ = PlanSearch{robot_, cameras_, options_, tell_}.found(draft_.boards, candidates.attitudes);
    options_.poses.count = draft_.poses.size();
    describe(result);
    result.sieve = candidates.sieve;
    return result;
  }

private:
  PlanScore score() const { return {robot_, draft_.boards, cameras_, options_}; }

  /// On both feet a million attitudes leave a hundred thousand candidates; more of them serve no plan.
  void thin(std::vector<SievedPose>& attitudes) const {
    if (attitudes.size() > options_.weighed) {
      for (std::size_t i = 0; i < options_.weighed; ++i) {
        std::swap(attitudes[i], attitudes[i * attitudes.size() / options_.weighed]);
      }
      attitudes.resize(options_.weighed, attitudes.front());
    }
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
    result.misfit = here.misfit(draft_.poses);
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
                              attitude.approach.size() > 0 ? attitude.approach : Eigen::VectorXd::Zero(joints)});
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
};

} // namespace

PosePlan posePlan(const Robot& robot, std::vector<Board> boards, const std::map<std::string, CameraIntrinsics>& cameras,
                  const PlanOptions& options, const std::function<void(const std::string&)>& tell) {
  const std::function<void(const std::string&)> quietly = [](const std::string&) {};
  return Planner{robot, std::move(boards), cameras, options, tell ? tell : quietly}.plan();
}

} // namespace naocal
