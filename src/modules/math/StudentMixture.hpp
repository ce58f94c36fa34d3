#pragma once

#include <array>
#include <vector>

namespace naocal {

/// Weighted sum of Student's t distributions with common degrees of freedom:
///   P(x <= v) = sum w_i T_nu((v - centre_i) / scale_i).
class StudentMixture {
public:
  struct Part {
    double weight = 0, centre = 0, scale = 0; // scale: standard error; the standard deviation is larger
  };
  /// `parts`: at least one; their weights sum to 1. Parts that differ by less than a hundredth of their scale are
  /// merged. From a million degrees of freedom on the parts are normal.
  StudentMixture(const std::vector<Part>& parts, double freedom);

  /// P(x <= value).
  double below(double value) const;
  double quantile(double probability) const;
  /// [low, high] with `probability` between them and equally much beyond each.
  std::array<double, 2> interval(double probability) const;

private:
  std::vector<Part> parts_;
  double freedom_;
};

} // namespace naocal
