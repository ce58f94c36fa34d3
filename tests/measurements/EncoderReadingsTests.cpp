#include "measurements/EncoderReadings.hpp"

#include "math/Angles.hpp"
#include "measurements/Measurements.hpp"
#include "measurements/Noise.hpp"
#include "simulation/Simulation.hpp"
#include "simulation/StandingPoses.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>
#include <tuple>

namespace naocal {
namespace {

/// A joint resting at `place` [steps], read `count` times with a jitter of `jitter` [steps, 1 sigma].
RestReadings read(double place, double jitter, int count, std::mt19937_64& random) {
  std::normal_distribution<double> noise{0, jitter};
  std::vector<double> angles;
  for (int i = 0; i < count; ++i) {
    angles.push_back(encoderStep * std::round(place + noise(random)));
  }
  return RestReadings{angles, encoderStep};
}

} // namespace

TEST_CASE("readings at rest tell how much an encoder jitters, and where its joint stood") {
  // Proves the likelihood of rounded readings by Monte Carlo: for eight joints with 60 rests of six readings, levels of
  // 0.03 to 0.1 degrees are estimated within 20 %, and the posterior variance of a position equals its mean squared
  // error. Whether real encoders jitter like that is not tested.
  for (const double degreesOfJitter : {0.03, 0.05, 0.1}) {
    CAPTURE(degreesOfJitter);
    const double jitter = radians(degreesOfJitter) / encoderStep;
    std::mt19937_64 random{7};
    std::uniform_real_distribution<double> anywhere{-500, 500};
    std::vector<std::vector<RestReadings>> rests(8);
    std::vector<std::vector<double>> places(8);
    for (std::size_t joint = 0; joint < rests.size(); ++joint) {
      for (int rest = 0; rest < 60; ++rest) {
        places[joint].push_back(anywhere(random));
        rests[joint].push_back(read(places[joint].back(), jitter, 6, random));
      }
    }
    const std::vector<double> found = estimateEncoderJitter(rests);
    double errors = 0, variances = 0;
    for (std::size_t joint = 0; joint < rests.size(); ++joint) {
      CHECK(found[joint] == Approx(jitter * encoderStep).epsilon(0.2));
      for (std::size_t rest = 0; rest < rests[joint].size(); ++rest) {
        const RestReadings::Place place = rests[joint][rest].place(found[joint]);
        errors += std::pow(place.angle - encoderStep * places[joint][rest], 2);
        variances += place.variance;
      }
    }
    CHECK(errors == Approx(variances).epsilon(0.25)); // over 480 positions: 6 %, 1 sigma
  }
}

TEST_CASE("joints that were not recorded say nothing of encoders' jitter", "[slow]") {
  // Proves the level of a set that records only one leg's joints and the head, as most sets do: every pose is read
  // three times at rest, with a jitter of 0.015 degrees, in whole steps. Unrecorded arms must not count as encoders
  // without jitter.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan;
  plan.poses = planStandingPoses(robot, plan, SupportFoot::left, 24, 1);
  CaptureSet set = simulate(robot, plan, 3).set;
  const double level = radians(0.015);
  std::mt19937_64 random{7};
  std::normal_distribution<double> jitter{0, level / encoderStep};
  std::uniform_real_distribution<double> within{-0.5, 0.5};
  std::map<std::pair<std::string, std::size_t>, double> places; // of joints in their poses [steps]
  std::map<std::tuple<std::string, int, std::size_t>, double> readings;
  for (Capture& capture : set.captures) {
    for (std::size_t joint = 0; joint < set.jointNames.size(); ++joint) {
      double& angle = capture.joints.measured[joint];
      const double place =
          places.try_emplace({capture.pose, joint}, angle / encoderStep + within(random)).first->second;
      const double step = std::round(place + jitter(random)); // shared by both cameras' images
      const bool used =
          set.jointNames[joint].starts_with("L") && set.jointNames[joint].find("Shoulder") == std::string::npos;
      angle = encoderStep * readings.try_emplace({capture.pose, capture.repeat, joint}, step).first->second;
      angle = used || set.jointNames[joint].starts_with("Head") ? angle : std::nan("");
    }
  }
  const Measurements measurements = buildMeasurements({set}, robot);
  double squares = 0;
  for (const std::size_t joint : measurements.joints) {
    squares += std::pow(measurements.jitter[joint], 2);
  }
  CHECK(std::sqrt(squares / static_cast<double>(measurements.joints.size())) == Approx(level).epsilon(0.2));
}

TEST_CASE("thousands of readings in one rest are read as few are") {
  // Proves that the likelihood of many readings does not vanish: the place between two steps is found to a few standard
  // errors, and the level of the jitter within 5 %, from 20 to 5000 readings.
  std::mt19937_64 random{3};
  constexpr double jitter = 0.6, place = 100.5; // [steps]
  for (const int count : {20, 600, 5000}) {
    CAPTURE(count);
    const RestReadings rest = read(place, jitter, count, random);
    const RestReadings::Place found = rest.place(jitter * encoderStep);
    const double sigma = std::sqrt(found.variance) / encoderStep;
    CHECK(found.angle / encoderStep == Approx(place).margin(4 * sigma));
    CHECK(sigma == Approx(std::sqrt((jitter * jitter + 1. / 12) / count)).epsilon(0.3));
    if (count > 500) {
      CHECK(estimateEncoderJitter({{rest}}).front() / encoderStep == Approx(jitter).epsilon(0.05));
    }
  }
}

TEST_CASE("readings that never differ leave the whole step open") {
  // Proves the limit without jitter: variance LSB^2 / 12.
  const RestReadings rest{{0.3, 0.3, 0.3}, encoderStep};
  CHECK_FALSE(rest.differ());
  CHECK(estimateEncoderJitter({{rest, rest}}) == std::vector<double>{0.0});
  const RestReadings::Place place = rest.place(0);
  CHECK(place.angle == Approx(0.3));
  CHECK(std::sqrt(place.variance) == Approx(encoderStep / std::sqrt(12.0)).epsilon(0.05)); // numerical integration
}

TEST_CASE("an encoder's readings are counted in its own steps") {
  // Proves it for one of 14 bits, whose steps a NAO's encoder would not tell apart.
  const double fine = encoderStep / 4;
  const RestReadings rest{{0.3, 0.3 + fine, 0.3 + fine}, fine};
  CHECK(rest.differ());
  CHECK_FALSE(RestReadings{{0.3, 0.3 + fine, 0.3 + fine}, encoderStep}.differ());
  const RestReadings::Place place = rest.place(0.5 * fine);
  CHECK(place.angle > 0.3);
  CHECK(place.angle < 0.3 + fine);
  CHECK(std::sqrt(place.variance) < fine);
}

TEST_CASE("readings between two of an encoder's steps give a rest one place") {
  // Proves it for recordings whose images lie between alternating readings: fractions of a step are not jitter, and all
  // images of the rest have the same angle.
  const RestReadings rest{{265.58 * encoderStep, 266 * encoderStep}, encoderStep};
  CHECK_FALSE(rest.differ());
  CHECK(rest.place(0).angle == Approx(265.79 * encoderStep));
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan;
  plan.poses = planStandingPoses(robot, plan, SupportFoot::left, 4, 1);
  CaptureSet set = simulate(robot, plan, 3).set;
  double part = 0; // of a step
  for (Capture& capture : set.captures) {
    const auto head = std::find(set.jointNames.begin(), set.jointNames.end(), "HeadYaw") - set.jointNames.begin();
    const auto& first = *std::find_if(set.captures.begin(), set.captures.end(),
                                      [&](const Capture& one) { return one.pose == capture.pose; });
    capture.joints.measured = first.joints.measured;
    part = part > 0.2 ? 0 : part + 0.1;
    capture.joints.measured[static_cast<std::size_t>(head)] += part * encoderStep;
  }
  const Measurements measurements = buildMeasurements({set}, robot);
  for (const PoseGroup& pose : measurements.poses) {
    CHECK(pose.readings.size() > 1);
    std::set<double> places;
    for (const EncoderSample& reading : pose.readings) {
      places.insert(measurements.pictures[reading.pictures.front()].instant.q[0]);
    }
    CHECK(places.size() == 1);
  }
}

TEST_CASE("readings that lie too far apart for their joint's jitter still have a place") {
  // Proves that position and variance are finite, and that the position is between the readings, for readings that
  // rounding and jitter cannot explain: with a jitter of 0.01 steps, two steps apart have a likelihood of zero in
  // double precision.
  const RestReadings rest{{0, 2 * encoderStep}, encoderStep};
  const RestReadings::Place place = rest.place(0.01 * encoderStep);
  CHECK(place.angle == Approx(encoderStep).epsilon(0.05));
  CHECK(place.variance > 0);
  CHECK(place.variance < encoderStep * encoderStep);
}

} // namespace naocal
