#pragma once

/// Tail probabilities, compiled once; boost's distributions would add seconds to the build of every user.
namespace naocal {

/// P(x >= value) of chi-squared with `freedom` degrees of freedom; value >= 0, freedom > 0.
double chiSquaredTail(double value, double freedom);

/// P(x >= value) of the F distribution with `freedom` and `remaining` degrees of freedom.
double fTail(double value, double freedom, double remaining);

/// x with P(|t| <= x) = 0.95 for Student's t.
double studentHalfWidth(double freedom);

/// P(t <= value) for Student's t.
double studentBelow(double value, double freedom);

} // namespace naocal
