#include "FloorBoards.hpp"

#include "StandingRobot.hpp"

#include "detect/LensDistortion.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

constexpr std::size_t mostViews = 60;             // that a mean is made of
constexpr double movedBy = 0.15, turnedBy = 0.35; // then the board or the robot was moved [m, rad]

double turn(double from, double to) {
  return std::remainder(to - from, 2 * M_PI);
}

/// Where the picture shows a point of the floor.
Eigen::Vector2d pixelOf(const Eigen::Vector3d& onFloor, const Eye& eye) {
  const Eigen::Vector3d seen = eye.floorFromOptical.inverse() * onFloor;
  return Lens{eye.lens}.withDistortion(
      {eye.lens.fx * seen.x() / seen.z() + eye.lens.cx, eye.lens.fy * seen.y() / seen.z() + eye.lens.cy});
}

} // namespace

const Board* FloorBoards::board(const std::string& id) const {
  const auto found = std::find_if(boards_.begin(), boards_.end(), [&](const Board& one) { return one.id == id; });
  return found == boards_.end() ? nullptr : &*found;
}

FloorBoards::Place FloorBoards::mean(const std::string& id) const {
  const auto& views = views_.at(id);
  Place sum;
  double cosine = 0, sine = 0;
  for (const Place& view : views) {
    sum.x += view.x / double(views.size());
    sum.y += view.y / double(views.size());
    cosine += std::cos(view.yaw);
    sine += std::sin(view.yaw);
  }
  sum.yaw = std::atan2(sine, cosine);
  return sum;
}

std::vector<Eigen::Vector2d> FloorBoards::predicted(const BoardCorners& seen, const Eye& eye) {
  const Board* const described = board(seen.board);
  const auto isOnIt = [&](int corner) { return corner >= 0 && std::size_t(corner) < described->points.size(); };
  if (described == nullptr || seen.ids.size() < 2 || !std::all_of(seen.ids.begin(), seen.ids.end(), isOnIt)) {
    return {};
  }
  // the rotation and shift of the plane that fit best: Umeyama's, in two dimensions
  std::vector<Eigen::Vector2d> onBoard, there;
  for (std::size_t i = 0; i < seen.ids.size(); ++i) {
    const auto place = onFloor(eye.floorFromOptical, eye.lens, seen.uv[i]);
    if (!place) {
      return {};
    }
    onBoard.push_back(described->points.at(static_cast<std::size_t>(seen.ids[i])).head<2>());
    there.push_back(*place);
  }
  Eigen::Vector2d middleOnBoard = Eigen::Vector2d::Zero(), middleThere = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < onBoard.size(); ++i) {
    middleOnBoard += onBoard[i] / double(onBoard.size());
    middleThere += there[i] / double(onBoard.size());
  }
  double cosine = 0, sine = 0;
  for (std::size_t i = 0; i < onBoard.size(); ++i) {
    const Eigen::Vector2d a = onBoard[i] - middleOnBoard, b = there[i] - middleThere;
    cosine += a.dot(b);
    sine += a.x() * b.y() - a.y() * b.x();
  }
  const double yaw = std::atan2(sine, cosine);
  const Eigen::Vector2d shift = middleThere - Eigen::Rotation2Dd{yaw} * middleOnBoard;

  auto& views = views_[seen.board];
  if (!views.empty()) {
    const Place before = mean(seen.board);
    if (std::hypot(before.x - shift.x(), before.y - shift.y()) > movedBy ||
        std::abs(turn(before.yaw, yaw)) > turnedBy) {
      views.clear();
    }
  }
  views.push_back({shift.x(), shift.y(), yaw});
  if (views.size() > mostViews) {
    views.pop_front();
  }
  const Place place = mean(seen.board);
  std::vector<Eigen::Vector2d> pixels;
  for (const Eigen::Vector2d& corner : onBoard) {
    const Eigen::Vector2d point = Eigen::Rotation2Dd{place.yaw} * corner + Eigen::Vector2d{place.x, place.y};
    pixels.push_back(pixelOf({point.x(), point.y(), 0}, eye));
  }
  return pixels;
}

nlohmann::json FloorBoards::drawn() const {
  nlohmann::json list = nlohmann::json::array();
  for (const auto& [id, views] : views_) {
    const CharucoPattern& pattern = board(id)->pattern.value();
    const Place place = mean(id);
    list.push_back({{"id", id},
                    {"columns", pattern.squaresX},
                    {"rows", pattern.squaresY},
                    {"square", pattern.squareLength},
                    {"x", place.x},
                    {"y", place.y},
                    {"yaw", place.yaw}});
  }
  return list;
}

} // namespace naocal
