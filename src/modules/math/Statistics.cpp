#include "math/Statistics.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>

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

double requiredNoncentrality(double power, double freedom, double criticalP) {
  constexpr double leastP = 1e-12; // the inverse distribution overflows below
  const double critical = quantile(complement(boost::math::chi_squared{freedom}, std::max(criticalP, leastP)));
  return boost::math::non_central_chi_squared::find_non_centrality(freedom, critical, 1 - power);
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

} // namespace naocal
