#include "math/Statistics.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
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

double fTail(double value, double freedom, double remaining) {
  return cdf(complement(Fisher{freedom, remaining}, value));
}

double studentHalfWidth(double freedom) {
  return quantile(Student{freedom}, 0.975);
}

double studentBelow(double value, double freedom) {
  return cdf(Student{freedom}, value);
}

} // namespace naocal
