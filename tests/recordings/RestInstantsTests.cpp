#include "recordings/RestInstants.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace naocal;
using std::chrono::milliseconds;

namespace {

/// A joint that stands for two seconds at each angle and moves between them within one; 100 readings a second.
JointSeries stops(const std::vector<double>& angles, double encoderStep = 0) {
  JointSeries series;
  for (int i = 0; i < static_cast<int>(angles.size()) * 300; ++i) {
    const double time = i * 0.01, phase = std::fmod(time, 3.0);
    const auto stop = static_cast<std::size_t>(time / 3);
    const double next = angles[std::min(stop + 1, angles.size() - 1)];
    const double angle = angles[stop] + (next - angles[stop]) * std::max(0.0, phase - 2);
    series.emplace_back(milliseconds{10 * i}, angle + (i % 2) * encoderStep);
  }
  return series;
}

std::vector<std::chrono::nanoseconds> picturesEvery(milliseconds period, int count) {
  std::vector<std::chrono::nanoseconds> times;
  for (int i = 0; i < count; ++i) {
    times.emplace_back(i * period);
  }
  return times;
}

} // namespace

TEST_CASE("one picture stands for each rest of all joints, and equal rests are repeats of a pose") {
  // Proves the middle picture, angles as the mean of readings, and that a return is found.
  const std::map<std::string, JointSeries> joints{{"a", stops({0.1, 0.5, 0.1}, 0.0015)}, {"b", stops({1, 1, 1})}};
  const auto rests = findRestInstants(joints, picturesEvery(milliseconds{100}, 90), {});
  REQUIRE(rests.size() == 3);
  CHECK(rests[0].angles.at("a") == Approx(0.10075).margin(2e-5));
  CHECK(rests[1].angles.at("a") == Approx(0.50075).margin(2e-5));
  CHECK(rests[1].angles.at("b") == 1);
  for (std::size_t i = 0; i < 2; ++i) { // the third ends without a motion
    CHECK(std::abs(static_cast<double>(rests[i].picture) - (30.0 * static_cast<double>(i) + 10)) <= 2);
  }
  CHECK(rests[0].pose == 0);
  CHECK(rests[1].pose == 1);
  CHECK(rests[2].pose == 0);
  CHECK(rests[2].repeat == 1);
}

TEST_CASE("pictures without readings around them, or during a motion, are no rests") {
  const std::map<std::string, JointSeries> joints{{"a", stops({0.1, 0.5})}};
  CHECK(findRestInstants(joints, {milliseconds{100}}, {}).empty());    // no reading 0.25 s before
  CHECK(findRestInstants(joints, {milliseconds{2500}}, {}).empty());   // moves
  CHECK(findRestInstants(joints, {milliseconds{60'000}}, {}).empty()); // after the last reading
  CHECK(findRestInstants(joints, {milliseconds{1000}}, {}).size() == 1);
  CHECK(findRestInstants({{"a", stops({0.1}, 0.01)}}, {milliseconds{1000}}, {}).empty()); // trembles
}

TEST_CASE("a joint that creeps is not one rest for ever") {
  // Proves the division of a slow motion, each window of which would count as a rest.
  JointSeries series;
  for (int i = 0; i < 6000; ++i) {
    series.emplace_back(milliseconds{10 * i}, i * 1e-5); // 0.001 rad/s
  }
  const auto rests = findRestInstants({{"a", series}}, picturesEvery(milliseconds{500}, 100), {});
  CHECK(rests.size() > 8);
}
