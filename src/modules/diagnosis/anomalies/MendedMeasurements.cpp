#include "diagnosis/anomalies/MendedMeasurements.hpp"

#include "diagnosis/Session.hpp"
#include "estimation/ModelBuilder.hpp"
#include "setups/Mending.hpp"

#include <algorithm>
#include <utility>

namespace naocal {

MendedMeasurements mendMeasurements(const std::shared_ptr<const Measurements>& given,
                                    const std::vector<std::string>& with) {
  MendedMeasurements result{given, with, {}};
  if (std::any_of(with.begin(), with.end(), isSetUp)) {
    std::vector<CaptureSet> sets = *given->sets;
    Robot robot = given->robot;
    result.setUps = mendSetUps(result.effects, robot, sets);
    result.measurements =
        std::make_shared<const Measurements>(buildMeasurements(std::move(sets), robot, given->samePlace));
  }
  return result;
}

std::vector<std::string> termLabels(const MendedMeasurements& mended, const std::vector<std::string>& without,
                                    const std::vector<Effect>& effects) {
  std::vector<std::string> labels = termLabels(buildModel(*mended.measurements, mended.effects, without, effects));
  labels.insert(labels.end(), mended.setUps.begin(), mended.setUps.end());
  return labels;
}

} // namespace naocal
