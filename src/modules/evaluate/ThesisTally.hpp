#pragma once

#include "evaluate/ThesisTrial.hpp"

#include <array>

namespace naocal {

/// Tolerances of an offset's error at which success is counted: 0.1, 0.2, ... 2.0 degrees.
constexpr std::size_t toleranceCount = 20;
constexpr double toleranceDegrees(std::size_t index) {
  return 0.1 * static_cast<double>(index + 1);
}

/// The tolerance at which statuses are counted: 0.2 degrees, that of the author's published set-up.
constexpr std::size_t statusTolerance = 1;

/// Bins of an offset's error: 0.1 degrees wide from -3 to 3, the outermost hold what is beyond.
constexpr std::size_t errorBins = 60;
constexpr double firstErrorDegrees = -3, errorBinDegrees = 0.1;

/// Bins of an offset before it is found: 0.5 degrees wide from -7 to 7.
constexpr std::size_t offsetBins = 28;
constexpr double firstOffsetDegrees = -7, offsetBinDegrees = 0.5;

/// How often a solver succeeded in a setting. Only counts, so that parts add up to the whole.
struct ThesisTally {
  std::size_t sets = 0, limitDraws = 0;
  std::array<std::size_t, 4> status{};                      // by ThesisStatus
  std::array<std::size_t, toleranceCount> success{};        // sets
  std::array<std::size_t, toleranceCount> limit{};          // draws of an efficient estimator's errors
  std::vector<std::array<std::size_t, errorBins>> errors;   // per joint: sets that were solved, by the offset's error
  std::vector<std::array<std::size_t, offsetBins>> offsets; // per joint: sets, by the offset itself
  double seconds = 0;                                       // in the solver

  void add(const Eigen::VectorXd& offsets, const ThesisAnswer& answer, const std::vector<double>& limitErrors);
  void add(const ThesisTally& other);
  double successAt(std::size_t tolerance) const; // [1]
  double limitAt(std::size_t tolerance) const;   // [1]
};

} // namespace naocal
