#include "inference/WideModel.hpp"

#include "inference/DriverBasis.hpp"
#include "inference/Thresholds.hpp"
#include "io/InputError.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace naocal {

namespace {

/// Prior sigmas of the model. Those of effects beyond the base model are widened to their estimates; otherwise a curve
/// of the same shape with a larger prior would appear significant by relieving them.
Eigen::VectorXd priorsOf(const Model& model, const Eigen::VectorXd& unknowns) {
  Eigen::VectorXd sigmas = model.sigmas();
  for (const Term& term : model.terms()) {
    if (!term.effect.inBaseModel) {
      for (Eigen::Index i = eigenIndex(term.first); i < eigenIndex(term.first + term.effect.unknowns.size()); ++i) {
        sigmas[i] = std::max(sigmas[i], std::abs(unknowns[i]) / threshold::implausible);
      }
    }
  }
  return sigmas;
}

/// Rows of a model at its fit; unknowns beyond the state's are zero.
std::vector<PoseRows> linearizedRows(const Measurements& measurements, const Model& model, const FittedPoint& point) {
  const Residuals residuals{measurements, model, point.noise, point.loss};
  Residuals::State state = point.state;
  state.unknowns.conservativeResizeLike(Eigen::VectorXd::Zero(eigenIndex(model.unknownCount())));
  auto rows = residuals.rows(state);
  if (!rows) {
    throw InputError{"the fit puts a corner that was seen behind the camera: these captures do not belong together"};
  }
  return *std::move(rows);
}

} // namespace

WideModel::WideModel(const Measurements& measurements, const Model& model, std::vector<Term> candidates,
                     const FittedPoint& point, bool curves)
    : candidates_{std::move(candidates)} {
  const auto own = eigenIndex(model.unknownCount());
  const Eigen::VectorXd unknowns = point.state.unknowns.head(own);
  std::vector<DriverSeries> drivers;
  if (curves) {
    drivers = collectDrivers(measurements, model, unknowns);
    mounts_ = buildMountCurves(measurements, drivers);
  }
  extended_ = model;
  std::vector<ColumnGroup> groups;
  const auto extend = [&](const Term& term) {
    groups.push_back({eigenIndex(extended_.unknownCount()) - own, eigenIndex(term.effect.unknowns.size())});
    extended_.add(term);
  };
  for (const Term& candidate : candidates_) {
    extend(candidate);
  }
  for (const MountCurve& mount : mounts_) {
    extend(mount.term);
    groups.back().part = 3;
  }
  const Eigen::Index columns = eigenIndex(extended_.unknownCount()) - own;
  poses_ = linearizedRows(measurements, extended_, point);
  map_ = buildDriverColumns(measurements, std::move(drivers), poses_);
  for (const DriverBasis& cell : map_.cells) {
    const bool nested = cell.shape == DriverBasis::Shape::smooth;
    groups.push_back({columns + cell.first, cell.count, nested ? 1 : 0, cell.choices});
  }
  problem_ = {poses_, map_, unknowns, priorsOf(model, unknowns), columns};
  problem_.groups = std::move(groups);
  problem_.named = candidates_.size();
  problem_.plausible.resize(columns + map_.count);
  problem_.plausible << extended_.sigmas().tail(columns), Eigen::VectorXd::Constant(map_.count, curvePriorSigma);
  problem_.sizes = Eigen::VectorXd::Zero(columns + map_.count);
  problem_.sizes.head(point.state.unknowns.size() - own) = point.state.unknowns.tail(point.state.unknowns.size() - own);
  unknowns_.resize(own + columns);
  unknowns_ << unknowns, problem_.sizes.head(columns);
  if (!problem_.sizes.isZero(0)) {
    linearizePlainly(measurements, model, point);
  }
}

void WideModel::linearizePlainly(const Measurements& measurements, const Model& model, const FittedPoint& point) {
  Residuals::State state = point.state;
  state.unknowns.conservativeResize(eigenIndex(model.unknownCount()));
  const Loss quadratic; // a robust one would take the effects' absence for doubtful measurements
  if (auto rows = Residuals{measurements, model, point.noise, quadratic}.rows(state)) {
    plain_ = *std::move(rows);
    problem_.plain = &plain_;
  }
}

} // namespace naocal
