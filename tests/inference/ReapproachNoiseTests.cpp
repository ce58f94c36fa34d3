#include "inference/NoiseLevels.hpp"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <catch2/catch.hpp>

namespace naocal {
namespace {

/// Forty poses of two joints, each approached three times. The first joint's readings are off at every approach; the
/// one candidate is that joint's gain: its column is the joint's derivative times the angle as read, error included.
class ErroneousReadings {
public:
  static constexpr double error = 5e-4; // [rad]

  ErroneousReadings() {
    constexpr int approaches = 3, coordinates = 2, joints = 2;
    for (int number = 0; number < 40; ++number) {
      PoseRows& pose = rows_.emplace_back();
      pose.unknowns = {0, 1}; // an own unknown, the candidate
      pose.numbers = pose.freedom = coordinates * approaches;
      pose.byDeflections.setZero(coordinates * approaches, joints * approaches);
      pose.byUnknowns.setZero(coordinates * approaches, 2);
      pose.residual.setZero(coordinates * approaches);
      const Eigen::Matrix2d byAngles = Eigen::Matrix2d::NullaryExpr([&] { return 20000 * draw(); }); // [px / rad]
      const double angle = 0.02 * draw(); // [rad]
      for (int approach = 0; approach < approaches; ++approach) {
        const double wrong = error * draw();
        pose.byDeflections.block<2, 1>(2 * approach, approach) = byAngles.col(0);
        pose.byDeflections.block<2, 1>(2 * approach, approaches + approach) = byAngles.col(1);
        pose.byUnknowns.block<2, 1>(2 * approach, 1) = byAngles.col(0) * (angle + wrong);
        pose.residual.segment<2>(2 * approach) =
            byAngles.col(0) * wrong + Eigen::Vector2d::NullaryExpr([&] { return noise.pixel * draw(); });
      }
      for (std::size_t column = 0; column < joints * approaches; ++column) {
        pose.joints.push_back(column / approaches);
        pose.errors.push_back(column);
        pose.stances.push_back(0);
        pose.errorScales.push_back(0); // the encoder's step is not known
      }
    }
    none_.blocks.resize(rows_.size());
    problem_ = {rows_, none_, Eigen::VectorXd::Zero(1), Eigen::VectorXd::Ones(1), 1};
    problem_.groups = {{.first = 0, .count = 1}};
    problem_.named = 1;
    problem_.plausible = Eigen::VectorXd::Constant(1, 0.02);
  }
  ErroneousReadings(const ErroneousReadings&) = delete; // problem_ points into this object
  ErroneousReadings& operator=(const ErroneousReadings&) = delete;

  /// Re-approach noise with the candidate counted as one that varies within a pose, or not [rad].
  double reapproachNoise(bool varies) const {
    return estimateNoiseLevels(problem_, noise, {.reapproached = true}, {varies}).noise.reapproach;
  }

private:
  double draw() { return normal_(random_); }

  const Noise noise;
  boost::random::mt19937_64 random_{1};
  boost::random::normal_distribution<double> normal_;
  std::vector<PoseRows> rows_;
  DriverColumns none_;
  ScoreProblem problem_;
};

} // namespace

TEST_CASE("the errors of readings within a pose are noise, not the gain of a joint") {
  // Proves that an effect of the posture does not stand for the readings' errors, which its columns contain: as one
  // that varies within a pose, a gain of fifty times its usual size takes them over. One joint of two has these
  // errors, so that their mean square over both joints is half of the first one's.
  const ErroneousReadings readings;
  CHECK(readings.reapproachNoise(false) == Approx(ErroneousReadings::error / std::sqrt(2)).epsilon(0.3));
  CHECK(readings.reapproachNoise(true) == 0);
}

} // namespace naocal
