#include "poses/PoseOrder.hpp"

#include "poses/PoseChecks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace naocal {

namespace {

using Ways = std::vector<std::vector<std::optional<double>>>;
constexpr double never = std::numeric_limits<double>::infinity();

std::vector<std::size_t> nearestNext(const Ways& seconds) {
  std::vector<std::size_t> order{0};
  while (order.size() < seconds.size()) {
    std::optional<std::size_t> next;
    for (std::size_t i = 0; i < seconds.size(); ++i) {
      const auto& way = seconds[order.back()][i];
      if (way && std::find(order.begin(), order.end(), i) == order.end() &&
          (!next || *way < *seconds[order.back()][*next])) {
        next = i;
      }
    }
    if (!next) {
      break;
    }
    order.push_back(*next);
  }
  return order;
}

/// Held and Karp (1962): the quickest way through each set of poses to each of its members.
std::vector<std::size_t> byDynamicProgramming(const Ways& seconds) {
  const std::size_t count = seconds.size(), sets = std::size_t{1} << count;
  std::vector<std::vector<double>> shortest(sets, std::vector<double>(count, never));
  std::vector<std::vector<std::size_t>> before(sets, std::vector<std::size_t>(count, count));
  for (std::size_t i = 0; i < count; ++i) {
    shortest[std::size_t{1} << i][i] = 0;
  }
  for (std::size_t set = 1; set < sets; ++set) {
    for (std::size_t last = 0; last < count; ++last) {
      for (std::size_t next = 0; next < count && shortest[set][last] < never; ++next) {
        const std::size_t larger = set | std::size_t{1} << next;
        const double length = larger == set ? never : shortest[set][last] + seconds[last][next].value_or(never);
        if (length < shortest[larger][next]) {
          shortest[larger][next] = length;
          before[larger][next] = last;
        }
      }
    }
  }
  std::size_t set = sets - 1;
  auto last =
      static_cast<std::size_t>(std::min_element(shortest[set].begin(), shortest[set].end()) - shortest[set].begin());
  std::vector<std::size_t> order;
  while (last < count && shortest[set][last] < never) {
    order.insert(order.begin(), last);
    const std::size_t previous = before[set][last];
    set &= ~(std::size_t{1} << last);
    last = previous;
  }
  return order;
}

} // namespace

double secondsBetween(const Robot& robot, const Eigen::VectorXd& from, const Eigen::VectorXd& to, double speed) {
  double seconds = 0;
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const auto i = static_cast<Eigen::Index>(joint);
    if (robot.joints[joint].maxSpeed > 0) {
      seconds = std::max(seconds, std::abs(to[i] - from[i]) / (speed * robot.joints[joint].maxSpeed));
    }
  }
  return seconds;
}

std::optional<double> secondsOnTheWay(const Robot& robot, const PoseOptions& options, const Eigen::VectorXd& from,
                                      const Eigen::VectorXd& to, const Motion& motion) {
  PoseOptions onTheWay = options;
  onTheWay.footing = {.depth = 0.01, .clearance = 0.005};
  onTheWay.stability.share = motion.share;
  const PoseChecks checks{robot, onTheWay};
  std::mt19937_64 random{options.seed};
  Belief belief = drawnBelief(robot, Quantities{robot.joints.size(), robot.lengths.size(), 0});
  const int steps = std::max(1, static_cast<int>(std::ceil((to - from).cwiseAbs().maxCoeff() / motion.step)));
  for (int i = 1; i < steps; ++i) {
    belief.values.head(from.size()) = from + (to - from) * i / steps;
    const Posture torsoFromLink = posture(robot, belief);
    if (checks.touchesItself(torsoFromLink) || !checks.standing(belief, torsoFromLink, random)) {
      return std::nullopt;
    }
  }
  return secondsBetween(robot, from, to, motion.speed);
}

std::optional<std::vector<std::size_t>> quickestOrder(const Ways& seconds) {
  constexpr std::size_t exact = 12;
  const std::vector<std::size_t> order = seconds.size() <= exact ? byDynamicProgramming(seconds) : nearestNext(seconds);
  return order.size() == seconds.size() ? std::optional{order} : std::nullopt;
}

} // namespace naocal
