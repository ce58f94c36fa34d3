#include "diagnosis/views/TellingPairs.hpp"

#include "diagnosis/PerfectBut.hpp"
#include "diagnosis/Questioned.hpp"
#include "estimation/CandidateTerms.hpp"
#include "estimation/ModelBuilder.hpp"
#include "inference/DriverBasis.hpp"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <catch2/catch.hpp>

using namespace naocal;

namespace {

struct Told {
  explicit Told(const CaptureSet& set)
      : measurements{buildMeasurements({set}, loadRobot(configurationDirectory(), "V6"))},
        model{buildModel(measurements)}, fit{calibrate(measurements, model)},
        drivers{collectDrivers(measurements, model, fit.unknowns)}, telling{findTellingPairs({measurements, model, fit},
                                                                                             drivers)} {}

  std::string sentence() const { return formatTellingSentence(telling, drivers, measurements.robot); }
  std::string label(std::size_t i) const {
    return formatTellingLabel(telling.pairs.at(i), drivers, measurements.robot);
  }

  Measurements measurements;
  Model model;
  CalibrationResult fit;
  std::vector<DriverSeries> drivers;
  TellingPairs telling;
};

/// Corners predicted by the fit plus an effect, with noise.
CaptureSet flawed(const std::string& label, double size, std::uint64_t seed) {
  const CaptureSet set = simulatedSet(24, seed);
  const Questioned asked{set, false};
  const std::vector<Term> all = candidateTerms(asked.measurements);
  const auto term = std::find_if(all.begin(), all.end(), [&](const Term& one) { return one.label() == label; });
  REQUIRE(term != all.end());
  CaptureSet made = perfectButFor(*term, Eigen::VectorXd::Constant(1, size), asked, set);
  boost::random::mt19937_64 random{seed};
  boost::random::normal_distribution<double> noise{0, 0.3}; // [px], as in the simulation
  for (Capture& capture : made.captures) {
    for (BoardCorners& corners : *capture.corners) {
      for (Eigen::Vector2d& uv : corners.uv) {
        uv += Eigen::Vector2d{noise(random), noise(random)};
      }
    }
  }
  return made;
}

} // namespace

TEST_CASE("the most telling pair is the error that a gear with play makes, over how it was approached", "[slow]") {
  // Proves that joint and driver are found, that the error changes its sign, and that the trend explains over 70 % of
  // the squared error. Other joints with parallel axes may explain nearly as much.
  const Told told{flawed("hysteresis@LKneePitch", 0.02, 3)};
  INFO(told.sentence());
  REQUIRE_FALSE(told.telling.pairs.empty());
  const TellingPair& first = told.telling.pairs.front();
  const DriverSeries& driver = told.drivers[first.driver];
  CHECK(driver.kind == Driver::approach);
  CHECK(told.measurements.robot.joints[driver.joint].name == "LKneePitch");
  CHECK(first.share > 0.7);
  CHECK(first.chance < 0.02);
  CHECK(first.from * first.to < 0);
}

TEST_CASE("a soft joint shows over what bends it", "[slow]") {
  // Proves that smooth drivers are found too: the best driver is an angle or torque and explains over 30 % of the
  // squared error.
  const Told told{flawed("elasticity@LAnklePitch", 0.01, 5)};
  INFO(told.sentence());
  REQUIRE_FALSE(told.telling.pairs.empty());
  const DriverSeries& driver = told.drivers[told.telling.pairs.front().driver];
  CHECK((driver.kind == Driver::angle || driver.kind == Driver::torque));
  CHECK(told.telling.pairs.front().share > 0.3);
}

TEST_CASE("next pairs tell something else than those before them", "[slow]") {
  // Proves that no joint and no label occurs twice, and that shares decrease.
  const Told told{flawed("hysteresis@LKneePitch", 0.02, 3)};
  const std::vector<TellingPair>& pairs = told.telling.pairs;
  REQUIRE(pairs.size() > 1);
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    CHECK(pairs[i].share <= pairs[i - 1].share);
    for (std::size_t j = 0; j < i; ++j) {
      const bool bothJoints =
          pairs[i].error == TellingPair::Error::joint && pairs[j].error == TellingPair::Error::joint;
      CHECK_FALSE((bothJoints && pairs[i].motor == pairs[j].motor));
      CHECK(told.label(i) != told.label(j));
    }
  }
}

TEST_CASE("on sound captures hardly any pair is called telling", "[slow]") {
  // Proves the false-alarm rate over whole fits, with hundreds of pairs and three captures per pose: 5 % of 40 sets are
  // expected; a 5 % rate exceeds the limit once in 300 runs.
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Told told{simulatedSet(16, seed)};
    found += !told.telling.pairs.empty();
    CHECK(told.telling.tried > 100);
  }
  CHECK(found <= 6);
}
