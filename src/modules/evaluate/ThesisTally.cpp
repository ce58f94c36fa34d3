#include "evaluate/ThesisTally.hpp"

#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>

namespace naocal {

namespace {

/// Of an angle [rad], in bins of that width.
std::size_t binOf(double angle, double first, double width, std::size_t bins) {
  const double bin = std::floor((degrees(angle) - first) / width);
  return static_cast<std::size_t>(std::clamp(bin, 0.0, static_cast<double>(bins - 1)));
}

template <typename Bins> void addBins(const std::vector<Bins>& more, std::vector<Bins>& sum) {
  sum.resize(std::max(sum.size(), more.size()));
  for (std::size_t joint = 0; joint < more.size(); ++joint) {
    for (std::size_t bin = 0; bin < more[joint].size(); ++bin) {
      sum[joint][bin] += more[joint][bin];
    }
  }
}

} // namespace

void ThesisTally::add(const Eigen::VectorXd& offset, const ThesisAnswer& answer,
                      const std::vector<double>& limitErrors) {
  ++sets;
  ++status[static_cast<std::size_t>(answer.status(radians(toleranceDegrees(statusTolerance))))];
  limitDraws += limitErrors.size();
  errors.resize(std::max(errors.size(), static_cast<std::size_t>(answer.errors.size())));
  for (std::size_t joint = 0; joint < static_cast<std::size_t>(answer.errors.size()); ++joint) {
    ++errors[joint][binOf(answer.errors[at(joint)], firstErrorDegrees, errorBinDegrees, errorBins)];
  }
  offsets.resize(static_cast<std::size_t>(offset.size()));
  for (std::size_t joint = 0; joint < offsets.size(); ++joint) {
    ++offsets[joint][binOf(offset[at(joint)], firstOffsetDegrees, offsetBinDegrees, offsetBins)];
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
  addBins(other.errors, errors);
  addBins(other.offsets, offsets);
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
