#include "SimulatedSets.hpp"
#include "diagnose/Diagnosis.hpp"
#include "geometry/Angles.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>

namespace naocal {
namespace {

Diagnosis asked(const CaptureSet& set, const DiagnosisOptions& options = {}) {
  return diagnose({set}, measurementsOf({set}, loadRobot(configurationDirectory(), set.model)), options);
}

double& angle(const CaptureSet& set, Capture& capture, const std::string& joint) {
  const auto found = std::find(set.jointNames.begin(), set.jointNames.end(), joint);
  return capture.joints.measured[static_cast<std::size_t>(found - set.jointNames.begin())];
}

} // namespace

TEST_CASE("a bad capture is found although an effect hides more") {
  // Proves that accidents are looked for again once what was missing is in the model: the knee's gain is off by 4 %,
  // and one capture's head was elsewhere by 1.5 degrees.
  CaptureSet set = simulatedSet(16, 4);
  for (Capture& capture : set.captures) {
    angle(set, capture, "LKneePitch") *= 0.96;
  }
  Capture& bad = set.captures[set.captures.size() / 2];
  angle(set, bad, "HeadYaw") += radians(1.5);
  const Diagnosis diagnosis = asked(set);
  CAPTURE(diagnosis.sentence);
  CHECK(diagnosis.verdict == Verdict::badCaptures);
  CHECK(std::find(diagnosis.suggested.begin(), diagnosis.suggested.end(), "encoderGain@LKneePitch") !=
        diagnosis.suggested.end());
  REQUIRE(!diagnosis.suspicious.empty());
  CHECK(diagnosis.suspicious.front().capture == bad.id);
}

TEST_CASE("where the alarm stands but nothing is likely, a diagnosis does not call the model adequate") {
  // Proves that the best candidate is named instead, with the verdict inconclusive. (An alarm of 100 % always stands;
  // of few candidates rarely one is likely where nothing is hidden.)
  DiagnosisOptions options;
  options.alarm = 1;
  options.inquiry.map = false;
  std::erase_if(options.effects, [](const Effect& effect) {
    return !effect.base && effect.name != "soleTilt" && effect.name != "hysteresis";
  });
  int inconclusive = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Diagnosis diagnosis = asked(simulatedSet(12, seed), options);
    CHECK(diagnosis.verdict != Verdict::adequate);
    if (diagnosis.verdict == Verdict::inconclusive) {
      CHECK(diagnosis.sentence.find(diagnosis.ranking.front().term.label()) != std::string::npos);
      ++inconclusive;
    }
  }
  CHECK(inconclusive > 0);
}

} // namespace naocal
