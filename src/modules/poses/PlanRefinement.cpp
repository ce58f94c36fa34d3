#include "poses/PlanRefinement.hpp"

#include "poses/BoardPlaces.hpp"
#include "poses/Mirror.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace naocal {

void PlanRefinement::refinePoses(PlanDraft& draft) {
  const PlanScore score{robot_, draft.boards, cameras_, options_};
  RandomAttitude attitudes{robot_, score.scene(), options_.poses};
  std::vector<Eigen::MatrixXd> own = score.parts(draft.poses);
  Eigen::MatrixXd sum = score.sum(draft.poses);
  double now = score.value(sum, draft.poses);
  Sieve unused;
  const std::size_t attempts = options_.refinements * draft.poses.size();
  for (std::size_t attempt = 0; attempt < attempts; ++attempt) {
    const std::size_t i = attempt % draft.poses.size();
    std::vector<double> point = draft.poses[i].point;
    for (double& number : point) {
      number = std::clamp(number + step(attempt, attempts), 0.0, 1.0);
    }
    auto moved = attitudes.at(point, unused);
    if (!moved) {
      continue;
    }
    const Eigen::MatrixXd part = score.parts({*moved}).front();
    const Eigen::MatrixXd with = sum - own[i] + part;
    std::swap(draft.poses[i], *moved);
    if (const double there = score.value(with, draft.poses); there < now) {
      now = there;
      sum = with;
      own[i] = part;
    } else {
      std::swap(draft.poses[i], *moved);
    }
  }
}

void PlanRefinement::refineBoards(PlanDraft& draft) {
  const BoardPlaces places{robot_, options_.poses.supportFoot, options_.farthestBoard, options_.gap};
  const MirroredBoards mirror{draft.boards, middleBetweenFeet(options_.poses.supportFoot)};
  double now = value(draft);
  const std::size_t attempts = options_.refinements * draft.boards.size();
  for (std::size_t attempt = 0; attempt < attempts; ++attempt) {
    const std::size_t i = attempt % draft.boards.size();
    const std::vector<Board> before = draft.boards;
    Placement& place = *draft.boards[i].placement;
    const double size = 0.3 * step(attempt, attempts); // [m], of a typical move
    std::normal_distribution<double> move;
    place.x += size * move(random_);
    place.y += size * move(random_);
    place.yaw += 5 * size * move(random_);
    if (options_.mirrored) {
      mirror.follow(draft.boards, i);
    }
    const bool allowed =
        places.allow(draft.boards, i) && (!options_.mirrored || places.allow(draft.boards, mirror.mate(i)));
    if (const double there = allowed ? value(draft) : now; there < now) {
      now = there;
    } else {
      draft.boards = before;
    }
  }
}

double PlanRefinement::value(const PlanDraft& draft) const {
  const PlanScore score{robot_, draft.boards, cameras_, options_};
  Eigen::MatrixXd sum = score.known();
  for (const Eigen::MatrixXd& part : score.parts(draft.poses)) {
    if (part.leftCols(part.rows()).isZero()) {
      return std::numeric_limits<double>::infinity(); // a pose that sees nothing
    }
    sum += part;
  }
  return score.value(sum, draft.poses);
}

double PlanRefinement::step(std::size_t attempt, std::size_t attempts) {
  const double width = 0.15 * std::pow(0.05, static_cast<double>(attempt) / static_cast<double>(attempts));
  return std::normal_distribution<double>{0, width}(random_);
}

} // namespace naocal
