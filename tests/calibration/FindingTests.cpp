#include "MeasuredArm.hpp"
#include "TemporaryFolder.hpp"

#include "calibration/result/Finding.hpp"
#include "data/CaptureSetFile.hpp"
#include "robot/RobotOfSet.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

/// An arm with the joints lift, slide, wrist and roll.
Measurements measuredArm() {
  const TemporaryFolder folder;
  writeArmSet(folder.path(), {});
  const CaptureSet set = readCaptureSet(folder.path()).set;
  return buildMeasurements({set}, loadRobot(set));
}

Finding finding(const std::string& id, FindingLevel level, const std::string& why) {
  return {.id = id, .level = level, .why = why, .sentence = formatSentence(why, measuredArm())};
}

} // namespace

TEST_CASE("a label names its joints") {
  // Proves where a finding belongs, for effects, their unknowns, mistakes of the set-up with several joints, and
  // curves.
  const Measurements measurements = measuredArm();
  const std::string first = measurements.robot.joints[0].name, second = measurements.robot.joints[1].name;
  using Names = std::vector<std::string>;
  CHECK(placeOf("elasticity@" + first, measurements).joints == Names{first});
  CHECK(placeOf("elasticity@" + first + ".c", measurements).joints == Names{first});
  CHECK(placeOf("approach of " + first, measurements).joints == Names{first});
  CHECK(placeOf("swappedJoints@" + first + "," + second, measurements).joints == Names{first, second});
  CHECK(placeOf("otherLink@marker|" + second, measurements).joints == Names{second});
  CHECK(placeOf(second + " over q", measurements).joints == Names{second});
  CHECK(placeOf("misfit", measurements).joints.empty());
}

TEST_CASE("a clause becomes a sentence, and names keep their spelling") {
  const Measurements measurements = measuredArm();
  const std::string joint = measurements.robot.joints[0].name, marker = measurements.instruments.markers[0].name;
  CHECK(formatSentence("12 corners do not fit", measurements) == "12 corners do not fit.");
  CHECK(formatSentence("the search did not converge", measurements) == "The search did not converge.");
  CHECK(formatSentence(joint + "'s zero is far off", measurements) == joint + "'s zero is far off.");
  CHECK(formatSentence(marker + " sits elsewhere", measurements) == marker + " sits elsewhere.");
  CHECK(formatSentence("backlash@elbow is missing", measurements) == "backlash@elbow is missing.");
  CHECK(formatSentence("All is said.", measurements) == "All is said.");
}

TEST_CASE("findings stand in the order of their levels, and none is told twice") {
  using enum FindingLevel;
  std::vector<Finding> all{finding("weak:x", note, "x is hardly told"), finding("good", note, "all fits"),
                           finding("not-learned:y", stop, "y never moved"),
                           finding("unknown-effect:z", act, "z varies")};
  sortFindings(all);
  std::vector<std::string> ids;
  for (const Finding& one : all) {
    ids.push_back(one.id);
  }
  CHECK(ids == std::vector<std::string>{"not-learned:y", "unknown-effect:z", "weak:x", "good"});
  CHECK(reasonsAgainstUse(all) == std::vector<std::string>{"y never moved"});
  all.front().sentence = "Do not use this: y never moved, and z varies.";
  const std::vector<const Finding*> further = furtherFindings(all);
  REQUIRE(further.size() == 2);
  CHECK(further.front()->id == "weak:x");
  CHECK(furtherFindings({}).empty());
}

TEST_CASE("what holds whatever is missing outlives the verdict, with its own sentence") {
  using enum FindingLevel;
  std::vector<Finding> all{finding("not-learned:y", stop, "y never moved"),
                           finding("effect-missing:e@y", stop, "e@y is"),
                           finding("weak:task", note, "the bound is wide"), finding("negligible:f@y", note, "f@y is")};
  all[1].isVerdict = all[3].isVerdict = true;
  all.front().sentence = "Do not use this calibration: y never moved.";
  const std::vector<Finding> further = furtherThanVerdict(all, measuredArm());
  REQUIRE(further.size() == 2);
  CHECK(further[0].sentence == "Y never moved.");
  CHECK(further[1].id == "weak:task");
}

TEST_CASE("files hold findings by the names of the document") {
  Finding one = finding("set-up:reversedJoint@elbow", FindingLevel::stop, "elbow's angles have the wrong sign");
  one.where.joints = {"elbow"};
  one.numbers = {{"odds", 1e6}};
  one.answers = {{"mend", "setUp", "reversedJoint@elbow"}, {"take poses", "", ""}};
  const nlohmann::json expected = nlohmann::json::parse(R"([{
      "id": "set-up:reversedJoint@elbow", "level": "stop", "why": "elbow's angles have the wrong sign",
      "sentence": "Elbow's angles have the wrong sign.", "numbers": {"odds": 1000000.0}, "look": null,
      "where": {"poses": [], "joints": ["elbow"], "boards": [], "cameras": [], "captures": []},
      "answer": [{"do": "mend", "setUp": "reversedJoint@elbow"}, {"do": "take poses"}]}])");
  CHECK(toJson(std::vector{one}) == expected);
}

} // namespace naocal
