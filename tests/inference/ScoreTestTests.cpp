#include "diagnosis/Questioned.hpp"
#include "diagnosis/evidence/Power.hpp"
#include "inference/ScoreProblem.hpp"
#include "inference/ScoreTest.hpp"
#include "math/Statistics.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <numeric>

namespace naocal {
namespace {

/// Minimum over the chosen unknowns of the quadratic with this Hessian and gradient.
double least(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& gradient, const std::vector<Eigen::Index>& chosen) {
  const Eigen::VectorXd g = gradient(chosen);
  const Eigen::MatrixXd h = hessian(chosen, chosen);
  return -g.dot(h.fullPivLu().solve(g));
}

} // namespace

TEST_CASE("a score test's fall of chi2 is what adding the candidate gains") {
  // Compares the score test's chi2 decrease with the dense normal equations of the model plus that candidate, for every
  // candidate that is not absorbed. The linearisation is tested with the residuals.
  const Questioned asked{simulatedSet(8, 3), false};
  const ScoreProblem& problem = asked.candidateTests.problem();
  const Noise noise{asked.fit.noise.pixel, asked.fit.noise.encoder, 4e-4};
  const NullModel alone{problem, noise};
  const ScoreTest tests{alone};
  const Eigen::VectorXd priorScore = problem.priorScore();
  const PoseResiduals measured = measuredResiduals(*problem.poses);
  const Eigen::VectorXd falls = tests.chi2Decreases(measured, alone(measured, priorScore).own);

  const Eigen::Index count = problem.ownCount() + problem.candidates;
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(count);
  hessian.topLeftCorner(problem.ownCount(), problem.ownCount()) =
      problem.sigmas.cwiseAbs2().cwiseInverse().asDiagonal();
  gradient.head(problem.ownCount()) = priorScore;
  for (const PoseRows& rows : *problem.poses) {
    const PoseSystem pose = systemOf(rows);
    const MarginalSystem part = marginalize(pose, noise, jointErrorRoot(pose, noise));
    const std::vector<Eigen::Index> columns(pose.unknowns.begin(), pose.unknowns.end());
    hessian(columns, columns) += part.hessian;
    gradient(columns) += part.unknownGradient;
  }
  std::vector<Eigen::Index> own(static_cast<std::size_t>(problem.ownCount()));
  std::iota(own.begin(), own.end(), 0);
  int compared = 0;
  for (std::size_t i = 0; i < asked.candidateTests.candidates().size(); ++i) {
    if (tests.keptFraction(i) < 1e-2 || tests.degreesOfFreedom(i) < problem.groups[i].count) {
      continue; // partly absorbed: the dense equations are nearly singular
    }
    std::vector<Eigen::Index> with = own;
    for (Eigen::Index k = 0; k < problem.groups[i].count; ++k) {
      with.push_back(problem.ownCount() + problem.groups[i].first + k);
    }
    const double gain = least(hessian, gradient, own) - least(hessian, gradient, with);
    CAPTURE(asked.candidateTests.candidates()[i].label());
    CHECK(falls[static_cast<Eigen::Index>(i)] == Approx(gain).epsilon(1e-5).margin(1e-5));
    ++compared;
  }
  CHECK(compared > 50);
}

TEST_CASE("pure noise lowers chi2 by as much as a candidate has unknowns") {
  // Proves that drawn noise has the assumed covariance: the statistic ~ chi2 has the mean of its degrees of freedom,
  // for candidates and for curves of the map, including pose noise. Whether a robot's noise is like that is not tested.
  const Questioned asked{simulatedSet(8, 3), true};
  const ScoreProblem& problem = asked.candidateTests.problem();
  const Noise noise{asked.fit.noise.pixel, asked.fit.noise.encoder, 6e-4};
  constexpr Eigen::Index draws = 3000;
  const NullModel alone{problem, noise};
  const ScoreTest tests{alone};
  const PoseResiduals drawn = drawResiduals(*problem.poses, noise, draws, 1);
  const Eigen::MatrixXd falls = tests.chi2Decreases(drawn, alone(drawn, Eigen::VectorXd::Zero(problem.ownCount())).own);
  double worst = 0;
  for (std::size_t i = 0; i < problem.groups.size(); ++i) {
    const auto freedom = static_cast<double>(tests.degreesOfFreedom(i));
    if (freedom > 0) {
      const double error = falls.row(static_cast<Eigen::Index>(i)).mean() - freedom;
      const std::string name =
          i < asked.candidateTests.candidates().size() ? asked.candidateTests.candidates()[i].label() : "a curve";
      CAPTURE(name, freedom, error);
      CHECK(std::abs(error) < 5 * std::sqrt(2 * freedom / draws));
      worst = std::max(worst, std::abs(error) / std::sqrt(2 * freedom / draws));
    }
  }
  CHECK(worst < 5); // standard errors, over about 200 groups
}

TEST_CASE("power follows the noncentral chi2 distribution") {
  // Compares power and its inverse with published values for 55 independent tests at a family-wise 5 % (critical chi2
  // 11.2): power 0.43, 0.87 and 1.00 at noncentrality 10, 20 and 40; 90 % requires 21.4.
  const double critical = 8.2e-4; // of chi2 = 11.2 with one degree of freedom
  CHECK(detectionPower(10, 1, critical) == Approx(0.43).margin(0.01));
  CHECK(detectionPower(20, 1, critical) == Approx(0.87).margin(0.01));
  CHECK(detectionPower(40, 1, critical) == Approx(1.00).margin(0.005));
  CHECK(requiredNoncentrality(0.9, 1, critical) == Approx(21.4).margin(0.3));
}

TEST_CASE("a candidate is as sure to be noticed as the unknown of it that is hardest to see") {
  // Proves that the power is that of the least detectable unknown.
  GroupEvidence group;
  group.freedom = 2;
  group.covariance = Eigen::Vector2d{0.01, 1}.asDiagonal();
  const double sharp = computeSensitivity(group, Eigen::Vector2d{1, 100}, 1e-3).power;
  const double blunt = computeSensitivity(group, Eigen::Vector2d{1, 1}, 1e-3).power;
  CHECK(sharp > 0.99);
  CHECK(blunt == Approx(detectionPower(1, 2, 1e-3)));
}

TEST_CASE("how far an effect moves corners is what predictions show when it is put into the model") {
  // Compares `movedPx` with predictions with and without a small effect, including the response of the other unknowns
  // (from the dense normal equations). Predictions are linear and robust weights near 1, to within 4 %.
  const Questioned asked{simulatedSet(8, 3), false};
  const ScoreProblem& problem = asked.candidateTests.problem();
  const NullModel alone{problem, asked.fit.noise};
  const ScoreTest tests{alone};
  for (const char* label : {"elasticity@LKneePitch", "focalLength@top", "boardScale@A"}) {
    const std::size_t candidate = asked.candidateTests.findCandidate(label).value();
    const ColumnGroup& group = problem.groups[candidate];
    const Eigen::VectorXd sizes = 0.1 * problem.plausible.segment(group.first, group.count);
    Model larger = asked.model;
    larger.add(asked.candidateTests.candidates()[candidate]);
    const Residuals residuals{asked.measurements, larger, asked.fit.noise, asked.fit.loss};
    Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(problem.ownCount() + group.count);
    unknowns.head(problem.ownCount()) = asked.fit.unknowns;
    const auto before = residuals.boardResiduals(residuals.startState(unknowns));
    Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(unknowns.size(), unknowns.size());
    const auto linear = residuals.linearize(residuals.startState(unknowns));
    for (const PoseSystem& pose : linear->poses) {
      const MarginalSystem part = marginalize(pose, asked.fit.noise, jointErrorRoot(pose, asked.fit.noise));
      const std::vector<Eigen::Index> columns(pose.unknowns.begin(), pose.unknowns.end());
      hessian(columns, columns) += part.hessian;
    }
    Eigen::MatrixXd own = hessian.topLeftCorner(problem.ownCount(), problem.ownCount());
    own.diagonal() += problem.sigmas.cwiseAbs2().cwiseInverse();
    unknowns.head(problem.ownCount()) -=
        own.ldlt().solve(hessian.topRightCorner(problem.ownCount(), group.count) * sizes);
    unknowns.tail(group.count) = sizes;
    const auto after = residuals.boardResiduals(residuals.startState(unknowns));
    double squares = 0, corners = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      squares += (after[i].predicted - before[i].predicted).squaredNorm();
      corners += static_cast<double>(before[i].predicted.cols());
    }
    CAPTURE(label);
    CHECK(tests.movedPx(candidate, sizes) == Approx(std::sqrt(squares / corners)).epsilon(0.04));
  }
}

TEST_CASE("a sum over poses without a row is zero") {
  // Proves that poses without valid corners are handled, with many columns too.
  GramSum sum{64};
  sum.add({0, 1, 2}, Eigen::MatrixXd{0, 3});
  CHECK(sum.sum().isZero(0));
}

} // namespace naocal
