#pragma once

#include "evaluate/ThesisNoise.hpp"
#include "math/Angles.hpp"
#include "residuals/Residuals.hpp"

namespace naocal {

/// The range of a NAO's offsets in the thesis [rad], either way.
const double largestOffset = radians(6.5);

/// Where a search ended.
struct ThesisFound {
  bool ended = false; // by itself, in a possible state
  Eigen::VectorXd unknowns;
  double cost = std::numeric_limits<double>::infinity();
  double sigma = 0; // the largest of an offset, where costs are halves of chi2
  bool better(const ThesisFound& other) const { return ended && (!other.ended || cost < other.cost); }
};

/// The solvers of the evaluation, before one error set.
class ThesisSearch {
public:
  /// `pixels`: plain least squares, `whitened`: with our weights and priors, `flat`: with our weights alone, where only
  /// pixels are noisy, else nullptr. `offsets`: how many of the unknowns are. `numbers`: that were measured.
  ThesisSearch(const Residuals& pixels, const Residuals& whitened, const Residuals* flat, std::size_t offsets,
               double numbers, Randomness& starts)
      : pixels_{pixels}, whitened_{whitened}, flat_{flat}, offsets_{static_cast<Eigen::Index>(offsets)},
        numbers_{numbers}, starts_{starts} {}

  ThesisFound found(ThesisSolver solver);

private:
  template <typename Problem> ThesisFound search(const Problem& problem, const Residuals::State& start) const;
  ThesisFound fromRandomStarts();
  ThesisFound ours();
  ThesisFound byCostsOnly(ThesisSolver solver);
  Eigen::VectorXd zero() const { return Eigen::VectorXd::Zero(pixels_.scales().size()); }
  Eigen::VectorXd randomStart();

  const Residuals &pixels_, &whitened_;
  const Residuals* flat_;
  Eigen::Index offsets_;
  double numbers_;
  Randomness& starts_;
};

} // namespace naocal
