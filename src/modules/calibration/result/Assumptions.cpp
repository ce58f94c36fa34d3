#include "calibration/result/Assumptions.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace naocal {

bool reliesOnOrder(const Measurements& measurements, const Term& term) {
  return measurements.approachesFromOrder > 0 &&
         anyDriver(term.effect, [](Driver driver) { return driver == Driver::approach; });
}

std::vector<Finding> listAssumptions(const Measurements& measurements, const std::vector<Term>& terms) {
  std::vector<Finding> findings;
  for (std::size_t set = 0; set < measurements.failedReadings.size(); ++set) {
    for (const FailedReadings& failed : measurements.failedReadings[set]) {
      const CaptureSet& of = (*measurements.sets)[set];
      findings.push_back(makeFinding("accident",
                                     fmt::format("{}:{}:{}:{}", of.name, failed.tracker, failed.target,
                                                 failed.kind == FailedReadings::Kind::origin ? "origin" : "frozen"),
                                     FindingLevel::note,
                                     describeFailedReadings(failed, of) +
                                         (measurements.sets->size() > 1 ? " of " + of.name : std::string{}),
                                     measurements));
    }
  }
  if (std::any_of(terms.begin(), terms.end(), [&](const Term& term) { return reliesOnOrder(measurements, term); })) {
    findings.push_back(
        makeFinding("weak", "approach", FindingLevel::note,
                    fmt::format("the direction of approach was taken from the order of captures, as {} of {} record "
                                "none; where the robot moved elsewhere in between, it is wrong",
                                measurements.approachesFromOrder, measurements.pictures.size()),
                    measurements));
  }
  return findings;
}

} // namespace naocal
