#include "poses/BoardTolerance.hpp"

#include "math/Parallel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace naocal {

namespace {

/// The largest size up to `most` at which all is well, in twentieths; assumes that it gets worse all the way.
template <typename Well> double largest(double most, const Well& well) {
  constexpr int steps = 20;
  int step = 0;
  while (step < steps && well(most * (step + 1) / steps)) {
    ++step;
  }
  return most * step / steps;
}

} // namespace

std::vector<BoardTolerance> boardTolerances(const Robot& robot, const std::vector<Board>& boards,
                                            const std::map<std::string, CameraIntrinsics>& cameras,
                                            const PlanOptions& options, const std::vector<SievedPose>& poses) {
  constexpr double growth = 1.1, farthest = 0.3, mostTurned = std::numbers::pi / 4; // [1], [m], [rad]
  PlanOptions drawn = options;
  drawn.wornRobots = 0;
  const auto worst = [&](const std::vector<Board>& laid) { // absent: a pose sees none
    const PlanScore score{robot, laid, cameras, drawn};
    const std::vector<Eigen::MatrixXd> parts = score.parts(poses);
    const bool blind = std::any_of(parts.begin(), parts.end(), [](const auto& part) { return part.isZero(); });
    return blind ? std::nullopt : std::optional{score.worstSigma(score.sum(poses))};
  };
  const double allowed = growth * worst(boards).value_or(0);
  std::vector<BoardTolerance> result(boards.size());
  inParallel(boards.size(), [&](std::size_t i) {
    const auto well = [&](double x, double y, double yaw) {
      std::vector<Board> laid = boards;
      laid[i].placement->x += x;
      laid[i].placement->y += y;
      laid[i].placement->yaw += yaw;
      const auto sigma = worst(laid);
      return sigma && *sigma <= allowed;
    };
    result[i].shift = farthest;
    for (int direction = 0; direction < 8; ++direction) {
      const double angle = direction * std::numbers::pi / 4;
      result[i].shift = largest(result[i].shift,
                                [&](double size) { return well(size * std::cos(angle), size * std::sin(angle), 0); });
    }
    result[i].turn = largest(mostTurned, [&](double size) { return well(0, 0, size) && well(0, 0, -size); });
  });
  return result;
}

} // namespace naocal
