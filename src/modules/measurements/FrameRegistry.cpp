#include "measurements/FrameRegistry.hpp"

#include "io/InputError.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace naocal {

namespace {

/// Whether the robot's base stands in the world, instead of a sole.
bool isBaseStanding(const CaptureSet& set, const Stance& stance) {
  return !set.urdf.empty() && stance.supportLinks.empty();
}

/// Whether a placement or the base itself defines the world frame.
bool isSurveyed(const CaptureSet& set) {
  return std::any_of(set.boards.begin(), set.boards.end(),
                     [](const Board& board) { return board.link == "floor" && board.placement.has_value(); }) ||
         std::any_of(set.stances.begin(), set.stances.end(),
                     [&](const Stance& stance) { return stance.placement.has_value() || isBaseStanding(set, stance); });
}

/// Whether a list has an entry of this name.
template <typename Entry> bool hasName(const std::vector<Entry>& entries, const std::string& name) {
  return std::any_of(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.name == name; });
}

/// Links that stand in the world in a stance: the base, or the soles on the floor, the one that counts as still first.
std::vector<std::size_t> supportLinks(const CaptureSet& set, const Stance& stance, const Robot& robot) {
  if (isBaseStanding(set, stance)) {
    return {robot.base};
  }
  std::vector<std::size_t> result;
  for (const std::string& link : stance.supportLinks) {
    const Sole* const sole = robot.findSole(link);
    result.push_back(sole ? sole->link
                          : requireLink(robot, fmt::format("{}: stances[{}].supportLinks", set.name, stance.id), link));
  }
  if (stance.supportFoot == SupportFoot::left || stance.supportFoot == SupportFoot::both) {
    result.push_back(robot.findSole("left")->link);
  }
  if (stance.supportFoot == SupportFoot::right || stance.supportFoot == SupportFoot::both) {
    result.push_back(robot.findSole("right")->link);
  }
  return result; // empty: a hanging robot gives no information about the floor
}

} // namespace

FrameRegistry::FrameRegistry(const std::vector<CaptureSet>& sets, const Robot& robot, bool samePlace)
    : oneScope_{sets.size() == 1 || samePlace} {
  for (const CaptureSet& set : sets) {
    addTargets(set, robot);
    addStances(set, robot);
    addInstruments(set, robot);
  }
  fixWorld(sets);
}

std::size_t FrameRegistry::targetIndex(const CaptureSet& set, const std::string& board) const {
  return targetByName_.at(scopedId(set, board));
}

std::size_t FrameRegistry::stanceIndex(const CaptureSet& set, int stance) const {
  return standingByName_.at(scopedId(set, std::to_string(stance)));
}

std::string FrameRegistry::scopedId(const CaptureSet& set, const std::string& id) const {
  return oneScope_ ? id : set.name + "/" + id;
}

void FrameRegistry::addTargets(const CaptureSet& set, const Robot& robot) {
  for (const Board& board : set.boards) {
    const std::string name = scopedId(set, board.id);
    if (targetByName_.contains(name)) {
      continue;
    }
    const bool isFlat = board.link == "floor", inWorld = isFlat || board.link == "world";
    if (!inWorld) {
      requireLink(robot, fmt::format("{}: boards[{}].link", set.name, board.id), board.link);
    }
    targetByName_[name] = targets_.size();
    targets_.push_back({name, board, inWorld, isFlat, !board.placement.has_value()});
  }
}

void FrameRegistry::addStances(const CaptureSet& set, const Robot& robot) {
  for (const Stance& stance : set.stances) {
    const std::string name = scopedId(set, std::to_string(stance.id));
    if (standingByName_.contains(name)) {
      continue;
    }
    standingByName_[name] = standings_.size();
    const bool isBase = isBaseStanding(set, stance);
    const bool isWorld = isBase && std::none_of(standings_.begin(), standings_.end(),
                                                [](const StanceInstance& other) { return !other.isFlat; });
    const std::vector<std::size_t> support = supportLinks(set, stance, robot);
    standings_.push_back({.name = name,
                          .supportFoot = stance.supportFoot,
                          .supportLink = support.empty() ? std::nullopt : std::optional{support.front()},
                          .furtherSoles = {support.begin() + (support.empty() ? 0 : 1), support.end()},
                          .isFlat = !isBase,
                          .unknown = !stance.placement && !support.empty() && !isWorld,
                          .placement = stance.placement.value_or(Placement{})});
  }
}

void FrameRegistry::addInstruments(const CaptureSet& set, const Robot& robot) {
  for (const Tracker& tracker : set.instruments.trackers) {
    if (const std::string name = scopedId(set, tracker.id); !hasName(instruments_.trackers, name)) {
      instruments_.trackers.push_back({name, tracker, {}});
    }
  }
  for (const TrackedMarker& marker : set.instruments.markers) {
    if (const std::string name = scopedId(set, marker.id); !hasName(instruments_.markers, name)) {
      const std::size_t link =
          requireLink(robot, fmt::format("{}: markers[{}].link", set.name, marker.id), marker.link);
      instruments_.markers.push_back({name, link, marker, marker.point.value_or(marker.pointGuess)});
    }
  }
  for (const TrackedFrame& frame : set.instruments.frames) {
    if (const std::string name = scopedId(set, frame.id); !hasName(instruments_.frames, name)) {
      const std::size_t link = requireLink(robot, fmt::format("{}: frames[{}].link", set.name, frame.id), frame.link);
      instruments_.frames.push_back({name, link, frame, {}});
    }
  }
  for (const ContactPlace& place : set.instruments.places) {
    if (const std::string name = scopedId(set, place.id); !hasName(instruments_.places, name)) {
      instruments_.places.push_back({name, place, place.point.value_or(Eigen::Vector3d::Zero())});
    }
  }
}

void FrameRegistry::fixWorld(const std::vector<CaptureSet>& sets) {
  std::set<std::string> seen;
  for (const CaptureSet& set : sets) {
    for (const Capture& capture : set.captures) {
      for (const BoardCorners& corners : capture.corners.value_or(std::vector<BoardCorners>{})) {
        if (!corners.ids.empty()) {
          seen.insert(scopedId(set, corners.board));
        }
      }
    }
  }
  for (const CaptureSet& set : sets) {
    for (const Board& board : set.boards) {
      Target& target = targets_[targetIndex(set, board.id)];
      if (!isSurveyed(set) && target.isFlat && seen.contains(target.name)) {
        target.unknown = false;
        target.board.placement = Placement{};
        break;
      }
    }
    if (oneScope_) { // all sets share the world frame of the first one
      return;
    }
  }
}

} // namespace naocal
