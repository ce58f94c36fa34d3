#include "SetUpTwins.hpp"
#include "diagnosis/CheckedCalibration.hpp"
#include "estimation/ModelBuilder.hpp"
#include "setups/Mending.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <fmt/core.h>
#include <functional>
#include <map>

namespace naocal {
namespace {

/// What a calibration says of the set-up; empty: nothing is wrong.
std::vector<WrongSetUp> suspected(const Recording& recording) {
  try {
    const Measurements measurements = buildMeasurements(recording.sets, recording.robot);
    return calibrateChecked(measurements, buildModel(measurements)).setUps;
  } catch (const WrongSetUpError& error) {
    return error.setUps;
  } catch (const InputError&) {
    return {};
  }
}

std::vector<std::string> suspectedLabels(const Recording& recording) {
  return labelsOf(suspected(recording));
}

std::vector<Twin> makeTwins(const TemporaryFolder& folder, std::uint64_t seed) {
  return {armBeforeTracker(folder, seed), armByFrames(folder, seed), armWithCamera(folder, seed),
          naoBeforeBoards(seed)};
}

/// A physical effect of a plausible size, in the readings themselves.
void addGain(Recording& recording, const std::string& joint, double gain) {
  CaptureSet& set = recording.sets.front();
  for (Capture& capture : set.captures) {
    spoiling::reading(set, capture, joint) *= 1 + gain;
  }
}

} // namespace

TEST_CASE("every mistake of a set-up is named alone and first", "[slow]") {
  // Proves it for every kind on an arm before a tracker, an arm with a camera, and a NAO; [.rates] measures how often.
  const TemporaryFolder folder;
  for (const Twin& twin : makeTwins(folder, 3)) {
    for (const Spoiling& spoiling : drawSpoilings(twin, 3)) {
      Recording wrong = twin.right;
      spoiling.apply(wrong);
      const std::vector<WrongSetUp> found = suspected(wrong);
      CAPTURE(twin.name, spoiling.label, labelsOf(found));
      CHECK(labelsOf(found) == std::vector{spoiling.label});
    }
  }
}

TEST_CASE("sound captures are not suspected, with or without an effect", "[slow]") {
  // Proves it for robots that are right and for those with a gain of 1 % or a link that is 5 mm off.
  const TemporaryFolder folder;
  for (const std::uint64_t seed : {5, 6}) {
    for (const std::vector<std::string>& flaws :
         {std::vector<std::string>{}, {"linkGeometry@elbow"}, {"axisTilt@lift"}}) {
      CHECK(suspectedLabels(armBeforeTracker(folder, seed, flaws).right).empty());
      CHECK(suspectedLabels(armWithCamera(folder, seed, flaws).right).empty());
    }
    Recording nao = naoBeforeBoards(seed).right;
    addGain(nao, "LKneePitch", 0.01);
    CHECK(suspectedLabels(nao).empty());
  }
}

TEST_CASE("two mistakes together are both named", "[slow]") {
  // Proves that a mistake is found beside another that spoils the captures more.
  const TemporaryFolder folder;
  Recording wrong = armByFrames(folder, 3).right;
  spoiling::giveInDegrees("elbow").apply(wrong);
  spoiling::reorderQuaternions("laser").apply(wrong);
  std::vector<std::string> found = suspectedLabels(wrong);
  std::sort(found.begin(), found.end());
  CHECK(found == std::vector<std::string>{"columnUnit@elbow", "quaternionOrder@laser"});
}

TEST_CASE("several joints with the wrong sign are all named", "[slow]") {
  // Proves it where each of them alone leaves the error as large, so that other mistakes seem to explain part of it.
  const TemporaryFolder folder;
  for (const std::vector<std::string>& reversed :
       {std::vector<std::string>{"lift", "wrist2", "wrist3"}, {"elbow", "wrist1", "wrist3"}}) {
    Recording wrong = armBeforeTracker(folder, 3).right;
    for (const std::string& joint : reversed) {
      spoiling::reverse(joint).apply(wrong);
    }
    std::vector<std::string> found = suspectedLabels(wrong), expected;
    std::transform(reversed.begin(), reversed.end(), std::back_inserter(expected),
                   [](const std::string& joint) { return "reversedJoint@" + joint; });
    CHECK_THAT(found, Catch::UnorderedEquals(expected));
  }
}

TEST_CASE("a marker is found on a link nearer to the base and on one further out", "[slow]") {
  // Proves both directions, and a link that two joints divide from the one that the file names.
  const TemporaryFolder folder;
  for (const auto& [right, said] : {std::pair{"hand", "l5"}, std::pair{"l5", "hand"}, std::pair{"l4", "hand"}}) {
    Recording wrong = makeArmTwin(folder, "one",
                                  fmt::format(R"(
      "trackers": {{"vicon": {{"about": {{"x": 2, "y": 0.3, "z": 1}}}}}},
      "markers": [{{"id": "m", "link": "{}", "about": [0.1, 0.05, 0.02]}}])",
                                              right),
                                  {.seed = 8, .poses = 30})
                          .right;
    spoiling::nameOtherLink("m", said).apply(wrong);
    const std::vector<WrongSetUp> found = suspected(wrong);
    CAPTURE(right, said);
    REQUIRE(labelsOf(found) == std::vector<std::string>{"otherLink@m"});
    CHECK(found.front().why.starts_with(fmt::format("m sits on {}, not on {}", right, said)));
  }
}

TEST_CASE("all markers of a link are found on another as one mistake", "[slow]") {
  // Proves it for five markers, more than the mistakes that are looked for together, although the guesses of their
  // places belong to the wrong link; and that a joint is no place of a marker.
  const TemporaryFolder folder;
  std::string markers;
  for (const char* const id : {"a", "b", "c", "d", "e"}) {
    markers += fmt::format(R"({}{{"id": "{}", "link": "l5", "about": [0.1, {}, 0.02]}})", markers.empty() ? "" : ", ",
                           id, 0.02 * (id[0] - 'c'));
  }
  Recording wrong = makeArmTwin(folder, "tool", R"("trackers": {"vicon": {"about": {"x": 2, "y": 0.3, "z": 1}}},
    "markers": [)" + markers + "]",
                                {.seed = 8})
                        .right;
  for (const char* const id : {"a", "b", "c", "d", "e"}) {
    spoiling::nameOtherLink(id, "hand").apply(wrong);
  }
  CHECK(suspectedLabels(wrong) == std::vector<std::string>{"otherLink@hand"});
  std::vector<std::string> with{"otherLink@elbow"};
  CHECK_THROWS_WITH(mendSetUps(with, wrong.robot, wrong.sets), Catch::Contains("names no place of these captures"));
}

TEST_CASE("a gear of another ratio is an effect, not noise of the readings", "[slow]") {
  // Proves that a size far beyond plausible does not raise the level of readings whose noise nobody tells: the fit
  // without the effect leaves centimetres, that with it the tracker's noise.
  const TemporaryFolder folder;
  Recording wrong = armBeforeTracker(folder, 3).right;
  addGain(wrong, "wrist2", 0.2);
  const Measurements measurements = buildMeasurements(wrong.sets, wrong.robot);
  const CalibrationResult result = calibrateChecked(measurements, buildModel(measurements));
  REQUIRE(result.noise.readings.size() == 1);
  CAPTURE(result.sentence);
  CHECK(result.noise.readings.front() < 0.001);
  CHECK(result.sentence.find("encoderGain@wrist2") != std::string::npos);
}

TEST_CASE("a joint counted from another is named although only few rows show it", "[slow]") {
  // Proves that rows which lose their weight in a robust fit count: the lift moves in 8 of 40 poses only.
  const TemporaryFolder folder;
  Recording wrong = armBeforeTracker(folder, 4, {}, withStillLift(40, 8)).right;
  const double usual = spoiling::reading(wrong.sets.front(), wrong.sets.front().captures.front(), "lift");
  spoiling::countFrom("elbow", "lift", -1, usual).apply(wrong);
  CHECK(suspectedLabels(wrong) == std::vector<std::string>{"countedFrom@elbow,lift"});
}

TEST_CASE("captures with a mended set-up fit as if it had been right", "[slow]") {
  // Proves for every kind that --with its label finds the way in which it was made.
  const TemporaryFolder folder;
  for (const Twin& twin : makeTwins(folder, 7)) {
    for (const Spoiling& spoiling : drawSpoilings(twin, 7)) {
      Recording wrong = twin.right;
      spoiling.apply(wrong);
      std::vector<std::string> with{spoiling.label, "encoderGain@" + twin.right.sets.front().jointNames.front()};
      CAPTURE(twin.name, spoiling.label);
      CHECK(mendSetUps(with, wrong.robot, wrong.sets) == std::vector{spoiling.label});
      CHECK(with.size() == 1);
      CHECK(suspectedLabels(wrong).empty());
    }
  }
}

TEST_CASE("labels with commas survive a list that is split at commas") {
  // Proves that a piece belongs to the label before it only where that is a mistake of the set-up.
  using Labels = std::vector<std::string>;
  CHECK(joinLabels({"countedFrom@elbow", "lift", "elasticity@x"}) == Labels{"countedFrom@elbow,lift", "elasticity@x"});
  CHECK(joinLabels({"timeShift", "swappedJoints@a", "b", "timeShift"}) ==
        Labels{"timeShift", "swappedJoints@a,b", "timeShift"});
  CHECK(joinLabels({"elasticity@a", "b"}) == Labels{"elasticity@a", "b"});
}

TEST_CASE("how often mistakes are named, alone and beside an effect", "[.rates]") {
  // Measures; proves nothing.
  const TemporaryFolder folder;
  std::map<std::string, std::array<int, 4>> rates; // kind and robot: named alone, of; named beside an effect, of
  int sound = 0, suspectedSound = 0;
  for (std::uint64_t seed = 11; seed <= 16; ++seed) {
    for (const bool beside : {false, true}) {
      const std::vector<std::string> effects{"linkGeometry@wrist1", "axisTilt@elbow",    "encoderEccentricity@lift",
                                             "encoderGain@pan",     "linkGeometry@lift", "encoderGain@elbow"};
      const std::vector<std::string> flaws =
          beside ? std::vector{effects[seed % effects.size()]} : std::vector<std::string>{};
      std::vector<Twin> twins{armBeforeTracker(folder, seed, flaws), armByFrames(folder, seed, flaws),
                              armWithCamera(folder, seed, flaws), naoBeforeBoards(seed)};
      if (beside) {
        addGain(twins.back().right, "LHipPitch", 0.01);
      }
      for (const Twin& twin : twins) {
        const auto ofSound = suspectedLabels(twin.right);
        ++sound;
        suspectedSound += ofSound.empty() ? 0 : 1;
        if (!ofSound.empty()) {
          fmt::print("SOUND {} seed {} {} -> {}\n", twin.name, seed, beside, ofSound.front());
        }
        for (const Spoiling& spoiling : drawSpoilings(twin, seed)) {
          Recording wrong = twin.right;
          spoiling.apply(wrong);
          const auto found = suspectedLabels(wrong);
          const bool isFirst = !found.empty() && found.front() == spoiling.label;
          auto& rate = rates[spoiling.label.substr(0, spoiling.label.find('@')) + " " + twin.name];
          rate[beside ? 2 : 0] += isFirst ? 1 : 0;
          rate[beside ? 3 : 1] += 1;
          if (!isFirst) {
            fmt::print("MISSED {} seed {} {} {} -> {}\n", twin.name, seed, beside ? "beside" : "alone", spoiling.label,
                       found.empty() ? "nothing" : found.front());
          }
          std::fflush(stdout);
        }
      }
      std::array<int, 4> sums{};
      for (const auto& [name, rate] : rates) {
        std::transform(rate.begin(), rate.end(), sums.begin(), sums.begin(), std::plus<>{});
      }
      fmt::print("seed {}: alone {}/{}, beside {}/{}; sound suspected {}/{}\n", seed, sums[0], sums[1], sums[2],
                 sums[3], suspectedSound, sound);
      std::fflush(stdout);
    }
  }
  for (const auto& [name, rate] : rates) {
    fmt::print("{:<40} alone {}/{} beside {}/{}\n", name, rate[0], rate[1], rate[2], rate[3]);
  }
  fmt::print("sound: {} of {} suspected\n", suspectedSound, sound);
}

} // namespace naocal
