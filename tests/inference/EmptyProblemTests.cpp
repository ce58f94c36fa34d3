#include "inference/Evidence.hpp"
#include "inference/NoiseLevels.hpp"
#include "inference/PoseMisfit.hpp"
#include "inference/ScoreTest.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

namespace naocal {
namespace {

struct Counts {
  Eigen::Index poses = 3, joints = 2, own = 4, candidates = 5;
};

/// A linear problem with fixed Jacobians, of which any count may be zero.
class SmallProblem {
public:
  explicit SmallProblem(const Counts& counts) {
    for (Eigen::Index pose = 0; pose < counts.poses; ++pose) {
      PoseRows& one = rows_.emplace_back();
      one.unknowns.resize(static_cast<std::size_t>(counts.own + counts.candidates));
      std::iota(one.unknowns.begin(), one.unknowns.end(), std::size_t{0});
      one.joints.resize(static_cast<std::size_t>(counts.joints));
      std::iota(one.joints.begin(), one.joints.end(), std::size_t{0});
      one.errors = one.joints;
      one.stances.assign(one.joints.size(), 0);
      one.errorScales.assign(one.joints.size(), 1);
      one.numbers = one.freedom = height;
      one.byDeflections = 300 * wave(pose, counts.joints);
      one.byUnknowns = 300 * wave(pose + 7, counts.own + counts.candidates);
      one.residual = 0.3 * wave(pose + 20, 1);
      one.squares = one.residual.squaredNorm();
    }
    none_.blocks.resize(rows_.size());
    problem_ = {rows_, none_, Eigen::VectorXd::Zero(counts.own), Eigen::VectorXd::Constant(counts.own, 0.1),
                counts.candidates};
    problem_.plausible = Eigen::VectorXd::Constant(counts.candidates, 0.01);
    for (Eigen::Index i = 0; i < counts.candidates; ++i) {
      problem_.groups.push_back({.first = i, .count = 1});
    }
    problem_.named = problem_.groups.size();
  }
  SmallProblem(const SmallProblem&) = delete; // problem_ points into this object
  SmallProblem& operator=(const SmallProblem&) = delete;

  const ScoreProblem& problem() const { return problem_; }

private:
  static constexpr Eigen::Index height = 12;

  static Eigen::MatrixXd wave(Eigen::Index seed, Eigen::Index width) {
    return Eigen::MatrixXd::NullaryExpr(height, width, [&](Eigen::Index row, Eigen::Index column) {
      return std::sin(static_cast<double>(1 + 5 * seed + 3 * row * (column + 1) + column * column));
    });
  }

  std::vector<PoseRows> rows_;
  DriverColumns none_;
  ScoreProblem problem_;
};

} // namespace

TEST_CASE("evidence, misfit and noise levels survive a problem that lacks unknowns, candidates, joints or poses") {
  // Proves that empty lists and matrices lead to finite numbers: no evidence where there is nothing it could be for.
  // Whether the numbers of full problems are right is tested elsewhere.
  const Counts counts = GENERATE(Counts{.own = 0}, Counts{.candidates = 0}, Counts{.joints = 0}, Counts{.poses = 0},
                                 Counts{.own = 0, .candidates = 0}, Counts{.own = 0, .candidates = 60},
                                 Counts{.poses = 0, .joints = 0, .own = 0, .candidates = 0});
  CAPTURE(counts.poses, counts.joints, counts.own, counts.candidates);
  const SmallProblem small{counts};
  const ScoreProblem& problem = small.problem();
  const Noise noise{.pixel = 0.3, .encoder = 4e-4, .pose = 0};
  const Evidence evidence = computeEvidence({problem, noise}, 40, 1);
  CHECK(evidence.groups.size() == problem.groups.size());
  CHECK(std::isfinite(evidence.pValue));
  CHECK(std::isfinite(evidence.criticalP));
  CHECK((counts.candidates > 0 || evidence.pValue == 1));
  for (const GroupEvidence& group : evidence.groups) {
    CHECK(std::isfinite(group.bayes));
    CHECK(std::isfinite(group.likelihoodRatio));
  }
  const PoseMisfit misfit = testPoseMisfit(problem, noise);
  CHECK(std::isfinite(misfit.chi2));
  CHECK(misfit.freedom >= 1);
  const NoiseLevels levels = estimateNoiseLevels(problem, noise, {.reapproached = true, .restood = true},
                                                 std::vector<bool>(problem.groups.size(), true));
  CHECK(std::isfinite(levels.noise.pose));
  CHECK(std::isfinite(levels.scatter));
}

TEST_CASE("a group without columns has no evidence") {
  // Proves the same for one group among others that has no columns.
  const SmallProblem small{{}};
  ScoreProblem problem = small.problem();
  problem.groups.push_back({.first = 4, .count = 0});
  problem.named = problem.groups.size();
  const Evidence evidence = computeEvidence({problem, {.pixel = 0.3, .encoder = 4e-4, .pose = 0}}, 20, 1);
  CHECK(evidence.groups.back().bayes == 0);
  CHECK(evidence.groups.back().pValue == 1);
  CHECK(std::isfinite(evidence.pValue));
}

} // namespace naocal
