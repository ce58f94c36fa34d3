#pragma once

#include "residuals/Residuals.hpp"

namespace naocal {

/// The pixels of a problem (Residuals) with central differences in place of its derivatives, for levenbergMarquardt.
/// Without priors and deflections.
class NumericPixels {
public:
  explicit NumericPixels(const Residuals& residuals) : residuals_{residuals} {}

  struct Linear {
    double cost = 0;
    Eigen::VectorXd gradient;
    Eigen::MatrixXd hessian;
  };
  bool linearise(const Residuals::State& state, Linear& result) const;
  Residuals::State moved(const Residuals::State& state, const Linear&, const Eigen::VectorXd& step) const {
    return residuals_.start(state.unknowns + step);
  }
  const Eigen::VectorXd& scales() const { return residuals_.scales(); }

private:
  std::optional<Eigen::VectorXd> pixels(const Eigen::VectorXd& unknowns) const;

  const Residuals& residuals_;
};

} // namespace naocal
