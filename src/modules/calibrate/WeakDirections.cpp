#include "calibrate/WeakDirections.hpp"
#include "calibrate/Words.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace naocal {

std::vector<WeakDirection> weakDirections(const Model& model, const CalibrationResult& result) {
  constexpr double wide = 0.3;   // of the prior's sigma
  constexpr double shared = 0.4; // smallest share worth naming, of the largest
  std::vector<std::size_t> physical;
  std::vector<std::string> spoken;
  for (const Term& term : model.terms()) {
    for (std::size_t i = 0; i < term.effect.unknowns.size() && !term.isPlacement && term.asked; ++i) {
      physical.push_back(term.first + i);
      spoken.push_back(inWords(term, i));
    }
  }
  const Eigen::VectorXd sigmas = model.sigmas();
  Eigen::MatrixXd relative(at(physical.size()), at(physical.size()));
  for (std::size_t i = 0; i < physical.size(); ++i) {
    for (std::size_t j = 0; j < physical.size(); ++j) {
      relative(at(i), at(j)) =
          result.covariance(at(physical[i]), at(physical[j])) / (sigmas[at(physical[i])] * sigmas[at(physical[j])]);
    }
  }
  const SymmetricEigen eigen = symmetricEigen(relative);
  const std::vector<std::string> names = model.names();
  std::vector<WeakDirection> weak;
  for (Eigen::Index k = relative.rows() - 1; k >= 0; --k) {
    WeakDirection direction;
    direction.sigma = std::sqrt(std::max(0.0, eigen.values[k]));
    if (direction.sigma < wide) {
      break;
    }
    std::vector<std::string> words;
    Eigen::VectorXd turn = Eigen::VectorXd::Zero(sigmas.size()); // the direction in radians
    direction.unit = "rad";
    const double least = shared * eigen.vectors.col(k).cwiseAbs().maxCoeff();
    for (std::size_t i = 0; i < physical.size(); ++i) {
      const double share = eigen.vectors(at(i), k);
      if (std::abs(share) >= least) {
        const std::size_t unknown = physical[i];
        direction.parts.emplace_back(names[unknown], share);
        words.push_back(spoken[i]);
        turn[at(unknown)] = share * sigmas[at(unknown)];
        if (model.units()[unknown] != "rad") {
          direction.unit = "prior sigmas";
        }
      }
    }
    if (direction.unit == "rad") {
      turn.normalize();
      direction.sigma = std::sqrt(turn.dot(result.covariance * turn));
      for (auto& [name, share] : direction.parts) {
        share = turn[std::find(names.begin(), names.end(), name) - names.begin()];
      }
    }
    direction.sentence = words.size() == 1
                             ? fmt::format("these captures hardly tell {}", words.front())
                             : fmt::format("{} can be traded against each other: these captures hardly tell them apart",
                                           enumerated(words));
    weak.push_back(std::move(direction));
  }
  return weak;
}

} // namespace naocal
