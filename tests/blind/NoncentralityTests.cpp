#include "blind/NaoV6.hpp"
#include "writer/Noncentrality.hpp"
#include "writer/Question.hpp"
#include "writer/SetFile.hpp"

#include <catch2/catch.hpp>
#include <map>

namespace blind {
namespace {

Eigen::VectorXd stacked(const ObservedCorners& seen) {
  std::vector<double> values;
  for (const auto& sight : seen) {
    for (const Eigen::Vector2d& corner : sight) {
      values.insert(values.end(), {corner.x(), corner.y()});
    }
  }
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// The same session with newly drawn reading and friction errors, from the distributions of staging.
void redraw(Session& session, const NoiseRegime& noise, RandomStream& chance) {
  const double half = noise.stiction / std::sqrt(2.0);
  std::map<int, Eigen::VectorXd> ofPose;
  for (Reading& reading : session.readings) {
    auto& sticking = ofPose.try_emplace(reading.pose, Eigen::VectorXd::Zero(reading.unread.size())).first->second;
    if (reading.repeat == 0) {
      for (double& angle : sticking) {
        angle = chance.uniformOfSigma(half);
      }
    }
    for (Eigen::Index i = 0; i < reading.unread.size(); ++i) {
      reading.unread[i] = chance.uniformOfSigma(encoderStep / std::sqrt(12.0));
      reading.stuck[i] = sticking[i] + chance.uniformOfSigma(half);
    }
    const int left = naoV6().joint("LHipYawPitch"), right = naoV6().joint("RHipYawPitch");
    reading.unread[right] = reading.unread[left];
    reading.stuck[right] = reading.stuck[left];
  }
}

} // namespace

TEST_CASE("the noncentrality is the mean of the squared score over its variance, by drawing noise") {
  // Proves formula, Jacobian and noise model together, by Monte Carlo over 400 noise draws: without the flaw the score
  // d^T M Sigma^-1 r has mean 0 and variance lambda; with the flaw its mean is lambda.
  RandomStream chance{11, "lambda"};
  const DesignItem item{"catalogue", "elasticity", 30, 8, "stiction 0.05"};
  const Question question = drawQuestion(naoV6(), item, chance);
  REQUIRE(question.hidden.size() == 1);
  CHECK(question.hidden[0].noncentrality == Approx(30).epsilon(0.03));

  Robot sound = question.robot;
  sound.flaws.joints.assign(sound.flaws.joints.size(), {});
  Session quiet = question.session;
  for (Reading& reading : quiet.readings) {
    reading.unread.setZero();
    reading.stuck.setZero();
  }
  const NoiseRegime& noise = question.plan.noise;
  const Noncentrality noncentrality{sound, quiet, noise};
  const Eigen::VectorXd expected = Noncentrality::stacked(TruePictures{sound, quiet}, quiet);
  const Eigen::VectorXd flaw = Noncentrality::stacked(TruePictures{question.robot, quiet}, quiet) - expected;
  const double lambda = noncentrality.product(flaw, flaw);
  constexpr int draws = 400;
  double sum = 0, squares = 0, sumWith = 0;
  for (int draw = 0; draw < draws; ++draw) {
    Session session = quiet;
    redraw(session, noise, chance);
    for (const Robot* robot : std::initializer_list<const Robot*>{&sound, &question.robot}) {
      const Eigen::VectorXd seen = stacked(noisyCorners(TruePictures{*robot, session}, session, noise, chance));
      const double score = noncentrality.product(flaw, seen - expected);
      if (robot == &sound) {
        sum += score;
        squares += score * score;
      } else {
        sumWith += score;
      }
    }
  }
  const double mean = sum / draws, variance = squares / draws - mean * mean;
  CHECK(std::abs(mean) < 4 * std::sqrt(lambda / draws));
  CHECK(variance == Approx(lambda).epsilon(4 * std::sqrt(2.0 / draws)));
  CHECK(sumWith / draws == Approx(lambda).margin(4 * std::sqrt(lambda / draws)));
}

TEST_CASE("what offsets and mounts explain has no noncentrality") {
  // Proves the projection: a changed offset and mount have noncentrality with known parameters, but less than 1/1000 of
  // it when offsets and mounts are estimated.
  RandomStream chance{12, "offsets"};
  const Question question = drawQuestion(naoV6(), {"control", "", 0, 12, "clean"}, chance);
  const Noncentrality noncentrality{question.robot, question.session, question.plan.noise};
  Robot other = question.robot;
  other.offsets[naoV6().joint("HeadPitch")] += 1e-4;
  other.mountTurns[0].z() += 1e-4;
  const Eigen::VectorXd change =
      Noncentrality::stacked(TruePictures{other, question.session}, question.session) -
      Noncentrality::stacked(TruePictures{question.robot, question.session}, question.session);
  CHECK(noncentrality.knownProduct(change, change) > 1);
  CHECK(noncentrality.product(change, change) < 1e-3 * noncentrality.knownProduct(change, change));
}

} // namespace blind
