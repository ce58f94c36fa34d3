#pragma once

#include "measurements/Measurements.hpp"

#include <map>
#include <string>
#include <vector>

namespace naocal {

/// All boards and stances of the sets, without duplicates, and which placements are unknown.
///
/// If nothing in a set is surveyed, the first floor board with corners (in the order of its board list) defines the
/// world frame.
class FrameRegistry {
public:
  /// `samePlace` merges boards and stances of equal id across sets. Throws InputError for a board on a link that the
  /// robot lacks.
  FrameRegistry(const std::vector<CaptureSet>& sets, const Robot& robot, bool samePlace);

  /// Index of a set's board in `targets()`, or stance in `stances()`.
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
