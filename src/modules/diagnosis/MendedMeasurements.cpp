#include "diagnosis/MendedMeasurements.hpp"

#include "diagnosis/SetUps.hpp"

#include <utility>

namespace naocal {

MendedMeasurements mendMeasurements(const std::shared_ptr<const Measurements>& given,
                                    const std::vector<std::string>& with) {
  MendedMeasurements result{given, with, {}};
  std::vector<CaptureSet> sets = *given->sets;
  result.setUps = mendSetUps(result.effects, given->robot, sets);
  if (!result.setUps.empty()) {
    result.measurements =
        std::make_shared<const Measurements>(buildMeasurements(std::move(sets), given->robot, given->samePlace));
  }
  return result;
}

} // namespace naocal
