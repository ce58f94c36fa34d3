#include "calibrate/Priors.hpp"

#include "evidence/Evidence.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>

namespace naocal {

namespace {

/// Whether the wide prior is the likelier one. `value`, `variance`: under the narrow one, in units of its sigma.
///   -2 ln likelihood(w) = ln(1 + w^2 V) - s^2 / (V + w^-2),   V the data's information, s their score at zero
bool isWide(double value, double variance) {
  const auto& [narrow, wide] = plausibleWidths;
  const double information = std::max(0.0, 1 / variance - 1), score = value / variance;
  const auto cost = [&](const PlausibleWidth& prior) {
    const double square = prior.width * prior.width;
    return std::log1p(square * information) - score * score / (information + 1 / square) - 2 * std::log(prior.odds);
  };
  return cost(wide) < cost(narrow);
}

} // namespace

std::optional<Model> withPriorsFor(const Model& model, const Eigen::VectorXd& unknowns,
                                   const Eigen::VectorXd& variances) {
  Model result;
  bool widened = false;
  for (Term term : model.terms()) {
    const bool added = term.asked && !term.isPlacement && !term.effect.base;
    for (std::size_t i = 0; added && i < term.effect.unknowns.size(); ++i) {
      double& sigma = term.effect.unknowns[i].sigma;
      if (isWide(unknowns[at(term.first + i)] / sigma, variances[at(term.first + i)] / (sigma * sigma))) {
        sigma *= plausibleWidths[1].width;
        widened = true;
      }
    }
    result.add(std::move(term));
  }
  return widened ? std::optional{std::move(result)} : std::nullopt;
}

} // namespace naocal
