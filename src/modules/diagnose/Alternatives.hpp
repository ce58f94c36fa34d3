#pragma once

#include "diagnose/Inquiry.hpp"

#include <cstddef>
#include <vector>

namespace naocal {

/// Largest canonical correlation of what two candidates would do to the pictures, everything in the model projected
/// out.
double correlation(const Inquiry& inquiry, std::size_t one, std::size_t other);

/// Candidates that these captures cannot tell from `chosen`: almost as likely, or so correlated that chance may have
/// put them behind, lambda (1 - rho) < 5.4: a wrong order in 5 % of cases (lambda: the evidence).
std::vector<std::size_t> equivalents(const Inquiry& inquiry, std::size_t chosen);

} // namespace naocal
