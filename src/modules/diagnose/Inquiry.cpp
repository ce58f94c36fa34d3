#include "diagnose/Inquiry.hpp"

#include "captures/InputError.hpp"
#include "diagnose/Drivers.hpp"
#include "geometry/Index.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace naocal {

namespace {

std::vector<std::size_t> byBayes(std::span<const GroupEvidence> groups) {
  std::vector<std::size_t> order(groups.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return groups[a].bayes > groups[b].bayes; });
  return order;
}

/// The model's priors; of effects beyond the base wide enough for what was found of them: else a curve of the same
/// shape, which may be larger, would be evident because it relieves them.
Eigen::VectorXd priorsOf(const Model& model, const CalibrationResult& fit) {
  constexpr double implausible = 3; // sigma
  Eigen::VectorXd sigmas = model.sigmas();
  for (const Term& term : model.terms()) {
    if (!term.effect.base) {
      for (Eigen::Index i = at(term.first); i < at(term.first + term.effect.unknowns.size()); ++i) {
        sigmas[i] = std::max(sigmas[i], std::abs(fit.unknowns[i]) / implausible);
      }
    }
  }
  return sigmas;
}

/// Poses in which whole boards do not belong to the rest: only the loss tells where their joints are.
std::vector<std::size_t> posesInDoubt(const Measurements& measurements, const CalibrationResult& fit) {
  std::vector<std::size_t> result;
  for (std::size_t pose = 0; pose < measurements.poses.size(); ++pose) {
    const auto holds = [&](const Doubt& doubt) {
      const std::vector<Reading>& readings = measurements.poses[pose].readings;
      return doubt.whole && std::any_of(readings.begin(), readings.end(), [&](const Reading& reading) {
               return std::find(reading.pictures.begin(), reading.pictures.end(), doubt.picture) !=
                      reading.pictures.end();
             });
    };
    if (std::any_of(fit.doubts.begin(), fit.doubts.end(), holds)) {
      result.push_back(pose);
    }
  }
  return result;
}

/// The sums of model and candidates at the fit, candidates at zero.
Residuals::Linear linearisedAt(const Measurements& measurements, const Model& model, const CalibrationResult& fit) {
  Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.unknownCount()));
  unknowns.head(fit.unknowns.size()) = fit.unknowns;
  Loss loss;
  loss.scale = fit.loss.scale * fit.sigmaScale;
  // the deflections there, by steps without the loss: where they are still zero, good corners look false
  const Residuals residuals{measurements, model, fit.noise, loss}, quadratic{measurements, model, fit.noise};
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(unknowns.size());
  Residuals::State state = residuals.start(unknowns);
  const auto asFitted = [&, poses = posesInDoubt(measurements, fit)] { // deflections count in sigmas
    for (const std::size_t pose : poses) {
      state.deflections[pose] = fit.sigmaScale * fit.state.deflections[pose];
    }
  };
  asFitted();
  for (int step = 0; step < 3; ++step) {
    if (const auto linear = quadratic.linearised(state)) {
      state = quadratic.moved(state, *linear, still);
      asFitted();
    }
  }
  auto linear = residuals.linearised(state);
  if (!linear) {
    throw InputError{"the fit puts a corner that was seen behind the camera: these captures do not belong together"};
  }
  return *std::move(linear);
}

} // namespace

Inquiry::Inquiry(const Measurements& measurements, const Model& model, const CalibrationResult& fit,
                 const std::vector<Term>& candidates, const InquiryOptions& options)
    : candidates_{candidates}, noise_{fit.noise} {
  std::vector<DriverValues> drivers;
  if (options.map) {
    drivers = driversOf(measurements, model, fit.unknowns);
  }
  mounts_ = mountCurves(measurements, drivers);
  Model extended = model;
  std::vector<ColumnGroup> groups;
  const auto extend = [&](const Term& term) {
    groups.push_back({static_cast<Eigen::Index>(extended.unknownCount() - model.unknownCount()),
                      static_cast<Eigen::Index>(term.effect.unknowns.size())});
    extended.add(term);
  };
  for (const Term& candidate : candidates_) {
    extend(candidate);
  }
  for (const MountCurve& mount : mounts_) {
    extend(mount.term);
    groups.back().part = 3;
  }
  linear_ = linearisedAt(measurements, extended, fit);
  map_ = driverColumns(measurements, std::move(drivers), linear_.poses);
  const auto columns = static_cast<Eigen::Index>(extended.unknownCount() - model.unknownCount());
  for (const DriverCell& cell : map_.cells) {
    const bool nested = cell.shape == DriverCell::Shape::smooth;
    groups.push_back({columns + cell.first, cell.count, nested ? 1 : 0, cell.choices});
  }
  Eigen::VectorXd plausible(columns + map_.count);
  plausible << extended.sigmas().tail(columns), Eigen::VectorXd::Constant(map_.count, plausibleCurve);
  problem_ = std::make_unique<ScoreProblem>(ScoreProblem{&linear_, &map_, fit.unknowns, priorsOf(model, fit),
                                                         std::move(groups), candidates_.size(), columns,
                                                         std::move(plausible)});
  evidence_ = evidenceOf(*problem_, noise_, options.levels, options.draws, options.seed);
}

std::vector<std::size_t> Inquiry::candidatesByEvidence() const {
  return byBayes({evidence_.groups.data(), candidates_.size()});
}

double Inquiry::standing(const GroupEvidence& evidence) const {
  const double numbers = 6 * static_cast<double>(linear_.poses.size());
  return std::max(evidence.bayes, evidence.likelihoodRatio - static_cast<double>(evidence.freedom) * std::log(numbers));
}

std::vector<std::size_t> Inquiry::candidatesByStanding() const {
  std::vector<std::size_t> order = candidatesByEvidence();
  std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
    return standing(ofCandidate(a)) > standing(ofCandidate(b));
  });
  return order;
}

std::vector<std::size_t> Inquiry::curvesByEvidence() const {
  return byBayes({evidence_.groups.data() + candidates_.size(), curveCount()});
}

std::optional<std::size_t> Inquiry::find(const std::string& label) const {
  const auto found = std::find_if(candidates_.begin(), candidates_.end(),
                                  [&](const Term& candidate) { return candidate.label() == label; });
  return found == candidates_.end() ? std::nullopt
                                    : std::optional{static_cast<std::size_t>(found - candidates_.begin())};
}

Noise Inquiry::noise() const {
  Noise result = noise_;
  result.pose = evidence_.level;
  return result;
}

} // namespace naocal
