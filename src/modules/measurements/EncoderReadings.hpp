#pragma once

#include <map>
#include <vector>

namespace naocal {

/// An encoder's readings while its joint rested: how often each step was read, steps counted from the lowest one.
class RestReadings {
public:
  /// `angles`: as read [rad], at least one. Readings taken between two of the encoder's (a picture's time lies between
  /// them) are parts of a step apart: they count as the nearest step.
  explicit RestReadings(const std::vector<double>& angles);

  /// Whether readings differ, so that they say something about the encoder's jitter.
  bool differ() const { return counts_.size() > 1; }
  int highest() const { return counts_.back().first; } // step above the lowest one
  /// ln of the probability of these readings, the joint's true place integrated out:
  ///   ln Int Prod_i [Phi((k_i + 1/2 - x) / jitter) - Phi((k_i - 1/2 - x) / jitter)] dx,   jitter and x in steps
  /// (the likelihood of rounded normal readings: Sheppard, Proc. London Math. Soc. 29 (1898) 353).
  double logLikelihood(double jitter) const;

  /// Where the joint stood, as the readings tell: posterior mean and variance of a flat prior.
  struct Place {
    double angle = 0, variance = 0; // [rad], [rad^2]
  };
  Place place(double jitter) const;
  /// Readings of the same pattern have the same likelihood.
  const std::vector<std::pair<int, int>>& pattern() const { return counts_; }

private:
  template <class Visit> void visitPlaces(double jitter, const Visit& visit) const;

  double lowest_ = 0;                       // angle of step 0: the mean of all readings less their steps [rad]
  std::vector<std::pair<int, int>> counts_; // step, how often
};

/// The jitter of each joint's encoder at rest [rad], from `rests[joint]`: the likeliest level, drawn towards the one
/// that all joints together show (their encoders are of one make: levels within a factor of 1.5 of each other, 1
/// sigma), for few rests tell a joint's own level but roughly. 0 where no readings of a rest ever differ.
std::vector<double> estimateEncoderJitter(const std::vector<std::vector<RestReadings>>& rests);

} // namespace naocal
