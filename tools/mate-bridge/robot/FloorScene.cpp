#include "robot/FloorScene.hpp"

#include "detect/LensDistortion.hpp"
#include "protocol/JointOrder.hpp"
#include "robot/Gravity.hpp"
#include "robot/Kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using Json = nlohmann::json;

constexpr double sameHeight = 0.01; // [m]; up to this difference both soles carry
constexpr double farthest = 3;      // [m]; limit of drawn views

Json rounded(const Eigen::Vector3d& point) {
  Json list = Json::array();
  for (const double value : point) {
    list.push_back(std::round(value * 1e4) / 1e4);
  }
  return list;
}

Json rounded(const Eigen::Vector2d& point) {
  return {std::round(point.x() * 1e4) / 1e4, std::round(point.y() * 1e4) / 1e4};
}

Eigen::Vector3d ray(const RigidTransform& floorFromOptical, const CameraIntrinsics& lens,
                    const Eigen::Vector2d& pixel) {
  const Eigen::Vector2d ideal = LensDistortion{lens}.undistort(pixel);
  return floorFromOptical.rotation *
         Eigen::Vector3d{(ideal.x() - lens.cx) / lens.fx, (ideal.y() - lens.cy) / lens.fy, 1};
}

/// Rotation [rad] and translation in the plane: to = R(yaw) from + shift.
struct PlaneMotion {
  double yaw = 0;
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();
};

/// Best rotation and translation in the plane (Umeyama, 2-D).
PlaneMotion alignPoints(const std::vector<Eigen::Vector2d>& from, const std::vector<Eigen::Vector2d>& to) {
  const auto columns = [](const std::vector<Eigen::Vector2d>& points) {
    return Eigen::Matrix2Xd::Map(points.front().data(), 2, static_cast<Eigen::Index>(points.size()));
  };
  const Eigen::Matrix3d motion = Eigen::umeyama(columns(from), columns(to), false);
  return {std::atan2(motion(1, 0), motion(0, 0)), motion.topRightCorner<2, 1>()};
}

/// The image's border projected onto the floor; limited to `farthest`, also above the horizon.
Json viewOnFloor(const RigidTransform& eye, const CameraIntrinsics& lens) {
  constexpr int steps = 12; // per side
  const Eigen::Vector2d last{lens.width - 1, lens.height - 1};
  const std::array<Eigen::Vector2d, 5> rim{Eigen::Vector2d{0, 0}, {last.x(), 0}, last, {0, last.y()}, {0, 0}};
  Json polygon = Json::array();
  for (std::size_t side = 0; side < 4; ++side) {
    for (int step = 0; step < steps; ++step) {
      const Eigen::Vector2d pixel = rim[side] + (rim[side + 1] - rim[side]) * step / steps;
      const Eigen::Vector3d direction = ray(eye, lens, pixel);
      const Eigen::Vector2d from = eye.translation.head<2>(), along = direction.head<2>();
      double reach = direction.z() < 0 ? -eye.translation.z() / direction.z() : farthest / along.norm();
      reach = std::min(reach, farthest / std::max(1e-9, along.norm()));
      polygon.push_back(rounded(Eigen::Vector2d{from + reach * along}));
    }
  }
  return polygon;
}

constexpr std::size_t mostViews = 60;             // views averaged
constexpr double movedBy = 0.15, turnedBy = 0.35; // beyond these the board or the robot has moved: restarts the mean
                                                  // [m, rad]

double turn(double from, double to) {
  return std::remainder(to - from, 2 * M_PI);
}

/// Projects a point of the floor.
Eigen::Vector2d pixelOf(const Eigen::Vector3d& onFloor, const CameraView& eye) {
  const Eigen::Vector3d seen = eye.floorFromOptical.inverse() * onFloor;
  return LensDistortion{eye.lens}.distort(
      {eye.lens.fx * seen.x() / seen.z() + eye.lens.cx, eye.lens.fy * seen.y() / seen.z() + eye.lens.cy});
}

} // namespace

RobotOutline::RobotOutline(const Robot& drawing, const Eigen::VectorXd& angles)
    : drawing_{drawing}, angles_{angles}, floorFromLink_{forwardKinematics(drawing, angles)} {
  const Sole *const left = drawing.findSole("left"), *const right = drawing.findSole("right");
  const Sole* carrying = left;
  if (left != nullptr && right != nullptr) {
    const double height = (floorFromLink_[left->link].inverse() * floorFromLink_[right->link].translation).z();
    carries_ = height > sameHeight ? "left" : height < -sameHeight ? "right" : "both";
    carrying = carries_ == "right" ? right : left;
  }
  const RigidTransform floorFromTorso = carrying ? floorFromLink_[carrying->link].inverse() : RigidTransform{};
  for (RigidTransform& link : floorFromLink_) {
    link = floorFromTorso * link;
  }
}

std::optional<RigidTransform> RobotOutline::floorFromOptical(const std::string& camera,
                                                             const LiveCamera& modelState) const {
  const auto index = drawing_.cameraIndex(camera);
  if (!index) {
    return std::nullopt;
  }
  ModelState believed = nominalState(drawing_, {drawing_.joints.size(), drawing_.lengths.size(), 0});
  believed.mountRotation() = modelState.rotation;
  const CameraMount& mount = drawing_.cameras[*index];
  return floorFromLink_[mount.link] * linkFromOptical(mount, believed);
}

Json RobotOutline::toJson(const LiveCameras& cameras) const {
  Json hull = Json::array(), feet = Json::object(), views = Json::object(), gaze;
  for (const Capsule& part : drawing_.collisionCapsules) {
    const RigidTransform& link = floorFromLink_[part.link];
    hull.push_back({rounded(link * part.from), rounded(link * part.to), part.radius});
  }
  constexpr double bone = 0.02; // [m]; fills gaps between the capsules
  for (std::size_t i = 0; i < drawing_.links.size(); ++i) {
    if (const auto parent = drawing_.links[i].parent; parent && drawing_.links[i].joint) {
      hull.push_back({rounded(floorFromLink_[*parent].translation), rounded(floorFromLink_[i].translation), bone});
    }
  }
  for (const Sole& sole : drawing_.soles) {
    for (const Eigen::Vector2d& point : sole.outline) {
      const Eigen::Vector3d there = floorFromLink_[sole.link] * Eigen::Vector3d{point.x(), point.y(), 0};
      feet[sole.name].push_back(rounded(Eigen::Vector2d{there.head<2>()}));
    }
  }
  for (const auto& [name, modelState] : cameras) {
    if (const auto eyeHere = floorFromOptical(name, modelState)) {
      views[name] = viewOnFloor(*eyeHere, modelState.intrinsics);
    }
  }
  if (const auto eyeHere = floorFromOptical("top", {})) {
    const Eigen::Vector3d from = eyeHere->translation, ahead = eyeHere->rotation * Eigen::Vector3d{0, 0, 0.12};
    gaze = {rounded(from), rounded(Eigen::Vector3d{from + ahead})};
  }
  const LinkPoses torsoFromLink = forwardKinematics(drawing_, angles_);
  return {{"hull", std::move(hull)},
          {"feet", std::move(feet)},
          {"views", std::move(views)},
          {"gaze", std::move(gaze)},
          {"carries", carries_},
          {"centre", rounded(floorFromLink_.front() * centreOfMass(drawing_, torsoFromLink).inTorso)}};
}

std::optional<Eigen::VectorXd> parseNamedAngles(const Json& byName, const Robot& drawing) {
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(drawing.joints.size()));
  for (const auto& [name, value] : byName.items()) {
    const auto joint = drawing.jointIndex(name);
    if (!value.is_number()) {
      return std::nullopt;
    }
    if (joint) { // hands are not in the drawing
      angles[static_cast<Eigen::Index>(*joint)] = value.get<double>();
    }
  }
  return angles;
}

std::optional<Eigen::VectorXd> parseOrderedAngles(const Json& list, const Robot& drawing) {
  if (!list.is_array() || list.size() != jointCount) {
    return std::nullopt;
  }
  Json byName = Json::object();
  for (std::size_t i = 0; i < jointCount; ++i) {
    byName[std::string{jointNames[i]}] = list[i];
  }
  return parseNamedAngles(byName, drawing);
}

std::optional<Eigen::Vector2d> intersectFloor(const RigidTransform& floorFromOptical, const CameraIntrinsics& lens,
                                              const Eigen::Vector2d& pixel) {
  const Eigen::Vector3d direction = ray(floorFromOptical, lens, pixel);
  if (direction.z() >= 0) {
    return std::nullopt;
  }
  const Eigen::Vector3d there =
      floorFromOptical.translation - direction * (floorFromOptical.translation.z() / direction.z());
  return there.head<2>();
}

const Board* FloorBoardTracker::board(const std::string& id) const {
  const auto found = std::find_if(boards_.begin(), boards_.end(), [&](const Board& one) { return one.id == id; });
  return found == boards_.end() ? nullptr : &*found;
}

FloorBoardTracker::Place FloorBoardTracker::mean(const std::string& id) const {
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

void FloorBoardTracker::addView(const std::string& id, const Place& view) {
  auto& views = views_[id];
  if (!views.empty()) {
    const Place before = mean(id);
    if (std::hypot(before.x - view.x, before.y - view.y) > movedBy || std::abs(turn(before.yaw, view.yaw)) > turnedBy) {
      views.clear();
    }
  }
  views.push_back(view);
  if (views.size() > mostViews) {
    views.pop_front();
  }
}

std::vector<Eigen::Vector2d> FloorBoardTracker::update(const BoardCorners& seen, const CameraView& eye) {
  const Board* const described = board(seen.board);
  const auto isOnIt = [&](int corner) { return corner >= 0 && std::size_t(corner) < described->points.size(); };
  if (described == nullptr || seen.ids.size() < 2 || !std::all_of(seen.ids.begin(), seen.ids.end(), isOnIt)) {
    return {};
  }
  std::vector<Eigen::Vector2d> onBoard, there;
  for (std::size_t i = 0; i < seen.ids.size(); ++i) {
    const auto place = intersectFloor(eye.floorFromOptical, eye.lens, seen.uv[i]);
    if (!place) {
      return {};
    }
    onBoard.push_back(described->points.at(static_cast<std::size_t>(seen.ids[i])).head<2>());
    there.push_back(*place);
  }
  const PlaneMotion floorFromBoard = alignPoints(onBoard, there);
  addView(seen.board, {floorFromBoard.shift.x(), floorFromBoard.shift.y(), floorFromBoard.yaw});
  const Place place = mean(seen.board);
  std::vector<Eigen::Vector2d> pixels;
  for (const Eigen::Vector2d& corner : onBoard) {
    const Eigen::Vector2d point = Eigen::Rotation2Dd{place.yaw} * corner + Eigen::Vector2d{place.x, place.y};
    pixels.push_back(pixelOf({point.x(), point.y(), 0}, eye));
  }
  return pixels;
}

nlohmann::json FloorBoardTracker::toJson() const {
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
