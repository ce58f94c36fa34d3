#include "calibration/result/Assumptions.hpp"

#include "calibration/BoardMoves.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace naocal {

bool reliesOnOrder(const Measurements& measurements, const Term& term) {
  return measurements.approachesFromOrder > 0 &&
         anyDriver(term.effect, [](Driver driver) { return driver == Driver::approach; });
}

std::vector<std::string> describeAssumptions(const Measurements& measurements, const std::vector<Term>& terms) {
  std::vector<std::string> result;
  for (std::size_t set = 0; set < measurements.failedReadings.size(); ++set) {
    for (const FailedReadings& failed : measurements.failedReadings[set]) {
      const CaptureSet& of = (*measurements.sets)[set];
      result.push_back(describeFailedReadings(failed, of) +
                       (measurements.sets->size() > 1 ? " of " + of.name : std::string{}));
    }
  }
  if (std::any_of(terms.begin(), terms.end(), [&](const Term& term) { return reliesOnOrder(measurements, term); })) {
    result.push_back(fmt::format("the direction of approach was taken from the order of captures, as {} of {} record "
                                 "none; where the robot moved elsewhere in between, it is wrong",
                                 measurements.approachesFromOrder, measurements.pictures.size()));
  }
  return result;
}

std::vector<std::string> describeDisplacedBoards(const Measurements& measurements, const CalibrationResult& result) {
  std::vector<std::string> sentences;
  for (const Outlier& outlier : result.outliers) {
    if (outlier.move) {
      sentences.push_back(describeDisplacedBoard(measurements, outlier) + ": left out there");
    }
  }
  return sentences;
}

} // namespace naocal
