#include "evaluate/ThesisTally.hpp"

#include <algorithm>

namespace naocal {

void ThesisTally::add(const ThesisAnswer& answer, const std::vector<double>& limitErrors) {
  ++sets;
  ++status[static_cast<std::size_t>(answer.status(radians(toleranceDegrees(statusTolerance))))];
  limitDraws += limitErrors.size();
  for (std::size_t i = 0; i < toleranceCount; ++i) {
    const double tolerance = radians(toleranceDegrees(i));
    success[i] += answer.status(tolerance) == ThesisStatus::success;
    limit[i] += static_cast<std::size_t>(
        std::count_if(limitErrors.begin(), limitErrors.end(), [&](double error) { return error <= tolerance; }));
  }
}

void ThesisTally::add(const ThesisTally& other) {
  sets += other.sets;
  limitDraws += other.limitDraws;
  seconds += other.seconds;
  for (std::size_t i = 0; i < status.size(); ++i) {
    status[i] += other.status[i];
  }
  for (std::size_t i = 0; i < toleranceCount; ++i) {
    success[i] += other.success[i];
    limit[i] += other.limit[i];
  }
}

double ThesisTally::successAt(std::size_t tolerance) const {
  return sets > 0 ? static_cast<double>(success[tolerance]) / static_cast<double>(sets) : 0;
}

double ThesisTally::limitAt(std::size_t tolerance) const {
  return limitDraws > 0 ? static_cast<double>(limit[tolerance]) / static_cast<double>(limitDraws) : 0;
}

} // namespace naocal
