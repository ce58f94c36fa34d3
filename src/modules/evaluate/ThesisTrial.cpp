#include "evaluate/ThesisTrial.hpp"

#include "evaluate/ThesisSearch.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace naocal {

namespace {

const double leastError = radians(1); // of offsets that are large [rad]

/// Flat over the search: ten radians of freedom per offset.
constexpr double noPrior = 10;
/// Of mounts and boards, as of simulated robots: each way.
const double mostTurned = radians(2);               // a camera [rad]
constexpr double mostShifted = 0.03, mostYaw = 0.1; // a board [m], [rad]

constexpr Noise onePixel{.pixel = 1, .encoder = 0, .pose = 0};

double numbersOf(const Residuals::Linear& linear) {
  double sum = 0;
  for (const PoseSystem& pose : linear.poses) {
    sum += pose.numbers;
  }
  return sum;
}

} // namespace

ThesisStatus ThesisAnswer::status(double tolerance) const {
  return !solved                                    ? ThesisStatus::solverFailure
         : rms > rmsTolerance                       ? ThesisStatus::noConvergence
         : errors.cwiseAbs().maxCoeff() > tolerance ? ThesisStatus::localMinimum
                                                    : ThesisStatus::success;
}

ThesisTrial::ThesisTrial(const ThesisStage& stage, const ThesisSetting& setting, double pixel)
    : stage_{stage}, setting_{setting}, noise_{thesisNoise(setting, pixel)}, plainModel_{unknownsOf(stage, noPrior,
                                                                                                    noPrior)},
      ourModel_{unknownsOf(stage, jointOffset().unknowns.front().sigma, cameraRotation().unknowns.front().sigma)},
      taken_{stage.everything()} {}

void ThesisTrial::draw(std::uint64_t seed, std::size_t number) {
  const std::string set = fmt::format("thesis set {}", number);
  Randomness errors{seed, set}, measuring{seed, set + ", measured"};
  truth_ = Eigen::VectorXd::Zero(at(stage_.model().unknownCount()));
  for (double& offset : truth_.head(joints())) {
    do {
      offset = errors.within(largestOffset);
    } while (setting_.largeErrors && std::abs(offset) < leastError);
  }
  for (const Term& term : stage_.model().terms()) {
    for (std::size_t i = 0; term.first >= stage_.joints().size() && i < term.effect.unknowns.size(); ++i) {
      const double most = !term.isPlacement ? mostTurned : term.effect.unknowns[i].unit == "m" ? mostShifted : mostYaw;
      truth_[at(term.first + i)] = errors.within(most);
    }
  }
  const double pixel = setting_.pixelNoise() ? noise_.pixel : 0;
  stage_.take(
      truth_, [&](double angle) { return angleReading(angle, setting_, measuring); }, pixel, measuring, taken_);
  pixels_.emplace(taken_, plainModel_, onePixel);
  whitened_.emplace(taken_, ourModel_, noise_);
  if (!setting_.angleNoise()) {
    flat_.emplace(taken_, plainModel_, noise_);
  }
  const auto atTruth = pixels_->linearised(pixels_->start(truth_)).value(); // what is seen lies before the camera
  numbers_ = numbersOf(atTruth);
  rmsAtTruth_ = std::sqrt(2 * atTruth.cost / numbers_);
  starts_.emplace(seed, set + ", starts");
  limits_.emplace(seed, set + ", limit");
}

ThesisAnswer ThesisTrial::answer(ThesisSolver solver) {
  const ThesisFound found =
      ThesisSearch{*pixels_, *whitened_, flat_ ? &*flat_ : nullptr, stage_.joints().size(), numbers_, *starts_}.found(
          solver);
  const auto there = found.ended ? pixels_->linearised(pixels_->start(found.unknowns)) : std::nullopt;
  if (!there) {
    return {};
  }
  return {true, std::sqrt(2 * there->cost / numbers_), 2 * rmsAtTruth_ + 1, (found.unknowns - truth_).head(joints())};
}

std::vector<double> ThesisTrial::limit(std::size_t draws) {
  std::vector<double> result(draws, 0);
  if (setting_.noise == ThesisNoise::none) {
    return result;
  }
  const Eigen::LLT<Eigen::MatrixXd> root{whitened_->linearised(whitened_->start(truth_)).value().hessian};
  for (double& largest : result) {
    Eigen::VectorXd error{truth_.size()};
    for (double& number : error) {
      number = limits_->normal(1);
    }
    largest = root.matrixU().solve(error).head(joints()).cwiseAbs().maxCoeff();
  }
  return result;
}

} // namespace naocal
