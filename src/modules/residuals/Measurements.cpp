#include "residuals/Measurements.hpp"

#include "captures/InputError.hpp"
#include "residuals/Grouping.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <set>

namespace naocal {

namespace {

/// Collects the sets into the lists of `Measurements`.
class Collector {
public:
  Collector(const std::vector<CaptureSet>& sets, const Robot& robot, bool samePlace)
      : sets_{sets}, samePlace_{samePlace} {
    result_.robot = robot;
  }

  Measurements collect() {
    for (const CaptureSet& set : sets_) {
      refuseOtherRobots(set);
      addTargets(set);
      addStandings(set);
    }
    fixGauge();
    result_.quantities = Quantities{result_.robot.joints.size(), result_.robot.lengths.size(), result_.targets.size()};
    for (std::size_t set = 0; set < sets_.size(); ++set) {
      addPictures(set);
    }
    groupReadings(sets_, result_);
    return std::move(result_);
  }

private:
  std::string scoped(const CaptureSet& set, const std::string& id) const {
    return sets_.size() == 1 || samePlace_ ? id : set.name + "/" + id;
  }

  void refuseOtherRobots(const CaptureSet& set) const {
    const CaptureSet& first = sets_.front();
    if (set.bodyId != first.bodyId || set.headId != first.headId || set.model != first.model) {
      throw InputError{fmt::format(
          "{}: robot: expected the robot of {} (model {}, body {}, head {}), found model {}, body "
          "{}, head {}; sets given together must be of one robot",
          set.name, first.name, first.model, first.bodyId, first.headId, set.model, set.bodyId, set.headId)};
    }
  }

  void addTargets(const CaptureSet& set) {
    for (const Board& board : set.boards) {
      const std::string name = scoped(set, board.id);
      if (targetIndex_.contains(name)) {
        continue;
      }
      const bool onFloor = board.link == "floor";
      if (!onFloor && !result_.robot.linkIndex(board.link)) {
        throw InputError{fmt::format("{}: boards[{}].link: the {} has no link '{}'", set.name, board.id,
                                     result_.robot.model, board.link)};
      }
      targetIndex_[name] = result_.targets.size();
      result_.targets.push_back({name, board, onFloor, !board.placement.has_value()});
    }
  }

  void addStandings(const CaptureSet& set) {
    for (const Stance& stance : set.stances) {
      const std::string name = scoped(set, std::to_string(stance.id));
      if (standingIndex_.contains(name)) {
        continue;
      }
      standingIndex_[name] = result_.standings.size();
      result_.standings.push_back(
          {name, stance.supportFoot, !stance.placement && stance.supportFoot != SupportFoot::none});
      standingPlacement_.push_back(stance.placement.value_or(Placement{}));
    }
  }

  /// If nothing is surveyed, the frame of the first floor board seen (in the order of the boards' list) is the world.
  void fixGauge() {
    std::set<std::string> seen;
    for (const CaptureSet& set : sets_) {
      for (const Capture& capture : set.captures) {
        for (const BoardCorners& corners : capture.corners.value_or(std::vector<BoardCorners>{})) {
          if (!corners.ids.empty()) {
            seen.insert(scoped(set, corners.board));
          }
        }
      }
    }
    for (const CaptureSet& set : sets_) {
      const bool surveyed =
          std::any_of(set.boards.begin(), set.boards.end(),
                      [](const Board& board) { return board.link == "floor" && board.placement.has_value(); }) ||
          std::any_of(set.stances.begin(), set.stances.end(),
                      [](const Stance& stance) { return stance.placement.has_value(); });
      if (surveyed) {
        if (samePlace_) {
          return;
        }
        continue;
      }
      for (const Board& board : set.boards) {
        Target& target = result_.targets[targetIndex_.at(scoped(set, board.id))];
        if (target.onFloor && seen.contains(target.name)) {
          target.unknown = false;
          target.board.placement = Placement{};
          break;
        }
      }
      if (samePlace_) {
        return;
      }
    }
  }

  /// Per joint of the robot, what `list` holds for it, or `missing`.
  Eigen::VectorXd perJoint(const CaptureSet& set, const std::vector<double>& list, double missing) const {
    const Robot& robot = result_.robot;
    Eigen::VectorXd values = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(robot.joints.size()), missing);
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (const auto joint = robot.jointIndex(set.jointNames[i])) {
        values[static_cast<Eigen::Index>(*joint)] = list[i];
      }
    }
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) { // one motor, one reading
      const auto own = static_cast<Eigen::Index>(joint);
      const auto motor = static_cast<Eigen::Index>(robot.joints[joint].motor);
      if (own != motor) {
        if (std::isnan(values[motor])) {
          values[motor] = values[own];
        }
        values[own] = values[motor];
      }
    }
    return values;
  }

  std::size_t targetLink(const Target& target, SupportFoot foot) const {
    const Robot& robot = result_.robot;
    if (!target.onFloor) {
      return *robot.linkIndex(target.board.link);
    }
    return robot.sole(foot == SupportFoot::right ? "right" : "left")->link;
  }

  void addPictures(std::size_t setIndex) {
    const CaptureSet& set = sets_[setIndex];
    for (std::size_t index = 0; index < set.captures.size(); ++index) {
      const Capture& capture = set.captures[index];
      if (!capture.corners) {
        throw InputError{fmt::format("{}: captures[{}] (id {}): no corners yet; run 'naocal detect {}' first", set.name,
                                     index, capture.id, set.name)};
      }
      const auto camera = result_.robot.cameraIndex(capture.camera);
      if (!camera) {
        throw InputError{fmt::format("{}: captures[{}].camera: the {} has no camera '{}'", set.name, index,
                                     result_.robot.model, capture.camera)};
      }
      result_.pictures.push_back(picture(set, setIndex, index, *camera));
    }
  }

  Picture picture(const CaptureSet& set, std::size_t setIndex, std::size_t index, std::size_t camera) {
    const Capture& capture = set.captures[index];
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    Picture result{.set = setIndex,
                   .capture = index,
                   .camera = camera,
                   .stance = standingIndex_.at(scoped(set, std::to_string(capture.stance))),
                   .instant = {.time = capture.time,
                               .supportFoot = capture.supportFoot,
                               .q = perJoint(set, capture.joints.measured, nothing),
                               .velocity = perJoint(set, capture.joints.velocity, nothing),
                               .approach = perJoint(set, capture.joints.approach, nothing),
                               .temperature = perJoint(set, capture.joints.temperature, nothing)},
                   .drawn = drawnBelief(result_.robot, result_.quantities),
                   .sightings = {}};
    for (const BoardCorners& corners : *capture.corners) {
      addSighting(set, capture, corners, result);
    }
    for (std::size_t joint = 0; joint < result_.robot.joints.size(); ++joint) {
      double& angle = result.instant.q[static_cast<Eigen::Index>(joint)];
      if (std::isnan(angle)) {
        angle = result_.robot.joints[joint].resting;
      }
      result.drawn.angle(joint) = angle;
    }
    setScene(set, capture, result);
    return result;
  }

  void addSighting(const CaptureSet& set, const Capture& capture, const BoardCorners& corners, Picture& result) {
    const std::size_t target = targetIndex_.at(scoped(set, corners.board));
    const bool onFloor = result_.targets[target].onFloor;
    if (corners.ids.empty() || (onFloor && capture.supportFoot == SupportFoot::none)) {
      return; // a hanging robot learns nothing from the floor
    }
    View view{result_.robot, result_.quantities,
              result.camera, targetLink(result_.targets[target], capture.supportFoot),
              onFloor,       target};
    for (std::size_t joint : view.joints()) {
      if (std::isnan(result.instant.q[static_cast<Eigen::Index>(joint)])) {
        throw InputError{
            fmt::format("{}: capture {}: joints.measured: {} was not recorded but board {} is seen along it", set.name,
                        capture.id, result_.robot.joints[joint].name, corners.board)};
      }
    }
    result.sightings.push_back({std::move(view), cornerBlocks(result_.targets[target].board, corners), corners.ids});
    result_.cornerCount += corners.ids.size();
  }

  void setScene(const CaptureSet& set, const Capture& capture, Picture& result) const {
    const CameraIntrinsics& camera = set.cameras.at(capture.camera);
    result.drawn.lens().head<4>() << camera.fx, camera.fy, camera.cx, camera.cy;
    for (std::size_t i = 0; i < camera.distortion.size(); ++i) {
      result.drawn.lens()[static_cast<Eigen::Index>(4 + i)] = camera.distortion[i];
    }
    const auto numbers = [](const Placement& p) {
      return (Eigen::Matrix<double, 6, 1>{} << p.x, p.y, p.z, p.roll, p.pitch, p.yaw).finished();
    };
    result.drawn.ground() = numbers(standingPlacement_[result.stance]);
    for (std::size_t target = 0; target < result_.targets.size(); ++target) {
      const Board& board = result_.targets[target].board;
      result.drawn.boardPlacement(target) = numbers(board.placement.value_or(board.placementGuess));
    }
  }

  const std::vector<CaptureSet>& sets_;
  bool samePlace_;
  Measurements result_;
  std::map<std::string, std::size_t> targetIndex_, standingIndex_;
  std::vector<Placement> standingPlacement_;
};

} // namespace

Measurements measurementsOf(const std::vector<CaptureSet>& sets, const Robot& robot, bool samePlace) {
  return Collector{sets, robot, samePlace}.collect();
}

} // namespace naocal
