#include "diagnosis/views/Trend.hpp"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <catch2/catch.hpp>
#include <cmath>

using namespace naocal;

namespace {

struct Chance {
  explicit Chance(std::uint64_t seed) : random{seed} {}
  boost::random::mt19937_64 random;
  boost::random::normal_distribution<double> normal;
  double operator()() { return normal(random); }
};

/// Poses with many corners that share most of their error; x varies between poses, within poses, or has two values.
enum class Varies { between, within, twoValues };
std::vector<TrendSample> corners(std::size_t poses, Varies varies, double slope, Chance& chance) {
  std::vector<TrendSample> samples;
  for (std::size_t pose = 0; pose < poses; ++pose) {
    const double shared = chance(), place = chance();
    for (int corner = 0; corner < 40; ++corner) {
      const double within = chance();
      const double x = varies == Varies::between ? place : varies == Varies::within ? within : pose % 2 ? 1.0 : -1.0;
      samples.push_back({Trend::blockOf(pose, poses), x, slope * x + shared + 0.1 * chance(), 1});
    }
  }
  return samples;
}

} // namespace

TEST_CASE("corners of one pose count once: trends that are not there are found as rarely as promised", "[slow]") {
  // Proves that 40 corners with a common error do not count as independent samples, for drivers between and within
  // poses and with two values, and for few and many poses; an F test over corners would be significant in almost every
  // case. Errors shared between poses are not covered.
  Chance chance{3};
  constexpr int sets = 300;
  for (const std::size_t poses : {12u, 40u, 100u}) {
    for (const Varies varies : {Varies::between, Varies::within, Varies::twoValues}) {
      int found = 0;
      for (int set = 0; set < sets; ++set) {
        found += computeFamilyWiseChances({Trend{corners(poses, varies, 0, chance)}}, 99, 1).front() <= 0.05;
      }
      CAPTURE(poses, int(varies));
      CHECK(found <= 27); // expected 15 of 300; 3 sigma above
    }
  }
}

TEST_CASE("among many trends over related drivers the clearest is rarely called clear by chance", "[slow]") {
  // Proves that the family-wise chance accounts for all tested trends, although they are correlated, and that the test
  // is not overly conservative.
  Chance chance{4};
  constexpr int sets = 150;
  int found = 0;
  for (int set = 0; set < sets; ++set) {
    std::vector<TrendSample> once = corners(24, Varies::between, 0, chance);
    std::vector<Trend> trends;
    for (int driver = 0; driver < 30; ++driver) {
      std::vector<TrendSample> turned = once;
      const double share = chance(), other = chance();
      std::vector<double> own(24);
      for (double& value : own) {
        value = chance();
      }
      for (TrendSample& sample : turned) {
        sample.x = share * sample.x + other * own[sample.block];
      }
      trends.emplace_back(turned);
    }
    const std::vector<double> chances = computeFamilyWiseChances(trends, 99, 1);
    found += *std::min_element(chances.begin(), chances.end()) <= 0.05;
  }
  CHECK(found <= 16); // expected 7.5
  CHECK(found >= 1);
}

TEST_CASE("a trend is found whether its driver is smooth, has two values or varies within poses") {
  // Proves that all kinds of drivers are detected with twelve poses and a curve of three times the scatter between
  // poses.
  Chance chance{5};
  for (const Varies varies : {Varies::between, Varies::within, Varies::twoValues}) {
    const Trend trend{corners(12, varies, 3, chance)};
    CAPTURE(int(varies));
    CHECK(trend.pValue() < 1e-3);
    CHECK(computeFamilyWiseChances({trend}, 199, 1).front() < 0.01);
    CHECK(trend.chanceShare() < 0.15);
  }
}

TEST_CASE("a single pose with a driver of its own is no trend") {
  // Proves that one exceptional pose, such as a late or warm one, gives no trend, and that five poses are not enough.
  Chance chance{6};
  std::vector<TrendSample> samples;
  for (std::size_t pose = 0; pose < 20; ++pose) {
    samples.push_back({pose, pose == 19 ? 1.0 : 0.0, (pose == 19 ? 50 : 0) + chance(), 1});
  }
  CHECK_FALSE(Trend{samples}.isTestable());
  CHECK(Trend{samples}.pValue() == 1);
  samples.resize(5);
  for (TrendSample& sample : samples) {
    sample.x = double(sample.block);
  }
  CHECK_FALSE(Trend{samples}.isTestable());
}

TEST_CASE("a trend's curve goes through what it was made of") {
  // Proves that curve and mean reproduce the values, for unequal weights and exponentially spaced x.
  std::vector<TrendSample> samples;
  for (std::size_t pose = 0; pose < 40; ++pose) {
    const double x = std::exp(0.3 * double(pose));
    samples.push_back({pose, x, 2 + 0.1 * double(pose), pose % 2 ? 1.0 : 3.0});
  }
  const Trend trend{samples};
  const std::vector<double> curve = trend.curve();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    CHECK(curve[i] + trend.mean() == Approx(samples[i].y).margin(0.03));
  }
}
