#pragma once

#include "measurements/Measurements.hpp"

#include <map>
#include <string>
#include <vector>

namespace naocal {

/// All boards, stances and instruments of the sets, without duplicates, and which placements are unknown.
///
/// The base of a robot with a URDF is the world in its first stance. Otherwise, if nothing in a set is surveyed, the
/// first floor board with corners (in the order of its board list) defines the world frame.
class FrameRegistry {
public:
  /// `samePlace` merges boards, stances and instruments of equal id across sets. Throws InputError for a board, marker
  /// or frame on a link that the robot lacks.
  FrameRegistry(const std::vector<CaptureSet>& sets, const Robot& robot, bool samePlace);

  /// Index of a set's board in `targets()`, or stance in `stances()`.
  std::size_t targetIndex(const CaptureSet& set, const std::string& board) const;
  std::size_t stanceIndex(const CaptureSet& set, int stance) const;
  const std::vector<Target>& targets() const { return targets_; }
  const std::vector<StanceInstance>& stances() const { return standings_; }
  const InstrumentList& instruments() const { return instruments_; }
  /// The name of something with this id in a set: "A", or "<set>/A".
  std::string scopedId(const CaptureSet& set, const std::string& id) const;

private:
  void addTargets(const CaptureSet& set, const Robot& robot);
  void addStances(const CaptureSet& set, const Robot& robot);
  void addInstruments(const CaptureSet& set, const Robot& robot);
  void fixWorld(const std::vector<CaptureSet>& sets);

  bool oneScope_;
  std::vector<Target> targets_;
  std::vector<StanceInstance> standings_;
  InstrumentList instruments_;
  std::map<std::string, std::size_t> targetByName_, standingByName_;
};

} // namespace naocal
