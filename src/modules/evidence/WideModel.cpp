#include "evidence/WideModel.hpp"

#include "captures/InputError.hpp"
#include "evidence/Drivers.hpp"
#include "geometry/Index.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace naocal {

namespace {

/// The model's priors; of effects beyond the base wide enough for what was found of them: else a curve of the same
/// shape, which may be larger, would be evident because it relieves them.
Eigen::VectorXd priorsOf(const Model& model, const Eigen::VectorXd& unknowns) {
  constexpr double implausible = 3; // sigma
  Eigen::VectorXd sigmas = model.sigmas();
  for (const Term& term : model.terms()) {
    if (!term.effect.base) {
      for (Eigen::Index i = at(term.first); i < at(term.first + term.effect.unknowns.size()); ++i) {
        sigmas[i] = std::max(sigmas[i], std::abs(unknowns[i]) / implausible);
      }
    }
  }
  return sigmas;
}

/// The sums of a model at its fit; unknowns beyond the state's are zero.
Residuals::Linear linearisedAt(const Measurements& measurements, const Model& model, const FittedPoint& point) {
  const Residuals residuals{measurements, model, point.noise, point.loss};
  Residuals::State state = point.state;
  state.unknowns.conservativeResizeLike(Eigen::VectorXd::Zero(at(model.unknownCount())));
  auto linear = residuals.linearised(state);
  if (!linear) {
    throw InputError{"the fit puts a corner that was seen behind the camera: these captures do not belong together"};
  }
  linear->eliminated.clear(); // every level of noise makes its own
  return *std::move(linear);
}

} // namespace

WideModel::WideModel(const Measurements& measurements, const Model& model, std::vector<Term> candidates,
                     const FittedPoint& point, bool curves)
    : measurements_{measurements}, candidates_{std::move(candidates)} {
  const auto own = at(model.unknownCount());
  const Eigen::VectorXd unknowns = point.state.unknowns.head(own);
  std::vector<DriverValues> drivers;
  if (curves) {
    drivers = driversOf(measurements, model, unknowns);
    mounts_ = mountCurves(measurements, drivers);
  }
  Model extended = model;
  const auto extend = [&](const Term& term) {
    problem_.groups.push_back({at(extended.unknownCount()) - own, at(term.effect.unknowns.size())});
    extended.add(term);
  };
  for (const Term& candidate : candidates_) {
    extend(candidate);
  }
  for (const MountCurve& mount : mounts_) {
    extend(mount.term);
    problem_.groups.back().part = 3;
  }
  const Eigen::Index columns = at(extended.unknownCount()) - own;
  linear_ = linearisedAt(measurements, extended, point);
  map_ = driverColumns(measurements, std::move(drivers), linear_.poses);
  for (const DriverCell& cell : map_.cells) {
    const bool nested = cell.shape == DriverCell::Shape::smooth;
    problem_.groups.push_back({columns + cell.first, cell.count, nested ? 1 : 0, cell.choices});
  }
  problem_.linear = &linear_;
  problem_.map = &map_;
  problem_.unknowns = unknowns;
  problem_.sigmas = priorsOf(model, unknowns);
  problem_.named = candidates_.size();
  problem_.candidates = columns;
  problem_.plausible.resize(columns + map_.count);
  problem_.plausible << extended.sigmas().tail(columns), Eigen::VectorXd::Constant(map_.count, plausibleCurve);
  sizes_ = Eigen::VectorXd::Zero(columns + map_.count);
  sizes_.head(point.state.unknowns.size() - own) = point.state.unknowns.tail(point.state.unknowns.size() - own);
}

} // namespace naocal
