#include "measurements/WitnessSource.hpp"

#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace naocal {

std::size_t WitnessSource::level(const std::string& name, ReadingLevel::Unit unit, std::optional<double> sigma,
                                 double start) {
  std::vector<ReadingLevel>& levels = measurements.levels;
  const auto known = std::find_if(levels.begin(), levels.end(),
                                  [&](const ReadingLevel& level) { return level.name == name && level.unit == unit; });
  if (known == levels.end()) {
    levels.push_back({name, unit, sigma.value_or(start), sigma.has_value()});
    return levels.size() - 1;
  }
  return static_cast<std::size_t>(known - levels.begin());
}

ObservationChain WitnessSource::viewOf(std::size_t link, const std::string& what) const {
  const auto support = measurements.stances[stance].supportLink;
  if (!support) {
    throw InputError{fmt::format("{}: capture {}: expected a stance that stands in the world, where {} is measured, "
                                 "found one that hangs",
                                 set.name, capture.id, what)};
  }
  ObservationChain view = ObservationChain::betweenLinks(measurements.robot, measurements.quantities, link, *support);
  for (const std::size_t joint : view.joints()) {
    if (std::isnan(recorded[eigenIndex(joint)])) {
      throw InputError{fmt::format("{}: capture {}: joints.measured: {} was not recorded but {} is measured along it",
                                   set.name, capture.id, measurements.robot.joints[joint].name, what)};
    }
  }
  return view;
}

const std::vector<void (*)(WitnessSource&)>& witnessKinds() {
  static const std::vector<void (*)(WitnessSource&)> all{addTrackerPoints, addTrackerFrames, addContacts};
  return all;
}

} // namespace naocal
