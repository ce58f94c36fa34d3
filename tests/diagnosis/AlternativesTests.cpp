#include "Questioned.hpp"
#include "diagnosis/Diagnosis.hpp"
#include "diagnosis/evidence/Aliasing.hpp"

#include <catch2/catch.hpp>

namespace naocal {

TEST_CASE("evident effects that do different things to the pictures are never each other's alternatives", "[slow]") {
  // Proves that two effects that are both present, with similar evidence, are not reported as equivalent unless their
  // signatures correlate: gains of head and knee are both off by 3 %.
  CaptureSet set = simulatedSet(16, 4);
  const auto scaled = [&](const char* joint, double factor) {
    const auto found = std::find(set.jointNames.begin(), set.jointNames.end(), joint) - set.jointNames.begin();
    for (Capture& capture : set.captures) {
      capture.joints.measured[static_cast<std::size_t>(found)] *= factor;
    }
  };
  scaled("HeadYaw", 0.97);
  scaled("LKneePitch", 0.97);
  const Questioned asked{set, false};
  const auto head = asked.candidateTests.findCandidate("encoderGain@HeadYaw"),
             knee = asked.candidateTests.findCandidate("encoderGain@LKneePitch");
  REQUIRE((head && knee));
  int compared = 0;
  for (std::size_t i = 0; i < asked.candidateTests.candidates().size(); ++i) {
    constexpr double evident = 10;
    for (const std::size_t other : findEquivalents(asked.candidateTests, i)) {
      if (asked.candidateTests.candidateEvidence(other).bayes > evident) {
        CAPTURE(asked.candidateTests.candidates()[i].label(), asked.candidateTests.candidates()[other].label());
        const std::vector<ColumnGroup>& groups = asked.candidateTests.problem().groups;
        CHECK(canonicalCorrelation(asked.candidateTests.evidence().information, groups[i], groups[other]) >= 0.5);
        ++compared;
      }
    }
  }
  CHECK(compared > 0);
}

TEST_CASE("play that load never holds cannot be told from hysteresis, and is told from it where load does", "[slow]") {
  // Proves that an effect with a threshold is compared with its limiting cases by fits: the head's torque never exceeds
  // friction, the knee's nearly always does.
  const std::string joint = GENERATE("HeadPitch", "LKneePitch");
  const bool alike = joint == "HeadPitch";
  CaptureSet set = simulatedSet(16, 4);
  const auto place = std::find(set.jointNames.begin(), set.jointNames.end(), joint) - set.jointNames.begin();
  constexpr double gap = 0.006; // [rad]
  for (Capture& capture : set.captures) {
    capture.joints.measured[static_cast<std::size_t>(place)] +=
        gap / 2 * capture.joints.approach[static_cast<std::size_t>(place)];
  }
  const Diagnosis diagnosis = diagnose(buildMeasurements({set}, loadRobot(configurationDirectory(), set.model)));
  CAPTURE(diagnosis.sentence);
  const auto found =
      std::find_if(diagnosis.ranking.begin(), diagnosis.ranking.end(),
                   [&](const CandidateFinding& finding) { return finding.term.label() == "hysteresis@" + joint; });
  REQUIRE(found != diagnosis.ranking.end());
  CHECK(found->state == CandidateState::present);
  const std::string play = "gearPlay@" + joint;
  CHECK((std::find(found->equivalent.begin(), found->equivalent.end(), play) != found->equivalent.end()) == alike);
}

} // namespace naocal
