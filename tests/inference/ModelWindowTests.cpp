#include "inference/Evidence.hpp"
#include "inference/ModelWindow.hpp"
#include "inference/OwnEstimates.hpp"
#include "inference/Thresholds.hpp"
#include "math/Statistics.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

namespace naocal {
namespace {

/// A linear problem with random Jacobians and noise of 1 px: own unknowns, then candidate effects of one column each.
/// With `joints` candidates act on deflections of poses, and what else deflects these is a misfit.
class LinearProblem {
public:
  static constexpr Eigen::Index poseCount = 6, rows = 12;

  LinearProblem(Eigen::Index own, Eigen::Index candidates, std::uint64_t seed, Eigen::Index joints = 1)
      : random_{seed}, own_{own}, candidates_{candidates} {
    for (Eigen::Index pose = 0; pose < poseCount; ++pose) {
      PoseRows& one = rows_.emplace_back();
      one.unknowns.resize(static_cast<std::size_t>(own + candidates));
      std::iota(one.unknowns.begin(), one.unknowns.end(), std::size_t{0});
      one.joints.resize(static_cast<std::size_t>(joints));
      std::iota(one.joints.begin(), one.joints.end(), std::size_t{0});
      one.errors = one.joints;
      one.stances.assign(one.joints.size(), 0);
      one.errorScales.assign(one.joints.size(), 1);
      one.numbers = one.freedom = rows;
      one.byDeflections = (joints > 1 ? 500 : 0) * draw(rows, joints); // [px / rad]
      one.byUnknowns = draw(rows, own + candidates);
      if (joints > 1) {
        one.byUnknowns.rightCols(candidates) = one.byDeflections / 500 * draw(joints, candidates);
      }
      one.residual = Eigen::VectorXd::Zero(rows);
    }
    sigmas_ = Eigen::VectorXd::Ones(own);
    plausible_ = Eigen::VectorXd::Ones(candidates);
  }
  LinearProblem(const LinearProblem&) = delete; // problem_ points into this object
  LinearProblem& operator=(const LinearProblem&) = delete;

  /// Measures at these truths, linearised at zero: residual = predicted - measured. `misfit`: size of deflections that
  /// nothing explains [0.002 rad].
  void measure(const Eigen::VectorXd& truth, double misfit = 0) {
    for (PoseRows& pose : rows_) {
      pose.residual = -pose.byUnknowns * truth + draw(rows, 1) +
                      misfit / 500 * pose.byDeflections * draw(pose.byDeflections.cols(), 1);
      pose.squares = pose.residual.squaredNorm();
    }
    none_.blocks.assign(rows_.size(), {});
    problem_ = {rows_, none_, Eigen::VectorXd::Zero(own_), sigmas_, candidates_};
    problem_.named = static_cast<std::size_t>(candidates_);
    problem_.plausible = plausible_;
    for (Eigen::Index i = 0; i < candidates_; ++i) {
      problem_.groups.push_back({.first = i, .count = 1});
    }
  }
  /// All rows, own unknowns first, and all residuals.
  Eigen::MatrixXd jacobian() const {
    Eigen::MatrixXd result(poseCount * rows, own_ + candidates_);
    for (Eigen::Index pose = 0; pose < poseCount; ++pose) {
      result.middleRows(pose * rows, rows) = rows_[static_cast<std::size_t>(pose)].byUnknowns;
    }
    return result;
  }
  Eigen::VectorXd residual() const {
    Eigen::VectorXd result(poseCount * rows);
    for (Eigen::Index pose = 0; pose < poseCount; ++pose) {
      result.segment(pose * rows, rows) = rows_[static_cast<std::size_t>(pose)].residual;
    }
    return result;
  }
  Eigen::MatrixXd draw(Eigen::Index height, Eigen::Index width) {
    return Eigen::MatrixXd::NullaryExpr(height, width, [&] { return normal_(random_); });
  }
  double uniform() { return boost::random::uniform_real_distribution<double>{0, 1}(random_); }
  std::vector<PoseRows>& poses() { return rows_; }
  ScoreProblem& problem() { return problem_; }
  Eigen::VectorXd& sigmas() { return sigmas_; }

private:
  boost::random::mt19937_64 random_;
  boost::random::normal_distribution<double> normal_;
  Eigen::Index own_, candidates_;
  std::vector<PoseRows> rows_;
  DriverColumns none_;
  ScoreProblem problem_;
  Eigen::VectorXd sigmas_, plausible_;
};

constexpr Noise pixelNoise{.pixel = 1, .encoder = 0};

StudentMixture mixtureOf(const ModelWindow& window, Eigen::Index unknown) {
  return {window.along(Eigen::VectorXd::Unit(window.mean.size(), unknown), Eigen::VectorXd::Zero(5)), 1e6};
}

/// Posterior mean and covariance of the own unknowns under one model, and the sizes of its effects, without any
/// shortcut.
struct BruteForce {
  Eigen::VectorXd mean, sizes;
  Eigen::MatrixXd covariance;
};
BruteForce solve(LinearProblem& problem, const WindowModel& model, double misfit,
                 const std::optional<Eigen::VectorXd>& residual = {}) {
  const Eigen::Index own = problem.problem().ownCount();
  std::vector<Eigen::Index> columns(static_cast<std::size_t>(own));
  std::iota(columns.begin(), columns.end(), Eigen::Index{0});
  Eigen::VectorXd priors(own + static_cast<Eigen::Index>(model.members.size()));
  priors.head(own) = problem.sigmas();
  for (std::size_t i = 0; i < model.members.size(); ++i) {
    columns.push_back(own + static_cast<Eigen::Index>(model.members[i].group));
    priors[own + static_cast<Eigen::Index>(i)] = model.widths[i];
  }
  const Eigen::MatrixXd jacobian = problem.jacobian()(Eigen::all, columns);
  Eigen::MatrixXd precision = jacobian.transpose() * jacobian / misfit;
  precision.diagonal() += priors.cwiseAbs2().cwiseInverse();
  const Eigen::LLT<Eigen::MatrixXd> factor{precision};
  const Eigen::MatrixXd covariance = factor.solve(Eigen::MatrixXd::Identity(precision.rows(), precision.cols()));
  const Eigen::VectorXd mean = -factor.solve(jacobian.transpose() * residual.value_or(problem.residual())) / misfit;
  return {mean.head(own), mean.tail(mean.size() - own), covariance.topLeftCorner(own, own)};
}

} // namespace

TEST_CASE("an average over models is the one that solving every model by itself gives") {
  // Proves values, covariances, mean and variance of random linear problems, with misfits from 1 to above 100, and that
  // the average lies among the models' values. Does not prove the weights, which `computeBayesFactor`'s tests cover.
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    LinearProblem problem{5, 8, seed, 4};
    Eigen::VectorXd truth = problem.draw(13, 1);
    truth.tail(6).setZero();
    problem.measure(truth, seed % 2 == 0 ? 0 : 0.3 * static_cast<double>(seed));
    const ModelWindow window = searchModelWindow({problem.problem(), pixelNoise});
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(5), squares = mean;
    for (const WindowModel& model : window.models) {
      const BruteForce exact = solve(problem, model, window.misfit);
      CHECK(model.unknowns.isApprox(exact.mean, 1e-7));
      CHECK((window.covariance + model.spread * model.spread.transpose()).isApprox(exact.covariance, 1e-7));
      mean += model.weight * exact.mean;
      squares += model.weight * (exact.covariance.diagonal() + exact.mean.cwiseAbs2());
    }
    CHECK(window.mean.isApprox(mean, 1e-7));
    CHECK(window.variance.isApprox(squares - mean.cwiseAbs2(), 1e-6));
    for (Eigen::Index i = 0; i < 5; ++i) {
      double most = 0;
      for (const WindowModel& model : window.models) {
        most = std::max(most, std::abs(model.unknowns[i]));
      }
      CHECK(std::abs(window.mean[i]) <= most);
    }
  }
}

TEST_CASE("models stay in the window down to a hundred thousandth of the likeliest") {
  // Proves that the far shoulder of an average is kept: an alias of the truth whose relative weight is below 0.001.
  LinearProblem problem{2, 6, 3};
  for (PoseRows& pose : problem.poses()) {
    pose.byUnknowns.col(3) = pose.byUnknowns.col(2) + 0.55 * problem.draw(LinearProblem::rows, 1);
  }
  Eigen::VectorXd truth = Eigen::VectorXd::Zero(8);
  truth[2] = 1.1;
  problem.measure(truth);
  const ModelWindow window = searchModelWindow({problem.problem(), pixelNoise});
  const double least = window.models.back().weight / window.models.front().weight;
  CHECK(least < 1e-3);
  CHECK(least >= 1e-5);
}

TEST_CASE("a direction that only its prior holds keeps the fitted value and the prior's sigma under every model") {
  // Proves it where one unknown is imitated by a second without bounds, as a first joint's offset is by a tracker's
  // placement, for misfits up to thousands; the usual misfit * covariance is wider than the prior. The point that the
  // problem is linearised at has an effect at a large size, at which the own unknown's derivatives pretend to tell it:
  // without `ScoreProblem::plain` its average is beyond ten prior sigmas.
  for (const bool pretends : {false, true}) {
    LinearProblem problem{4, 5, 7, 4};
    problem.sigmas() << 0.1, 10, 1, 1;
    for (PoseRows& pose : problem.poses()) {
      pose.byUnknowns.col(1) = -pose.byUnknowns.col(0);
    }
    std::vector<PoseRows> plain = problem.poses();
    for (PoseRows& pose : plain) {
      pose.unknowns.resize(4);
      pose.byUnknowns.conservativeResize(Eigen::NoChange, 4);
    }
    if (pretends) {
      for (PoseRows& pose : problem.poses()) {
        pose.byUnknowns.col(0) += 30.0 / 500 * pose.byDeflections * problem.draw(4, 1);
      }
    }
    Eigen::VectorXd truth(9);
    truth << 0, 0, 0.3, -0.2, 50, 0, 0, 0, 0;
    problem.measure(truth, pretends ? 40 : 20);
    problem.problem().plain = &plain;
    const ModelWindow window = searchModelWindow({problem.problem(), pixelNoise});
    CHECK(window.misfit > 100);
    CHECK(std::abs(window.mean[0]) < 1e-3);
    CHECK(std::sqrt(window.variance[0]) == Approx(0.1).epsilon(0.01));
    const auto [low, high] = mixtureOf(window, 0).interval(0.95);
    CHECK(low < 0);
    CHECK(high > 0);
    problem.problem().plain = nullptr;
    CHECK((std::abs(searchModelWindow({problem.problem(), pixelNoise}).mean[0]) > 0.01) == pretends);
  }
}

TEST_CASE("no model takes an unknown further than four sigma of its prior") {
  // Proves that extrapolated steps are left out along their least determined directions, and that what is left is the
  // prior's variance. A model that is fitted further already keeps its value.
  LinearProblem problem{3, 4, 11};
  Eigen::VectorXd truth = Eigen::VectorXd::Zero(7);
  truth << 9, 0.2, -0.3, 3, 0, 0, 0; // nine prior sigmas: impossible, unless the model is wrong
  problem.measure(truth);
  const ModelWindow window = searchModelWindow({problem.problem(), pixelNoise});
  for (const WindowModel& model : window.models) {
    CHECK(model.unknowns.cwiseAbs().maxCoeff() <= threshold::farthest);
  }
  CHECK(window.variance.maxCoeff() > 0.9);
}

TEST_CASE("explanations by named effects are listed that are likelier than that nothing is missing") {
  // Proves that the true effects together come first, as in the window, that nothing is listed where nothing is
  // missing, and no effect that is excluded.
  LinearProblem problem{3, 6, 9};
  Eigen::VectorXd truth = Eigen::VectorXd::Zero(9);
  problem.measure(truth);
  CHECK(listLikelyEffects({problem.problem(), pixelNoise}).empty());
  truth[4] = 3;
  truth[7] = -1.5;
  problem.measure(truth);
  const auto listed = listLikelyEffects({problem.problem(), pixelNoise});
  REQUIRE(listed.size() > 1);
  CHECK(listed.front().groups == std::vector<std::size_t>{1, 4});
  const ModelWindow window = searchModelWindow({problem.problem(), pixelNoise});
  CHECK(window.models.front().members.size() == 2);
  CHECK(listed.front().evidence > listed[1].evidence);
  for (const LikelyEffects& effects : listLikelyEffects({problem.problem(), pixelNoise}, {1})) {
    CHECK(std::count(effects.groups.begin(), effects.groups.end(), std::size_t{1}) == 0);
  }
  CHECK(listed.back().evidence > 0);
  for (const LikelyEffects& effects : listed) {
    CHECK(!effects.groups.empty());
    CHECK(std::is_sorted(effects.groups.begin(), effects.groups.end()));
  }
}

TEST_CASE("where an unknown is left to its prior, effects take up what it would have compensated") {
  // Proves the sizes of a model against a fit of its effect alone, with the unknown at its prior's value: otherwise an
  // effect would keep a size that only makes sense beside an unknown nine sigma off.
  LinearProblem problem{1, 2, 17};
  for (PoseRows& pose : problem.poses()) {
    pose.byUnknowns.col(1) = pose.byUnknowns.col(0) + 0.2 * pose.byUnknowns.col(1);
  }
  Eigen::VectorXd truth(3);
  truth << 40, -31, 0;
  problem.measure(truth);
  const ModelWindow window = searchModelWindow({problem.problem(), pixelNoise});
  int held = 0;
  for (const WindowModel& model : window.models) {
    if (model.members.size() == 1 && model.members.front().group == 0 && model.unknowns[0] == 0) {
      const Eigen::VectorXd column = problem.jacobian().col(1);
      const double precision = column.squaredNorm() / window.misfit + std::pow(model.widths.front(), -2);
      CHECK(model.sizes[0] == Approx(-column.dot(problem.residual()) / window.misfit / precision));
      ++held;
    }
  }
  CHECK(held > 0);
}

TEST_CASE("intervals of 95 % hold the truth in as many of drawn problems, bounds of 99.95 % in nearly all", "[slow]") {
  // Proves calibration of the whole answer where the model of the world is right: own unknowns from their priors, in
  // three of four problems one effect, of a plausible width, with aliases; 2000 problems of three unknowns. A bound of
  // 3.5 standard deviations of the same averages fails more often.
  int all = 0, inInterval = 0, outOfBound = 0, beyondSigmas = 0;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    constexpr Eigen::Index own = 3, candidates = 8;
    LinearProblem problem{own, candidates, seed};
    for (PoseRows& pose : problem.poses()) { // pairs of candidates are alike, and all are alike to the own unknowns
      for (Eigen::Index i = 0; i < candidates; ++i) {
        pose.byUnknowns.col(own + i) = 0.4 * pose.byUnknowns.col(own + i) + pose.byUnknowns.col(i % own);
        if (i % 2 == 1) {
          pose.byUnknowns.col(own + i) = 0.8 * pose.byUnknowns.col(own + i - 1) + 0.3 * pose.byUnknowns.col(own + i);
        }
      }
      pose.byUnknowns *= 0.7;
    }
    Eigen::VectorXd truth = Eigen::VectorXd::Zero(own + candidates);
    truth.head(own) = problem.draw(own, 1);
    if (problem.uniform() < 0.5) { // the odds that the window assumes: each effect as likely as none
      double width = 0, sum = 0;
      const double drawn = problem.uniform();
      for (const auto& [one, odds] : plausibleWidths) {
        width = drawn >= sum ? one : width;
        sum += odds;
      }
      const auto which = own + static_cast<Eigen::Index>(problem.uniform() * static_cast<double>(candidates));
      truth[which] = width * problem.draw(1, 1)(0, 0);
    }
    problem.measure(truth);
    const ModelWindow window = searchModelWindow({problem.problem(), pixelNoise});
    for (Eigen::Index i = 0; i < own; ++i) {
      const StudentMixture mixture{window.along(Eigen::VectorXd::Unit(own, i), Eigen::VectorXd::Zero(candidates)),
                                   window.misfit > 1 ? window.freedom : 1e6};
      const auto [low, high] = mixture.interval(0.95);
      const auto [least, most] = mixture.interval(0.9995);
      ++all;
      inInterval += low <= truth[i] && truth[i] <= high;
      outOfBound += truth[i] < least || truth[i] > most;
      beyondSigmas += std::abs(truth[i] - window.mean[i]) > 3.5 * std::sqrt(window.variance[i]);
    }
  }
  INFO("inside " << inInterval << ", beyond the bound " << outOfBound << ", beyond 3.5 sigma " << beyondSigmas << " of "
                 << all);
  CHECK(inInterval > 0.94 * all);
  CHECK(inInterval < 0.975 * all);
  CHECK(outOfBound <= 0.001 * all);
  CHECK(outOfBound <= beyondSigmas);
}

TEST_CASE("what may bias an answer unnoticed is an effect that hides behind an unknown, at the size that would show") {
  // Proves the ellipsoid against its formula with one column: |bias| = |answer| / sqrt(S / lambda + 1 / 9).
  LinearProblem problem{2, 3, 5};
  for (PoseRows& pose : problem.poses()) {
    pose.byUnknowns.col(2) = pose.byUnknowns.col(0) + 0.05 * pose.byUnknowns.col(2);
  }
  problem.measure(Eigen::VectorXd::Zero(5));
  const ModelWindow window = searchModelWindow({problem.problem(), pixelNoise});
  REQUIRE(window.models.front().members.empty());
  REQUIRE(window.undetected.size() == 3);
  const Eigen::MatrixXd jacobian = problem.jacobian();
  Eigen::MatrixXd precision = jacobian.transpose() * jacobian;
  precision.topLeftCorner(2, 2).diagonal().array() += 1;
  const Eigen::VectorXd answer = precision.topLeftCorner(2, 2).ldlt().solve(precision.block(0, 2, 2, 1));
  const double information = precision(2, 2) - answer.dot(precision.block(0, 2, 2, 1).col(0));
  const double lambda = requiredNoncentrality(0.8, 1, 0.05 / 3);
  const Eigen::VectorXd expected = answer / std::sqrt(information / lambda + 1.0 / 9);
  CHECK(window.undetected[0].biases.col(0).cwiseAbs().isApprox(expected.cwiseAbs(), 1e-6));
  CHECK(window.undetected[0].biases.norm() > 3 * window.undetected[1].biases.norm());
}

TEST_CASE("what an unnoticed effect shifts includes the effects that the model has already") {
  // Proves shifts of unknowns and of the likeliest model's own effect against solving that model again, with the
  // unnoticed effect in the measurements.
  LinearProblem problem{2, 3, 5};
  for (PoseRows& pose : problem.poses()) {
    pose.byUnknowns.col(3) = pose.byUnknowns.col(2) + 0.3 * pose.byUnknowns.col(3);
  }
  Eigen::VectorXd truth = Eigen::VectorXd::Zero(5);
  truth[2] = 3;
  problem.measure(truth);
  const ModelWindow window = searchModelWindow({problem.problem(), pixelNoise});
  const WindowModel& likeliest = window.models.front();
  REQUIRE(likeliest.members.size() == 1);
  REQUIRE(likeliest.members.front().group == 0);
  REQUIRE(window.undetected.front().group == 1);
  const UndetectedEffect& unnoticed = window.undetected.front();
  const Eigen::VectorXd measured = problem.residual() - problem.jacobian().col(3) * unnoticed.sizes(0, 0);
  const BruteForce without = solve(problem, likeliest, window.misfit),
                   with = solve(problem, likeliest, window.misfit, measured);
  CHECK(Eigen::VectorXd{with.mean - without.mean}.isApprox(unnoticed.biases.col(0), 1e-6));
  CHECK(with.sizes[0] - without.sizes[0] == Approx(unnoticed.taken(0, 0)));
  CHECK(std::abs(unnoticed.taken(0, 0)) > 0.5 * std::abs(unnoticed.sizes(0, 0)));
}

} // namespace naocal
