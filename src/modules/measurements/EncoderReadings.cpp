#include "measurements/EncoderReadings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
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

/// Evenly spaced positions, each with its share exp(logs - log) of the integral.
struct RestReadings::LikelyPlaces {
  static constexpr std::size_t points = 80;
  std::array<double, points> x{}, shares{};
  double sum = 0; // of the shares
  double log = 0; // of P(readings | x) dx at the likeliest position
};

/// The product of many readings' probabilities is smaller than any number, so their logarithms are added.
RestReadings::LikelyPlaces RestReadings::placesWithin(double low, double high, double jitter) const {
  constexpr double least = 1e-300; // of a reading's probability: its logarithm stays finite
  LikelyPlaces places;
  for (std::size_t i = 0; i < LikelyPlaces::points; ++i) {
    places.x[i] = low + (high - low) * (static_cast<double>(i) + 0.5) / LikelyPlaces::points;
    places.shares[i] = std::log((high - low) / LikelyPlaces::points);
    for (const auto& [step, count] : counts_) {
      places.shares[i] += count * std::log(std::max(least, probability(step, places.x[i], jitter)));
    }
  }
  places.log = *std::max_element(places.shares.begin(), places.shares.end());
  for (double& share : places.shares) {
    share = std::exp(share - places.log);
    places.sum += share;
  }
  return places;
}

/// Positions over the range that the readings allow; closer ones around the likeliest where many readings narrow it.
RestReadings::LikelyPlaces RestReadings::placesAt(double jitter) const {
  constexpr double counts = 1e-8; // of a share
  constexpr std::ptrdiff_t enough = 10;
  constexpr int finest = 6; // each time at least six times closer
  LikelyPlaces places = placesWithin(-0.5 - 3 * jitter, highest() + 0.5 + 3 * jitter, jitter);
  const auto isUnlikely = [&](double share) { return share < counts; };
  for (int closer = 0; closer < finest; ++closer) {
    const auto peak = std::max_element(places.shares.begin(), places.shares.end());
    const auto last = std::find_if(peak, places.shares.end(), isUnlikely);
    const auto first = std::find_if(std::make_reverse_iterator(peak), places.shares.rend(), isUnlikely).base();
    if (last - first >= enough) {
      break;
    }
    const double cell = places.x[1] - places.x[0];
    const auto placeOf = [&](auto share) { return places.x[static_cast<std::size_t>(share - places.shares.begin())]; };
    places = placesWithin(placeOf(first) - 1.5 * cell, placeOf(last - 1) + 1.5 * cell, jitter);
  }
  return places;
}

double RestReadings::logLikelihood(double jitter) const {
  const LikelyPlaces places = placesAt(jitter);
  return places.log + std::log(places.sum);
}

RestReadings::Place RestReadings::place(double jitter) const {
  // Readings farther apart than this jitter allows: widen it. Entropy of a reading with the widest jitter: below 4
  // nats.
  double count = 0;
  for (const auto& [step, readings] : counts_) {
    count += readings;
  }
  const double least = -230 - 4 * count; // e^-230: 1e-100
  double likely = std::max(jitter / encoderStep_, leastJitter);
  LikelyPlaces places = placesAt(likely);
  while (places.log < least) {
    places = placesAt(likely *= jitterRatio);
  }
  double mean = 0, square = 0;
  for (std::size_t i = 0; i < LikelyPlaces::points; ++i) {
    const double share = places.shares[i] / places.sum;
    mean += share * places.x[i];
    square += share * places.x[i] * places.x[i];
  }
  return {lowest_ + encoderStep_ * mean, encoderStep_ * encoderStep_ * std::max(0.0, square - mean * mean)};
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
