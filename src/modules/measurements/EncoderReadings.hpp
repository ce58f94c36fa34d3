#pragma once

#include <map>
#include <vector>

namespace naocal {

/// Encoder readings of a joint at rest: a histogram of encoder steps, counted from the lowest one.
class RestReadings {
public:
  /// `angles`: readings [rad], at least one; `encoderStep` [rad]. Interpolated readings (a picture's time lies between
  /// two encoder readings) fall between steps and count as the nearest step.
  RestReadings(const std::vector<double>& angles, double encoderStep);

  /// Whether the readings differ and thus carry information on the encoder's jitter.
  bool differ() const { return counts_.size() > 1; }
  double encoderStep() const { return encoderStep_; }  // [rad]
  int highest() const { return counts_.back().first; } // in steps above the lowest one
  /// Log-likelihood of the readings, with the joint's true position integrated out:
  ///   ln Int Prod_i [Phi((k_i + 1/2 - x) / jitter) - Phi((k_i - 1/2 - x) / jitter)] dx,   jitter and x in steps
  /// (the likelihood of rounded normal readings: Sheppard, Proc. London Math. Soc. 29 (1898) 353).
  double logLikelihood(double jitter) const;

  /// Position of the joint given the readings: posterior mean and variance under a flat prior.
  struct Place {
    double angle = 0, variance = 0; // [rad], [rad^2]
  };
  Place place(double jitter) const;
  /// The histogram. Equal patterns have equal likelihoods.
  const std::vector<std::pair<int, int>>& pattern() const { return counts_; }

private:
  struct LikelyPlaces;
  LikelyPlaces placesWithin(double low, double high, double jitter) const;
  LikelyPlaces placesAt(double jitter) const;

  double encoderStep_ = 0;
  double lowest_ = 0;                       // angle of step 0: mean of all readings minus their steps [rad]
  std::vector<std::pair<int, int>> counts_; // (step, number of readings)
};

/// Jitter of each joint's encoder at rest [rad], from `rests[joint]`: the most likely level, shrunk towards the level
/// common to all joints, since few rests determine a joint's level only roughly (prior: encoders of the same type,
/// levels within a factor of 1.5, 1 sigma). 0 for all joints if readings never differ within a rest.
std::vector<double> estimateEncoderJitter(const std::vector<std::vector<RestReadings>>& rests);

} // namespace naocal
