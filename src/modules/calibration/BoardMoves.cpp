#include "calibration/BoardMoves.hpp"

#include "estimation/Model.hpp"
#include "io/Units.hpp"
#include "math/LinearAlgebra.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

namespace naocal {

namespace {

constexpr double usualShift = 0.03, usualTurn = 0.1; // [m], [rad]: of a board that somebody kicked or lifted

/// Whether noise explains the corners of an observation: at most three times its size.
bool isExplained(const BoardResidual& seen, double pixel) {
  constexpr double most = 3;
  return std::sqrt(seen.residual.squaredNorm() / static_cast<double>(seen.residual.size())) < most * pixel;
}

} // namespace

std::vector<Unknown> boardMoveUnknowns(bool isFlat) {
  return isFlat
             ? std::vector<Unknown>{{"x", "m", usualShift}, {"y", "m", usualShift}, {"yaw", "rad", usualTurn}}
             : std::vector<Unknown>{{"x", "m", usualShift},     {"y", "m", usualShift},      {"z", "m", usualShift},
                                    {"roll", "rad", usualTurn}, {"pitch", "rad", usualTurn}, {"yaw", "rad", usualTurn}};
}

Term makeBoardMove(const Measurements& measurements, std::size_t picture, std::size_t observation) {
  const ImageObservation& seen = measurements.pictures[picture];
  const std::size_t board = seen.observations[observation].view.board();
  const Target& target = measurements.targets[board];
  Effect effect{.name = "boardDisplaced",
                .description = {},
                .formula = {},
                .placeKind = PlaceKind::board,
                .unknowns = boardMoveUnknowns(target.isFlat),
                .correct = {}};
  effect.correct = [set = seen.set, time = seen.instant.time](ModelState& modelState, const RobotSample& instant,
                                                              std::size_t at, std::span<const double> values) {
    if (instant.set == set && instant.time == time) {
      auto placement = modelState.boardPlacement(at);
      const bool isFlat = values.size() == 3;
      for (Eigen::Index i = 0; i < std::ssize(values); ++i) {
        placement[isFlat && i == 2 ? 5 : i] += values[static_cast<std::size_t>(i)];
      }
    }
  };
  return {std::move(effect), board,
          fmt::format("{} in {} of {}", target.name, measurements.captureOf(seen).id, measurements.setOf(seen).name)};
}

void estimateBoardMoves(const Measurements& measurements, const Model& model, const Fit& fit,
                        CalibrationResult& result) {
  Model larger = model;
  std::vector<std::pair<Outlier*, Term>> moved;
  for (Outlier& outlier : result.outliers) {
    if (outlier.whole) {
      larger.add(makeBoardMove(measurements, outlier.picture, outlier.observation));
      moved.emplace_back(&outlier, larger.terms().back());
    }
  }
  if (moved.empty()) {
    return;
  }
  try { // with full weight first: displaced corners have lost theirs
    Fit found = fitForComparison(measurements, larger, fit.noise, Loss{},
                                 mapParameters(model, fit.minimum.state.unknowns, larger));
    found = refit(measurements, larger, fit.noise, fit.loss, std::move(found), comparisonTolerance);
    const Eigen::MatrixXd& hessian = found.minimum.linear.hessian;
    const Eigen::MatrixXd covariance = hessian.ldlt().solve(Eigen::MatrixXd::Identity(hessian.rows(), hessian.cols()));
    const std::vector<BoardResidual> residuals =
        Residuals{measurements, larger, fit.noise, fit.loss}.boardResiduals(found.minimum.state);
    for (const auto& [outlier, term] : moved) {
      const auto seen = std::find_if(residuals.begin(), residuals.end(), [&, &one = *outlier](const auto& residual) {
        return residual.picture == one.picture && residual.observation == one.observation;
      });
      if (seen != residuals.end() && isExplained(*seen, fit.noise.pixel)) {
        const Eigen::Index first = eigenIndex(term.first), count = term.sigmas().size();
        outlier->move = BoardMove{found.minimum.state.unknowns.segment(first, count),
                                  result.sigmaScale * covariance.diagonal().segment(first, count).cwiseSqrt()};
      }
    }
  } catch (const InputError&) { // a corner behind the camera: no such displacement
  }
}

std::string describeBoardMove(const BoardMove& move) {
  const bool isFlat = move.values.size() == 3;
  const std::vector<Unknown> unknowns = boardMoveUnknowns(isFlat);
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const auto [unit, factor] = displayUnit(unknowns[i].unit);
    const double value = move.values[eigenIndex(i)], sigma = move.sigmas[eigenIndex(i)];
    parts.push_back(
        fmt::format("{} {}", unknowns[i].name, appendUnit(formatEstimate(factor * value, factor * sigma), unit)));
  }
  const Eigen::Index lengths = isFlat ? 2 : 3;
  const Eigen::ArrayXd direction = move.values.head(lengths).array() / std::max(move.distance(), 1e-12);
  const double sigma = (direction * move.sigmas.head(lengths).array()).matrix().norm();
  constexpr double millimetres = 1000; // per metre
  return fmt::format("{} mm elsewhere ({})", formatEstimate(millimetres * move.distance(), millimetres * sigma),
                     fmt::join(parts, ", "));
}

std::string describeDisplacedBoard(const Measurements& measurements, const Outlier& outlier) {
  const ImageObservation& picture = measurements.pictures[outlier.picture];
  return fmt::format("board {} lies {} in capture {} than in all others",
                     measurements.targets[picture.observations[outlier.observation].view.board()].name,
                     describeBoardMove(*outlier.move), measurements.captureOf(picture).id);
}

} // namespace naocal
