#pragma once

#include <vector>

/// Tail probabilities, compiled once; boost's distributions would add seconds to the build of every user.
namespace naocal {

/// P(x >= value) of chi-squared with `freedom` degrees of freedom; value >= 0, freedom > 0.
double chiSquaredTail(double value, double freedom);

/// x with P(chi-squared >= x) = p; p of at least 1e-12, below which the inverse overflows.
double criticalChi2(double freedom, double p);

/// Noncentrality of a chi-squared with `freedom` degrees of freedom that a test at this p-value detects with
/// probability `power`.
double requiredNoncentrality(double power, double freedom, double criticalP);

/// P(x >= value) of the F distribution with `freedom` and `remaining` degrees of freedom.
double fTail(double value, double freedom, double remaining);

/// x with P(|t| <= x) = 0.95 for Student's t.
double studentHalfWidth(double freedom);

/// x with P(t <= x) = probability for Student's t.
double studentQuantile(double probability, double freedom);

/// P(t <= value) for Student's t.
double studentBelow(double value, double freedom);

/// The middle value, of an even number the upper one. Requires at least one.
double medianOf(std::vector<double> values);

} // namespace naocal
