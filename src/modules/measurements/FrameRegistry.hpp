#pragma once

#include "measurements/Measurements.hpp"

#include <map>
#include <string>
#include <vector>

namespace naocal {

/// The boards and stances of all sets, each once, and which of their placements are unknown.
///
/// If a set surveys nothing, the frame of the first floor board seen (in the order of the boards' list) is its world.
class FrameRegistry {
public:
  /// `samePlace` joins boards and stances of equal ids over the sets.
  /// Throws InputError for a board on a link that the robot lacks.
  FrameRegistry(const std::vector<CaptureSet>& sets, const Robot& robot, bool samePlace);

  std::size_t targetIndex(const CaptureSet& set, const std::string& board) const;
  std::size_t stanceIndex(const CaptureSet& set, int stance) const;
  const std::vector<Target>& targets() const { return targets_; }
  const std::vector<StanceInstance>& stances() const { return standings_; }

private:
  std::string scopedId(const CaptureSet& set, const std::string& id) const;
  void addTargets(const CaptureSet& set, const Robot& robot);
  void addStances(const CaptureSet& set);
  void fixWorld(const std::vector<CaptureSet>& sets);

  bool oneScope_;
  std::vector<Target> targets_;
  std::vector<StanceInstance> standings_;
  std::map<std::string, std::size_t> targetByName_, standingByName_;
};

} // namespace naocal
