#include "residuals/Measurements.hpp"

#include "captures/InputError.hpp"
#include "residuals/Grouping.hpp"
#include "residuals/Places.hpp"
#include "residuals/RecordedPicture.hpp"

#include <fmt/format.h>

namespace naocal {

namespace {

void refuseOtherRobots(const std::vector<CaptureSet>& sets) {
  const CaptureSet& first = sets.front();
  for (const CaptureSet& set : sets) {
    if (set.bodyId != first.bodyId || set.headId != first.headId || set.model != first.model) {
      throw InputError{fmt::format(
          "{}: robot: expected the robot of {} (model {}, body {}, head {}), found model {}, body "
          "{}, head {}; sets given together must be of one robot",
          set.name, first.name, first.model, first.bodyId, first.headId, set.model, set.bodyId, set.headId)};
    }
  }
}

} // namespace

Measurements measurementsOf(const std::vector<CaptureSet>& sets, const Robot& robot, bool samePlace) {
  refuseOtherRobots(sets);
  const Places places{sets, robot, samePlace};
  Measurements result;
  result.robot = robot;
  result.quantities = Quantities{robot.joints.size(), robot.lengths.size(), places.targets().size()};
  result.targets = places.targets();
  result.standings = places.standings();
  for (std::size_t set = 0; set < sets.size(); ++set) {
    for (std::size_t capture = 0; capture < sets[set].captures.size(); ++capture) {
      result.pictures.push_back(recordedPicture(sets, set, capture, result, places));
      for (const Sighting& sighting : result.pictures.back().sightings) {
        result.cornerCount += sighting.ids.size();
      }
    }
  }
  groupReadings(sets, result);
  return result;
}

} // namespace naocal
