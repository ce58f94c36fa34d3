#pragma once

/// How far chance alone goes, compiled once: boost's distributions would take seconds of each file's build.
namespace naocal {

/// P(x >= value) of chi-squared with `freedom` degrees of freedom; value >= 0, freedom > 0.
double chiSquaredTail(double value, double freedom);

/// P(x >= value) of F: the ratio of a mean square with `freedom` and one with `remaining` degrees of freedom.
double fTail(double value, double freedom, double remaining);

/// x with P(|t| <= x) = 0.95 of Student's t.
double studentHalfWidth(double freedom);

/// P(t <= value) of Student's t.
double studentBelow(double value, double freedom);

} // namespace naocal
