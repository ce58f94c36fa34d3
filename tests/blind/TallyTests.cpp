#include "blind/Bench.hpp"

#include <catch2/catch.hpp>

namespace blind {

TEST_CASE("a tally of controls counts alarms by regime with a band") {
  // Proves pooling and the exact 95 % interval: for 1 of 4 it is 0.6 to 80.6 %.
  Bench bench;
  for (int i = 0; i < 4; ++i) {
    bench.add(truthOf("s" + std::to_string(i), "control", json::array()),
              diagnosis(i == 0 ? "unknown-effect" : "adequate"));
  }
  const Tally counted = tallyCases(readCases(bench.path()));
  const Share& clean = counted.falseAlarms.at("clean");
  CHECK(clean.rate() == 0.25);
  CHECK(clean.low() == Approx(0.0063).margin(1e-3));
  CHECK(clean.high() == Approx(0.8059).margin(1e-3));
  CHECK(evaluationJson(counted).at("falseAlarms").at("clean").at("sets") == 4);
  CHECK_FALSE(requiredFigures(counted).front().met);
}

} // namespace blind
