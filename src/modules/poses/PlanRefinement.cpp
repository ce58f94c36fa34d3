#include "poses/PlanRefinement.hpp"

#include "poses/BoardPlaces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace naocal {

void PlanRefinement::refinePoses(PlanDraft& draft) {
  const PlanScore score{robot_, draft.boards, cameras_, options_};
  const PoseJudge& judge = score.judge();
  RandomAttitude attitudes{robot_, score.scene(), options_.poses};
  std::vector<Eigen::MatrixXd> own = score.parts(draft.poses);
  Eigen::MatrixXd sum = score.sum(draft.poses);
  Sieve sieve;
  const std::size_t attempts = options_.refinements * draft.poses.size();
  for (std::size_t attempt = 0; attempt < attempts; ++attempt) {
    const std::size_t i = attempt % draft.poses.size();
    std::vector<double> point = draft.poses[i].point;
    for (double& number : point) {
      number = std::clamp(number + step(attempt, attempts), 0.0, 1.0);
    }
    const auto moved = attitudes.at(point, sieve);
    if (!moved) {
      continue;
    }
    const Eigen::MatrixXd part = score.parts({*moved}).front();
    if (judge(sum - own[i] + part) < judge(sum)) {
      sum += part - own[i];
      own[i] = part;
      draft.poses[i] = *moved;
    }
  }
}

void PlanRefinement::refineBoards(PlanDraft& draft) {
  const BoardPlaces places{robot_, options_.poses.supportFoot, options_.farthestBoard, options_.gap};
  double now = value(draft);
  const std::size_t attempts = options_.refinements * draft.boards.size();
  for (std::size_t attempt = 0; attempt < attempts; ++attempt) {
    const std::size_t i = attempt % draft.boards.size();
    Placement& place = *draft.boards[i].placement;
    const Placement before = place;
    const double size = 0.3 * step(attempt, attempts); // [m], of a typical move
    std::normal_distribution<double> move;
    place.x += size * move(random_);
    place.y += size * move(random_);
    place.yaw += 5 * size * move(random_);
    if (const double there = places.allow(draft.boards, i) ? value(draft) : now; there < now) {
      now = there;
    } else {
      place = before;
    }
  }
}

double PlanRefinement::value(const PlanDraft& draft) const {
  const PlanScore score{robot_, draft.boards, cameras_, options_};
  Eigen::MatrixXd sum = score.judge().prior();
  for (const Eigen::MatrixXd& part : score.parts(draft.poses)) {
    if (part.isZero()) {
      return std::numeric_limits<double>::infinity(); // a pose that sees nothing
    }
    sum += part;
  }
  return score.judge()(sum);
}

double PlanRefinement::step(std::size_t attempt, std::size_t attempts) {
  const double width = 0.15 * std::pow(0.05, static_cast<double>(attempt) / static_cast<double>(attempts));
  return std::normal_distribution<double>{0, width}(random_);
}

} // namespace naocal
