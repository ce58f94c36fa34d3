#include "measurements/FailedReadings.hpp"

#include "math/Statistics.hpp"
#include "measurements/CaptureReading.hpp"
#include "measurements/FrameRegistry.hpp"
#include "robot/Kinematics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <map>
#include <tuple>

namespace naocal {

namespace {

/// A target's way, by the drawing, that is a move [m]: ten times the last digit of tables in whole millimetres.
constexpr double moved = 0.01;

/// One reading, and where the drawing has its target.
struct TargetReading {
  std::size_t capture = 0;
  Seconds time{0};
  std::array<double, 7> value{}; // position [m] and quaternion, as written
  std::size_t stance = 0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); // of the target in the support's frame, by the drawing [m]

  Eigen::Vector3d xyz() const { return {value[0], value[1], value[2]}; }
  bool isAtOrigin() const { return value[0] == 0 && value[1] == 0 && value[2] == 0; }
};

bool hasMoved(const TargetReading& one, const TargetReading& other) {
  return one.stance != other.stance || (one.place - other.place).norm() > moved;
}

/// Readings in the order of time, by tracker and target; markers and frames apart.
using ReadingsByTarget = std::map<std::tuple<bool, std::string, std::string>, std::vector<TargetReading>>;

/// Places targets by the drawing.
class DrawnPlaces {
public:
  DrawnPlaces(const CaptureSet& set, const Robot& robot) : set_{set}, robot_{robot}, frames_{{set}, robot, false} {}

  /// Adds a capture's readings.
  void collect(std::size_t index, ReadingsByTarget& readings) const {
    const Capture& capture = set_.captures[index];
    if ((capture.points.empty() && capture.frames.empty()) || !capture.source) {
      return; // without a source it is planned: its readings are still to come
    }
    const LinkPoses poses = forwardKinematics(robot_, anglesOf(capture));
    const std::size_t stance = frames_.stanceIndex(set_, capture.stance);
    const RigidTransform supportFromTorso =
        poses[frames_.stances()[stance].supportLink.value_or(robot_.base)].inverse();
    const auto add = [&](bool isFrame, const auto& reading, const std::string& target, std::size_t link,
                         const Eigen::Vector3d& inLink, const Eigen::Quaterniond& turn) {
      readings[{isFrame, reading.tracker, target}].push_back(
          {index,
           capture.time,
           {reading.xyz.x(), reading.xyz.y(), reading.xyz.z(), turn.w(), turn.x(), turn.y(), turn.z()},
           stance,
           supportFromTorso * (poses[link] * inLink)});
    };
    for (const PointReading& reading : capture.points) {
      const MarkerInstance& marker = findInstance(frames_.instruments().markers, reading.marker);
      add(false, reading, reading.marker, marker.link, marker.marker.point.value_or(marker.marker.pointGuess),
          Eigen::Quaterniond::Identity());
    }
    for (const FrameReading& reading : capture.frames) {
      add(true, reading, reading.frame, findInstance(frames_.instruments().frames, reading.frame).link,
          Eigen::Vector3d::Zero(), reading.rotation);
    }
  }

private:
  template <typename Instance>
  static const Instance& findInstance(const std::vector<Instance>& instances, const std::string& name) {
    return instances[indexOf(instances, name)];
  }

  /// Measured angles, or rest angles where not recorded.
  Eigen::VectorXd anglesOf(const Capture& capture) const {
    Eigen::VectorXd angles = measuredAngles(robot_, set_, capture);
    for (std::size_t joint = 0; joint < robot_.joints.size(); ++joint) {
      double& angle = angles[static_cast<Eigen::Index>(joint)];
      angle = std::isnan(angle) ? robot_.joints[joint].restAngle : angle;
    }
    return angles;
  }

  const CaptureSet& set_;
  const Robot& robot_;
  FrameRegistry frames_;
};

ReadingsByTarget collectReadings(const CaptureSet& set, const Robot& robot) {
  ReadingsByTarget readings;
  const DrawnPlaces places{set, robot};
  for (std::size_t index = 0; index < set.captures.size(); ++index) {
    places.collect(index, readings);
  }
  for (auto& [key, all] : readings) {
    std::stable_sort(all.begin(), all.end(),
                     [](const TargetReading& one, const TargetReading& other) { return one.time < other.time; });
  }
  return readings;
}

/// By how much a reading's distances from the others differ from those of the target's places: median [m]. Absent with
/// fewer than three others of its stance.
std::optional<double> strain(const TargetReading& reading, const std::vector<TargetReading>& others) {
  std::vector<double> differences;
  for (const TargetReading& other : others) {
    if (other.capture != reading.capture && other.stance == reading.stance) {
      differences.push_back(std::abs((other.xyz() - reading.xyz()).norm() - (other.place - reading.place).norm()));
    }
  }
  return differences.size() < 3 ? std::nullopt : std::optional{medianOf(differences)};
}

/// Whether readings at the origin, all of one place, do not lie there as the other readings lie where they do.
bool isStrained(const TargetReading& atOrigin, const std::vector<TargetReading>& others) {
  constexpr double factor = 3;
  constexpr std::size_t most = 200; // readings to compare: the cost grows with their square
  std::vector<TargetReading> some;
  for (std::size_t i = 0; i < others.size(); i += 1 + others.size() / most) {
    some.push_back(others[i]);
  }
  std::vector<double> usual;
  for (const TargetReading& one : some) {
    if (const auto own = strain(one, some)) {
      usual.push_back(*own);
    }
  }
  const auto here = strain(atOrigin, some);
  return here && !usual.empty() && *here > std::max(moved, factor * medianOf(usual));
}

/// Readings at the origin that are none; leaves the other readings in `readings`.
std::vector<std::size_t> takeAtOrigin(std::vector<TargetReading>& readings) {
  std::vector<TargetReading> others;
  std::vector<std::size_t> captures;
  const TargetReading* first = nullptr;
  bool isNone = false;
  for (const TargetReading& reading : readings) {
    if (!reading.isAtOrigin()) {
      others.push_back(reading);
      continue;
    }
    first = first ? first : &reading;
    isNone |= hasMoved(*first, reading);
    captures.push_back(reading.capture);
  }
  if (!first || others.empty() || !(isNone || isStrained(*first, others))) {
    return {};
  }
  readings = std::move(others);
  return captures;
}

/// Readings that repeat an earlier one although the target moved.
std::vector<std::size_t> findFrozen(const std::vector<TargetReading>& readings) {
  std::map<std::array<double, 7>, std::vector<std::size_t>> equal; // indices, in the order of time
  for (std::size_t i = 0; i < readings.size(); ++i) {
    equal[readings[i].value].push_back(i);
  }
  std::vector<std::size_t> captures;
  for (const auto& [value, all] : equal) {
    const TargetReading& first = readings[all.front()];
    std::vector<std::size_t> stay, frozen;
    for (const std::size_t i : all) {
      (hasMoved(first, readings[i]) ? frozen : stay).push_back(readings[i].capture);
    }
    const bool comesBack = !frozen.empty() && all.back() - all.front() + 1 > all.size();
    captures.insert(captures.end(), frozen.begin(), frozen.end());
    if (comesBack) { // the value of "nothing", and no reading that stood still
      captures.insert(captures.end(), stay.begin(), stay.end());
    }
  }
  return captures;
}

} // namespace

std::vector<FailedReadings> findFailedReadings(const CaptureSet& set, const Robot& robot) {
  std::vector<FailedReadings> result;
  if (set.instruments.trackers.empty()) {
    return result;
  }
  ReadingsByTarget readings = collectReadings(set, robot);
  for (auto& [key, all] : readings) {
    const auto& [isFrame, tracker, target] = key;
    const std::size_t count = all.size();
    const auto add = [&, &by = tracker, &of = target](FailedReadings::Kind kind, std::vector<std::size_t> captures) {
      if (!captures.empty()) {
        std::sort(captures.begin(), captures.end());
        result.push_back({kind, by, of, std::move(captures), count});
      }
    };
    add(FailedReadings::Kind::origin, takeAtOrigin(all));
    add(FailedReadings::Kind::frozen, findFrozen(all));
  }
  return result;
}

void removeFailedReadings(const std::vector<FailedReadings>& failed, CaptureSet& set) {
  for (const FailedReadings& one : failed) {
    for (const std::size_t index : one.captures) {
      Capture& capture = set.captures[index];
      std::erase_if(capture.points, [&](const PointReading& reading) {
        return reading.tracker == one.tracker && reading.marker == one.target;
      });
      std::erase_if(capture.frames, [&](const FrameReading& reading) {
        return reading.tracker == one.tracker && reading.frame == one.target;
      });
    }
  }
}

std::string describeFailedReadings(const FailedReadings& failed, const std::string& where) {
  const bool isOne = failed.captures.size() == 1;
  const std::string what =
      failed.kind == FailedReadings::Kind::origin
          ? fmt::format("{} exactly 0, 0, 0", isOne ? "is" : "are")
          : fmt::format("{} an earlier one in every digit although the robot moved", isOne ? "repeats" : "repeat");
  return fmt::format("{} of {} readings of {} by {} {}: taken as no reading and left out: {}", failed.captures.size(),
                     failed.all, failed.target, failed.tracker, what, where);
}

std::string describeFailedReadings(const FailedReadings& failed, const CaptureSet& set) {
  std::vector<int> ids;
  for (const std::size_t index : failed.captures) {
    ids.push_back(set.captures[index].id);
  }
  return describeFailedReadings(failed,
                                fmt::format("{} {}", ids.size() == 1 ? "capture" : "captures", fmt::join(ids, ", ")));
}

} // namespace naocal
