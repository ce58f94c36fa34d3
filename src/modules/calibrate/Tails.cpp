#include "calibrate/Tails.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace naocal {

double chiSquaredTail(double value, double freedom) {
  return cdf(complement(boost::math::chi_squared{freedom}, value));
}

double fisherTail(double value, double freedom, double remaining) {
  return cdf(complement(boost::math::fisher_f{freedom, remaining}, value));
}

double studentHalfWidth(double freedom) {
  return quantile(boost::math::students_t{freedom}, 0.975);
}

} // namespace naocal
