#include "math/Statistics.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cstddef>

namespace naocal {

namespace {

/// Double precision suffices for probabilities and is several times faster than long double.
using Plain = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
using ChiSquared = boost::math::chi_squared_distribution<double, Plain>;
using Fisher = boost::math::fisher_f_distribution<double, Plain>;
using Student = boost::math::students_t_distribution<double, Plain>;

} // namespace

double chiSquaredTail(double value, double freedom) {
  return cdf(complement(ChiSquared{freedom}, value));
}

double criticalChi2(double freedom, double p) {
  constexpr double leastP = 1e-12;
  return quantile(complement(boost::math::chi_squared{freedom}, std::max(p, leastP)));
}

double requiredNoncentrality(double power, double freedom, double criticalP) {
  return boost::math::non_central_chi_squared::find_non_centrality(freedom, criticalChi2(freedom, criticalP),
                                                                   1 - power);
}

double fTail(double value, double freedom, double remaining) {
  return cdf(complement(Fisher{freedom, remaining}, value));
}

double studentHalfWidth(double freedom) {
  return studentQuantile(0.975, freedom);
}

double studentQuantile(double probability, double freedom) {
  return quantile(Student{freedom}, probability);
}

double studentBelow(double value, double freedom) {
  return cdf(Student{freedom}, value);
}

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace naocal
