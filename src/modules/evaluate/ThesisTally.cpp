#include "evaluate/ThesisTally.hpp"

#include "geometry/Index.hpp"

#include <algorithm>
#include <cmath>

namespace naocal {

namespace {

/// Of an error [rad].
std::size_t errorBin(double error) {
  const double bin = std::floor((degrees(error) - firstErrorDegrees) / errorBinDegrees);
  return static_cast<std::size_t>(std::clamp(bin, 0.0, static_cast<double>(errorBins - 1)));
}

} // namespace

void ThesisTally::add(const ThesisAnswer& answer, const std::vector<double>& limitErrors) {
  ++sets;
  ++status[static_cast<std::size_t>(answer.status(radians(toleranceDegrees(statusTolerance))))];
  limitDraws += limitErrors.size();
  errors.resize(std::max(errors.size(), static_cast<std::size_t>(answer.errors.size())));
  for (std::size_t joint = 0; joint < static_cast<std::size_t>(answer.errors.size()); ++joint) {
    ++errors[joint][errorBin(answer.errors[at(joint)])];
  }
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
  errors.resize(std::max(errors.size(), other.errors.size()));
  for (std::size_t joint = 0; joint < other.errors.size(); ++joint) {
    for (std::size_t bin = 0; bin < errorBins; ++bin) {
      errors[joint][bin] += other.errors[joint][bin];
    }
  }
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
