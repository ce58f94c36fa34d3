#include "evaluation/thesis/ThesisTrial.hpp"

#include "estimation/Residuals.hpp"
#include "evaluation/GlobalSearch.hpp"
#include "evaluation/thesis/ThesisExperiment.hpp"
#include "math/Angles.hpp"
#include "math/LevenbergMarquardt.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace naocal {

/// The pixel residuals (Residuals) with central differences instead of analytic derivatives, for levenbergMarquardt.
/// Without priors and deflections.
class NumericPixelProblem {
public:
  explicit NumericPixelProblem(const Residuals& residuals) : residuals_{residuals} {}

  using Linear = DenseLinear;
  bool linearize(const Residuals::State& state, Linear& result) const;
  Residuals::State applyStep(const Residuals::State& state, const Linear&, const Eigen::VectorXd& step) const {
    return residuals_.startState(state.unknowns + step);
  }
  const Eigen::VectorXd& scales() const { return residuals_.scales(); }

private:
  std::optional<Eigen::VectorXd> pixels(const Eigen::VectorXd& unknowns) const;

  const Residuals& residuals_;
};

/// Range of the offsets in the thesis [rad], either sign.
const double maxThesisOffset = radians(6.5);

/// Result of a search.
struct ThesisSearchResult {
  bool ended = false; // converged to a valid state
  Eigen::VectorXd unknowns;
  double cost = std::numeric_limits<double>::infinity();
  double sigma = 0; // largest standard deviation of an offset, if costs are chi2 / 2
  bool isBetterThan(const ThesisSearchResult& other) const { return ended && (!other.ended || cost < other.cost); }
};

/// The evaluation's solvers for one error set.
class ThesisSearch {
public:
  /// `pixels`: plain least squares; `whitened`: with our weights and priors; `flat`: with our weights only, if only
  /// pixels are noisy, otherwise nullptr. `offsets`: number of offsets among the unknowns. `numbers`: number of
  /// measured values.
  ThesisSearch(const Residuals& pixels, const Residuals& whitened, const Residuals* flat, std::size_t offsets,
               double numbers, RandomStream& starts)
      : pixels_{pixels}, whitened_{whitened}, flat_{flat}, offsets_{static_cast<Eigen::Index>(offsets)},
        numbers_{numbers}, starts_{starts} {}

  ThesisSearchResult solve(ThesisSolver solver);

private:
  template <typename Problem> ThesisSearchResult search(const Problem& problem, const Residuals::State& start) const;
  ThesisSearchResult fromRandomStarts();
  ThesisSearchResult solveOurs();
  ThesisSearchResult byCostsOnly(ThesisSolver solver);
  Eigen::VectorXd zero() const { return Eigen::VectorXd::Zero(pixels_.scales().size()); }
  Eigen::VectorXd randomStart();

  const Residuals &pixels_, &whitened_;
  const Residuals* flat_;
  Eigen::Index offsets_;
  double numbers_;
  RandomStream& starts_;
};

/// Predicted minus measured, for all corners; absent if a corner cannot be projected.
std::optional<Eigen::VectorXd> NumericPixelProblem::pixels(const Eigen::VectorXd& unknowns) const {
  const std::vector<BoardResidual> observations = residuals_.boardResiduals(residuals_.startState(unknowns));
  Eigen::Index count = 0;
  for (const BoardResidual& observation : observations) {
    count += observation.residual.size();
  }
  Eigen::VectorXd result(count);
  Eigen::Index row = 0;
  for (const BoardResidual& observation : observations) {
    for (const double difference : observation.residual.reshaped()) {
      result[row++] = -difference;
    }
  }
  return result.allFinite() ? std::optional{result} : std::nullopt;
}

bool NumericPixelProblem::linearize(const Residuals::State& state, Linear& result) const {
  constexpr double step = 1e-5; // [rad]
  const auto here = pixels(state.unknowns);
  if (!here) {
    return false;
  }
  Eigen::MatrixXd slopes(here->size(), state.unknowns.size());
  for (Eigen::Index i = 0; i < state.unknowns.size(); ++i) {
    const Eigen::VectorXd little = step * Eigen::VectorXd::Unit(state.unknowns.size(), i);
    const auto above = pixels(state.unknowns + little), below = pixels(state.unknowns - little);
    if (!above || !below) {
      return false;
    }
    slopes.col(i) = (*above - *below) / (2 * step);
  }
  result = {0.5 * here->squaredNorm(), slopes.transpose() * *here, slopes.transpose() * slopes};
  return true;
}

Eigen::VectorXd ThesisSearch::randomStart() {
  Eigen::VectorXd start = zero();
  for (double& offset : start.head(offsets_)) {
    offset = starts_.uniformWithin(maxThesisOffset);
  }
  return start;
}

template <typename Problem>
ThesisSearchResult ThesisSearch::search(const Problem& problem, const Residuals::State& start) const {
  constexpr double smallestFall = 1e-6; // 0.001 of the noise, or of a pixel
  auto minimum = levenbergMarquardt(problem, start, {.minCostDecrease = smallestFall});
  if (!minimum) {
    return {};
  }
  const auto count = minimum->linear.hessian.rows();
  const Eigen::MatrixXd covariance = minimum->linear.hessian.llt().solve(Eigen::MatrixXd::Identity(count, count));
  return {minimum->converged, std::move(minimum->state.unknowns), minimum->linear.cost,
          std::sqrt(covariance.diagonal().head(offsets_).maxCoeff())};
}

/// The best of searches from zero and random starts, until three agree; at most fifty (as in the thesis).
ThesisSearchResult ThesisSearch::fromRandomStarts() {
  constexpr int most = 50, enough = 3;
  ThesisSearchResult best = search(pixels_, pixels_.startState(zero()));
  for (int tries = 1, same = best.ended ? 1 : 0; tries < most && same < enough; ++tries) {
    ThesisSearchResult next = search(pixels_, pixels_.startState(randomStart()));
    if (next.ended && std::abs(next.cost - best.cost) <= 1e-6 * (1 + best.cost)) {
      ++same;
    } else if (next.isBetterThan(best)) {
      best = std::move(next);
      same = 1;
    }
  }
  return best;
}

/// Starts from zero, then from random starts while the cost exceeds the noise (5 sigma of chi2). If only pixels are
/// noisy and the images alone determine every offset, the final search omits the prior.
ThesisSearchResult ThesisSearch::solveOurs() {
  constexpr int most = 20;
  constexpr double needed = 0.01; // offset sigma [rad] below which the images suffice; the prior has 0.1
  ThesisSearchResult best = search(whitened_, whitened_.startState(zero()));
  const double explained = 0.5 * (numbers_ + 5 * std::sqrt(2 * numbers_));
  for (int tries = 1; tries < most && !(best.ended && best.cost < explained); ++tries) {
    if (ThesisSearchResult next = search(whitened_, whitened_.startState(randomStart())); next.isBetterThan(best)) {
      best = std::move(next);
    }
  }
  if (flat_ && best.ended && best.sigma < needed) {
    if (ThesisSearchResult last = search(*flat_, flat_->startState(best.unknowns)); last.ended) {
      return last;
    }
  }
  return best;
}

/// Global searches that use costs only, with as many evaluations as fit in about a second.
ThesisSearchResult ThesisSearch::byCostsOnly(ThesisSolver solver) {
  constexpr std::size_t swarmCalls = 40'000, dlibCalls = 500;
  const CostFunction cost = [this](const Eigen::VectorXd& unknowns) {
    const auto there = pixels_.linearize(pixels_.startState(unknowns));
    return there ? there->cost : std::numeric_limits<double>::infinity();
  };
  ThesisSearchResult result{
      true, solver == ThesisSolver::dlib
                ? minimizeWithDlib(cost, offsets_, maxThesisOffset, dlibCalls)
                : minimizeWithSwarm(cost, offsets_, maxThesisOffset, swarmCalls, starts_.uniformBelow(1u << 31))};
  result.cost = cost(result.unknowns);
  return result;
}

ThesisSearchResult ThesisSearch::solve(ThesisSolver solver) {
  switch (solver) {
  case ThesisSolver::plain:
    break;
  case ThesisSolver::randomStarts:
    return fromRandomStarts();
  case ThesisSolver::ours:
    return solveOurs();
  case ThesisSolver::numeric:
    return search(NumericPixelProblem{pixels_}, pixels_.startState(zero()));
  case ThesisSolver::dlib:
  case ThesisSolver::swarm:
    return byCostsOnly(solver);
  case ThesisSolver::program: // ThesisTrial::solveAsProgram
  case ThesisSolver::programStarts:
    break;
  }
  return search(pixels_, pixels_.startState(zero()));
}

namespace {

const double leastError = radians(1); // smallest offset of `largeErrors` [rad]

/// Practically flat prior: sigma of ten radians per offset.
constexpr double noPrior = 10;
/// Ranges of mounts and boards as in simulated robots, either sign.
const double mostTurned = radians(2);               // camera rotation [rad]
constexpr double mostShifted = 0.03, mostYaw = 0.1; // board shift [m], board yaw [rad]

constexpr Noise onePixel{.pixel = 1, .encoder = 0, .pose = 0};

double numbersOf(const Residuals::Linear& linear) {
  double sum = 0;
  for (const PoseSystem& pose : linear.poses) {
    sum += pose.numbers;
  }
  return sum;
}

} // namespace

ThesisStatus ThesisSolution::status(double tolerance) const {
  const bool converged = heldOut ? heldOut->isAcceptable() : rms <= rmsTolerance;
  return !solved                                    ? ThesisStatus::solverFailure
         : !converged                               ? ThesisStatus::noConvergence
         : errors.cwiseAbs().maxCoeff() > tolerance ? ThesisStatus::localMinimum
                                                    : ThesisStatus::success;
}

ThesisTrial::ThesisTrial(const ThesisExperiment& stage, const ThesisSetting& setting, double pixel)
    : stage_{stage}, setting_{setting}, noise_{thesisNoise(setting, pixel)},
      plainModel_{makeExperimentModel(stage, noPrior, noPrior)}, ourModel_{makeExperimentModel(
                                                                     stage, jointOffset().unknowns.front().sigma,
                                                                     cameraRotation().unknowns.front().sigma)},
      taken_{stage.allObservations()}, pixel_{setting.pixelNoise() ? pixel : 0} {
  if (setting.likeProgram()) {
    program_ = std::make_unique<Program>(
        Program{stage.bottomCamera<float>(), stage.bottomCamera<double>(), stage.jointNames(), {}, {}});
    if (!stage.inputs().heldOut.empty()) {
      program_->heldOut.emplace(program_->exactCamera, stage.inputs().heldOut, stage.floorPoints());
    }
  }
}

/// Draws the values of all unknowns.
void ThesisTrial::drawTruth(std::uint64_t seed, std::size_t number) {
  truth_ = Eigen::VectorXd::Zero(eigenIndex(stage_.model().unknownCount()));
  if (setting_.errorSets == ErrorSets::program) {
    truth_.head(joints()) = drawProgramSet(stage_.jointNames(), seed, number);
    return;
  }
  if (setting_.errorSets == ErrorSets::file) {
    truth_.head(joints()) = stage_.inputs().offsets.at(number);
    return;
  }
  RandomStream errors{seed, fmt::format("thesis set {}", number)};
  for (double& offset : truth_.head(joints())) {
    do {
      offset = errors.uniformWithin(maxThesisOffset);
    } while (setting_.largeErrors && std::abs(offset) < leastError);
  }
  for (const Term& term : stage_.model().terms()) {
    for (std::size_t i = 0; term.first >= stage_.joints().size() && i < term.effect.unknowns.size(); ++i) {
      const double most = !term.isPlacement ? mostTurned : term.effect.unknowns[i].unit == "m" ? mostShifted : mostYaw;
      truth_[eigenIndex(term.first + i)] = errors.uniformWithin(most);
    }
  }
}

/// Takes over the measurements in single precision, and takes the pictures of held-out poses.
void ThesisTrial::readAsProgram(RandomStream& measuring) {
  const auto copies = copiesOf(setting_.feature);
  program_->measurements = {{}, static_cast<double>(copies), 0};
  for (const ImageObservation& picture : taken_.pictures) {
    ProgramPicture read;
    read.readings.resize(joints());
    for (std::size_t i = 0; i < stage_.joints().size(); ++i) {
      read.readings[eigenIndex(i)] = static_cast<float>(picture.nominal.angle(stage_.joints()[i]));
    }
    std::vector<Eigen::Vector2f> points, pixels;
    for (const BoardObservation& observation : picture.observations) {
      for (std::size_t i = 0; i < observation.ids.size(); ++i) {
        const CornerBlock& block = observation.corners[i / 4];
        points.push_back(stage_.floorPoint(observation, static_cast<std::size_t>(observation.ids[i])).cast<float>());
        pixels.emplace_back(static_cast<float>(block.u[i % 4]), static_cast<float>(block.v[i % 4]));
      }
    }
    if (points.empty()) {
      continue;
    }
    read.points = Eigen::Map<const Eigen::Matrix2Xf>{points.front().data(), 2, eigenIndex(points.size())};
    read.pixels = Eigen::Map<const Eigen::Matrix2Xf>{pixels.front().data(), 2, eigenIndex(pixels.size())};
    for (std::size_t i = 0; i < 2 * points.size() * (copies - 1); ++i) {
      program_->measurements.scatter += std::pow(measuring.normal(pixel_), 2);
    }
    program_->measurements.pictures.push_back(std::move(read));
  }
  if (program_->heldOut) {
    program_->heldOut->draw(truth_.head(joints()), {setting_.angleNoise() ? programAngleNoise : 0, pixel_}, measuring);
  }
}

void ThesisTrial::draw(std::uint64_t seed, std::size_t number) {
  const std::string set = fmt::format("thesis set {}", number);
  RandomStream measuring{seed, set + ", measured"};
  drawTruth(seed, number);
  stage_.simulate(
      truth_, [&](double angle) { return readAngle(angle, setting_, measuring); }, cornerNoise(setting_, pixel_),
      measuring, taken_);
  pixels_.emplace(taken_, plainModel_, onePixel);
  whitened_.emplace(taken_, ourModel_, noise_);
  if (!setting_.angleNoise()) {
    flat_.emplace(taken_, plainModel_, noise_);
  }
  // visible corners are in front of the camera
  const auto atTruth = pixels_->linearize(pixels_->startState(truth_)).value();
  numbers_ = numbersOf(atTruth);
  rmsAtTruth_ = std::sqrt(2 * atTruth.cost / numbers_);
  if (program_) {
    readAsProgram(measuring);
  }
  starts_.emplace(seed, set + ", starts");
  limits_.emplace(seed, set + ", limit");
}

ProgramEstimate ThesisTrial::solveAsProgram(ThesisSolver solver) {
  const ProgramSolver program{program_->camera, program_->names, program_->measurements};
  return solver == ThesisSolver::program ? program.solve(*starts_) : program.solveFromRandomStarts(*starts_);
}

ThesisSolution ThesisTrial::solve(ThesisSolver solver) {
  ThesisSearchResult found;
  bool ranOut = false;
  if (program_ && (solver == ThesisSolver::program || solver == ThesisSolver::programStarts)) {
    const ProgramEstimate estimate = solveAsProgram(solver);
    found.unknowns = -estimate.errors; // the program adds them
    found.ended = found.unknowns.allFinite();
    ranOut = estimate.ranOut;
  } else {
    found =
        ThesisSearch{*pixels_, *whitened_, flat_ ? &*flat_ : nullptr, stage_.joints().size(), numbers_, *starts_}.solve(
            solver);
  }
  const auto there = found.ended ? pixels_->linearize(pixels_->startState(found.unknowns)) : std::nullopt;
  if (!there || numbers_ == 0) {
    return {};
  }
  ThesisSolution solution{true,
                          std::sqrt(2 * there->cost / numbers_),
                          2 * rmsAtTruth_ + 1,
                          (found.unknowns - truth_).head(joints()),
                          std::nullopt,
                          ranOut};
  if (program_ && program_->heldOut) {
    solution.heldOut = program_->heldOut->error(found.unknowns.head(joints()));
  }
  return solution;
}

bool ThesisTrial::reachesTruthFrom(const ThesisSolution& wrong) const {
  constexpr double smallestFall = 1e-12; // [px^2 / 2]
  if (!wrong.solved) {
    return false;
  }
  Eigen::VectorXd start = truth_;
  start.head(joints()) += wrong.errors;
  const auto minimum = levenbergMarquardt(*pixels_, pixels_->startState(start), {.minCostDecrease = smallestFall});
  return minimum && (minimum->state.unknowns - truth_).head(joints()).cwiseAbs().maxCoeff() < radians(0.001);
}

void ThesisTrial::addResiduals(const ThesisSolution& solution, ResidualMap& map) const {
  Eigen::VectorXd unknowns = truth_;
  unknowns.head(joints()) += solution.errors;
  for (const BoardResidual& residual : pixels_->boardResiduals(pixels_->startState(unknowns))) {
    const BoardObservation& observation = taken_.pictures[residual.picture].observations[residual.observation];
    for (std::size_t i = 0; i < observation.ids.size(); ++i) {
      map.add(stage_.floorPoint(observation, static_cast<std::size_t>(observation.ids[i])),
              residual.residual.col(eigenIndex(i)).norm());
    }
  }
}

std::vector<double> ThesisTrial::drawLimitErrors(std::size_t draws) {
  std::vector<double> result(draws, 0);
  if (setting_.noise == ThesisNoise::none) {
    return result;
  }
  const Eigen::LLT<Eigen::MatrixXd> root{whitened_->linearize(whitened_->startState(truth_)).value().hessian};
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
