#include "measurements/EncoderReadings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace naocal {

namespace {

/// Grid of jitter levels in encoder steps: 0.02 (hidden by rounding) to 8 (0.7 degrees).
constexpr double leastJitter = 0.02, jitterRatio = 1.35;
constexpr int jitterLevels = 21;

double jitterLevel(int index) {
  return leastJitter * std::pow(jitterRatio, index);
}

/// Probability that a rounded normal reading at `x` equals step `k`.
double probability(int k, double x, double jitter) {
  const double scale = 1 / (jitter * std::numbers::sqrt2), away = std::abs(x - k);
  return 0.5 * (std::erfc((away - 0.5) * scale) - std::erfc((away + 0.5) * scale));
}

/// Maximum of a curve over the jitter levels, with parabolic interpolation [steps].
double peakOf(const std::vector<double>& curve) {
  const auto best = std::max_element(curve.begin(), curve.end()) - curve.begin();
  double shift = 0;
  if (best > 0 && best + 1 < jitterLevels) {
    const double before = curve[static_cast<std::size_t>(best - 1)], here = curve[static_cast<std::size_t>(best)],
                 after = curve[static_cast<std::size_t>(best + 1)];
    const double bend = before - 2 * here + after;
    shift = bend < 0 ? 0.5 * (before - after) / bend : 0;
  }
  return leastJitter * std::pow(jitterRatio, static_cast<double>(best) + shift);
}

} // namespace

RestReadings::RestReadings(const std::vector<double>& angles, double encoderStep) : encoderStep_{encoderStep} {
  const double least = *std::min_element(angles.begin(), angles.end());
  std::map<int, int> counts;
  double beside = 0; // offset from whole steps
  for (const double angle : angles) {
    const auto step = static_cast<int>(std::lround((angle - least) / encoderStep));
    ++counts[step];
    beside += angle - least - step * encoderStep;
  }
  lowest_ = least + beside / static_cast<double>(angles.size());
  counts_.assign(counts.begin(), counts.end());
}

/// Calls visit(x, P(readings | x) dx) at evenly spaced positions over the range the readings allow.
template <class Visit> void RestReadings::visitPlaces(double jitter, const Visit& visit) const {
  constexpr int points = 80;
  const double least = -0.5 - 3 * jitter, most = highest() + 0.5 + 3 * jitter;
  for (int i = 0; i < points; ++i) {
    const double x = least + (most - least) * (i + 0.5) / points;
    double product = (most - least) / points;
    for (const auto& [step, count] : counts_) {
      product *= std::pow(std::max(0.0, probability(step, x, jitter)), count);
    }
    visit(x, product);
  }
}

double RestReadings::logLikelihood(double jitter) const {
  double sum = 0;
  visitPlaces(jitter, [&](double, double probability) { sum += probability; });
  return std::log(std::max(sum, 1e-300));
}

RestReadings::Place RestReadings::place(double jitter) const {
  double sum = 0, mean = 0, square = 0;
  // readings farther apart than this jitter allows: widen it
  for (double likely = std::max(jitter / encoderStep_, leastJitter); sum < 1e-100; likely *= jitterRatio) {
    sum = mean = square = 0;
    visitPlaces(likely, [&](double x, double probability) {
      sum += probability;
      mean += probability * x;
      square += probability * x * x;
    });
  }
  mean /= sum;
  return {lowest_ + encoderStep_ * mean, encoderStep_ * encoderStep_ * std::max(0.0, square / sum - mean * mean)};
}

std::vector<double> estimateEncoderJitter(const std::vector<std::vector<RestReadings>>& rests) {
  constexpr double spread = 0.4; // 1 sigma of ln(level) between joints
  std::map<std::vector<std::pair<int, int>>, std::vector<double>> known;
  std::vector<std::vector<double>> curves;
  std::vector<double> together(jitterLevels, 0.0);
  bool differ = false;
  for (const std::vector<RestReadings>& joint : rests) {
    curves.emplace_back(jitterLevels, 0.0);
    for (const RestReadings& rest : joint) {
      differ |= rest.differ();
    }
  }
  if (!differ) {
    return std::vector<double>(rests.size(), 0.0);
  }
  for (std::size_t joint = 0; joint < rests.size(); ++joint) {
    for (const RestReadings& rest : rests[joint]) {
      auto [entry, isNew] = known.try_emplace(rest.pattern());
      for (int i = 0; isNew && i < jitterLevels; ++i) {
        entry->second.push_back(rest.logLikelihood(jitterLevel(i)));
      }
      for (std::size_t i = 0; i < jitterLevels; ++i) {
        curves[joint][i] += entry->second[i];
        together[i] += entry->second[i];
      }
    }
  }
  const double common = peakOf(together);
  std::vector<double> result;
  for (std::size_t joint = 0; joint < rests.size(); ++joint) {
    std::vector<double>& curve = curves[joint];
    for (int i = 0; i < jitterLevels; ++i) {
      const double away = std::log(jitterLevel(i) / common) / spread;
      curve[static_cast<std::size_t>(i)] -= 0.5 * away * away;
    }
    result.push_back(rests[joint].empty() ? 0.0 : peakOf(curve) * rests[joint].front().encoderStep());
  }
  return result;
}

} // namespace naocal
