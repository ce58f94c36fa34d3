#include "poses/PosePlan.hpp"

#include "captures/InputError.hpp"
#include "poses/BoardPlaces.hpp"
#include "poses/PlanScore.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <numeric>
#include <tbb/parallel_for.h>

namespace naocal {

namespace {

/// Works on a plan: chosen attitudes and boards, judged together.
class Planner {
public:
  Planner(const Robot& robot, std::vector<Board> boards, const std::map<std::string, CameraIntrinsics>& cameras,
          const PlanOptions& options)
      : robot_{robot}, cameras_{cameras}, options_{options}, boards_{std::move(boards)}, random_{options.poses.seed} {}

  PosePlan plan(const std::function<void(const std::string&)>& tell) {
    PosePlan result;
    tell(fmt::format("sieving {} attitudes", options_.poses.tries));
    PoseCandidates candidates = poseCandidates(robot_, scoreNow().scene(), options_.poses);
    if (candidates.attitudes.size() < options_.poses.count) {
      throw InputError{fmt::format("expected {} stable poses that see a board, found {} among {} attitudes; put the "
                                   "boards nearer, try more candidates or ask for fewer poses",
                                   options_.poses.count, candidates.attitudes.size(), options_.poses.tries)};
    }
    for (std::size_t round = 0; round < options_.rounds; ++round) {
      choose(candidates.attitudes);
      tell(fmt::format("round {} of {}: selected among {} poses, the worst offset's sigma is {:.4f} deg", round + 1,
                       options_.rounds, candidates.attitudes.size(), worst()));
      refinePoses();
      if (options_.moveBoards) {
        refineBoards();
      }
      tell(fmt::format("round {} of {}: refined, {:.4f} deg", round + 1, options_.rounds, worst()));
      candidates.attitudes.insert(candidates.attitudes.end(), chosen_.begin(), chosen_.end());
    }
    finish(result);
    result.sieve = candidates.sieve;
    return result;
  }

private:
  PlanScore scoreNow() const { return {robot_, boards_, cameras_, options_}; }

  void choose(const std::vector<SievedPose>& attitudes) {
    const PlanScore score = scoreNow();
    chosen_.clear();
    for (const std::size_t index : selected(score.judge(), score.parts(attitudes), options_.poses.count)) {
      chosen_.push_back(attitudes[index]);
    }
  }

  /// Each pose in turn tries places near its own, ever nearer ones.
  void refinePoses() {
    const PlanScore score = scoreNow();
    const PoseJudge& judge = score.judge();
    RandomAttitude attitudes{robot_, score.scene(), options_.poses};
    std::vector<Eigen::MatrixXd> own = score.parts(chosen_);
    Eigen::MatrixXd sum = score.sum(chosen_);
    Sieve sieve;
    for (std::size_t attempt = 0; attempt < options_.refinements * chosen_.size(); ++attempt) {
      const std::size_t i = attempt % chosen_.size();
      std::vector<double> point = chosen_[i].point;
      for (double& number : point) {
        number = std::clamp(number + step(attempt, options_.refinements * chosen_.size()), 0.0, 1.0);
      }
      const auto moved = attitudes.at(point, sieve);
      if (!moved) {
        continue;
      }
      const Eigen::MatrixXd part = score.parts({*moved}).front();
      if (judge(sum - own[i] + part) < judge(sum)) {
        sum += part - own[i];
        own[i] = part;
        chosen_[i] = *moved;
      }
    }
  }

  /// Each board in turn, too, as long as it remains where a board may lie and all poses see one.
  void refineBoards() {
    const BoardPlaces places{robot_, options_.poses.supportFoot, options_.farthestBoard, options_.gap};
    double value = valueNow();
    for (std::size_t attempt = 0; attempt < options_.refinements * boards_.size(); ++attempt) {
      const std::size_t i = attempt % boards_.size();
      const Placement before = *boards_[i].placement;
      const double size = 0.3 * step(attempt, options_.refinements * boards_.size()); // [m], of a typical move
      std::normal_distribution<double> move;
      boards_[i].placement->x += size * move(random_);
      boards_[i].placement->y += size * move(random_);
      boards_[i].placement->yaw += 5 * size * move(random_);
      const double there = places.allow(boards_, i) ? valueNow() : value;
      if (there < value) {
        value = there;
      } else {
        boards_[i].placement = before;
      }
    }
  }

  double valueNow() const {
    const PlanScore score = scoreNow();
    Eigen::MatrixXd sum = score.judge().prior();
    for (const Eigen::MatrixXd& part : score.parts(chosen_)) {
      if (part.isZero()) {
        return std::numeric_limits<double>::infinity(); // a pose that sees nothing
      }
      sum += part;
    }
    return score.judge()(sum);
  }

  double step(std::size_t attempt, std::size_t attempts) {
    const double width = 0.15 * std::pow(0.05, static_cast<double>(attempt) / static_cast<double>(attempts));
    return std::normal_distribution<double>{0, width}(random_);
  }

  double worst() const { // [deg]
    double result = 0;
    for (const auto& [joint, sigma] : scoreNow().sigmas(chosen_, options_.known)) {
      result = std::max(result, degrees(sigma));
    }
    return result;
  }

  /// The quickest safe order; as they were selected where there is none.
  void bringIntoOrder(PosePlan& result) {
    const PlanScore score = scoreNow();
    const std::size_t count = chosen_.size();
    std::vector<std::optional<PoseWay>> ways(count * count);
    tbb::parallel_for(std::size_t{0}, count * count, [&](std::size_t i) {
      ways[i] = safeWay(robot_, score.scene(), options_.poses, chosen_[i / count], chosen_[i % count]);
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
      ordered.push_back(chosen_[order[i]]);
      result.ways.push_back(i == 0 ? std::nullopt : ways[order[i - 1] * count + order[i]]);
    }
    chosen_ = std::move(ordered);
  }

  void finish(PosePlan& result) {
    bringIntoOrder(result);
    const PlanScore score = scoreNow();
    const Scene& scene = score.scene();
    const auto joints = static_cast<Eigen::Index>(robot_.joints.size());
    for (const SievedPose& attitude : chosen_) {
      Belief belief = scene.drawn();
      belief.values.head(joints) = attitude.belief.values.head(joints);
      result.poses.push_back(
          {{options_.poses.supportFoot, belief.values.head(joints), scene.sights(belief, posture(robot_, belief))},
           Eigen::VectorXd::Zero(joints)});
      result.standing.push_back(attitude.standing);
    }
    result.supportFoot = options_.poses.supportFoot;
    result.boards = boards_;
    result.sigma = score.sigmas(chosen_, false);
    result.sigmaKnown = score.sigmas(chosen_, true);
    result.sigmaOfRobots = score.sigmasOfRobots(chosen_);
    result.options = options_;
  }

  const Robot& robot_;
  const std::map<std::string, CameraIntrinsics>& cameras_;
  const PlanOptions& options_;
  std::vector<Board> boards_;
  std::mt19937_64 random_;
  std::vector<SievedPose> chosen_;
};

} // namespace

PosePlan posePlan(const Robot& robot, std::vector<Board> boards, const std::map<std::string, CameraIntrinsics>& cameras,
                  const PlanOptions& options, const std::function<void(const std::string&)>& tell) {
  const auto quietly = [](const std::string&) {};
  return Planner{robot, std::move(boards), cameras, options}.plan(tell ? tell : quietly);
}

} // namespace naocal
