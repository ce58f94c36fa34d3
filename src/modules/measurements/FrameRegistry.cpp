#include "measurements/FrameRegistry.hpp"

#include "io/InputError.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace naocal {

namespace {

bool isSurveyed(const CaptureSet& set) {
  return std::any_of(set.boards.begin(), set.boards.end(),
                     [](const Board& board) { return board.link == "floor" && board.placement.has_value(); }) ||
         std::any_of(set.stances.begin(), set.stances.end(),
                     [](const Stance& stance) { return stance.placement.has_value(); });
}

} // namespace

FrameRegistry::FrameRegistry(const std::vector<CaptureSet>& sets, const Robot& robot, bool samePlace)
    : oneScope_{sets.size() == 1 || samePlace} {
  for (const CaptureSet& set : sets) {
    addTargets(set, robot);
    addStances(set);
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
    const bool onFloor = board.link == "floor";
    if (!onFloor && !robot.linkIndex(board.link)) {
      throw InputError{
          fmt::format("{}: boards[{}].link: the {} has no link '{}'", set.name, board.id, robot.model, board.link)};
    }
    targetByName_[name] = targets_.size();
    targets_.push_back({name, board, onFloor, !board.placement.has_value()});
  }
}

void FrameRegistry::addStances(const CaptureSet& set) {
  for (const Stance& stance : set.stances) {
    const std::string name = scopedId(set, std::to_string(stance.id));
    if (standingByName_.contains(name)) {
      continue;
    }
    standingByName_[name] = standings_.size();
    standings_.push_back({name, stance.supportFoot, !stance.placement && stance.supportFoot != SupportFoot::none,
                          stance.placement.value_or(Placement{})});
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
      if (!isSurveyed(set) && target.onFloor && seen.contains(target.name)) {
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
