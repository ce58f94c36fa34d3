#include "MeasuredArm.hpp"
#include "TemporaryFolder.hpp"

#include "data/CaptureSetFile.hpp"
#include "inspection/CaptureSetCheck.hpp"
#include "io/Files.hpp"
#include "io/GreyImage.hpp"
#include "io/InputError.hpp"
#include "simulation/Simulation.hpp"
#include "simulation/SimulationPlan.hpp"
#include "simulation/StandingPoses.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <nlohmann/json.hpp>

using namespace naocal;
using nlohmann::json;

namespace {

/// A simulated set of five poses, two samples each, with corners.
const json& simulatedSet() {
  static const json set = [] {
    const Robot robot = loadRobot(configurationDirectory(), "V6");
    SimulationPlan plan;
    plan.samples = 2;
    plan.poses = planStandingPoses(robot, plan, SupportFoot::left, 5, 1);
    return json::parse(formatCaptureSet(simulate(robot, plan, 1).set));
  }();
  return set;
}

CaptureSetCheck checkOf(const json& set, const TemporaryFolder& folder) {
  writeAtomically(folder.path() / "captures.json", set.dump());
  return checkCaptureSet(folder.path());
}

CaptureSetCheck checkOf(const json& set) {
  return checkOf(set, TemporaryFolder{});
}

std::size_t count(const CaptureSetCheck& check, const std::string& kind) {
  return std::size_t(std::count_if(check.problems.begin(), check.problems.end(),
                                   [&](const SetProblem& problem) { return problem.kind == kind; }));
}

std::string sentences(const CaptureSetCheck& check) {
  std::string all;
  for (const SetProblem& problem : check.problems) {
    all += problem.kind + ": " + problem.sentence + "\n";
  }
  return all;
}

} // namespace

TEST_CASE("a sound set has no problems") {
  // Proves for a simulated set that nothing is reported; other sound sets are checked by the scripts of tests/tools.
  const CaptureSetCheck check = checkOf(simulatedSet());
  INFO(sentences(check));
  CHECK(check.problems.empty());
  CHECK(check.poses == 5);
  CHECK(check.captures == simulatedSet()["captures"].size());
}

TEST_CASE("every kind of problem is found by itself, with place and remedy") {
  // Proves for one modification per kind: exactly that kind is reported, as often as it was made, and its sentence
  // names the place.
  struct Case {
    const char* kind;
    std::size_t times;
    const char* part; // of the sentence
    std::function<void(json&)> change;
  };
  const std::size_t knee = [] {
    const auto& names = simulatedSet()["jointNames"];
    return std::size_t(std::find(names.begin(), names.end(), "LKneePitch") - names.begin());
  }();
  const std::vector<Case> cases{
      {"unknown-key", 1, "if \"temperature\" is meant",
       [](json& set) {
         json& joints = set["captures"][3]["joints"];
         joints["temprature"] = joints["temperature"];
         joints.erase("temperature");
       }},
      {"unknown-key", 2, "captures[1]", [](json& set) { set["note"] = set["captures"][1]["weather"] = "rain"; }},
      {"refused", 1, "captures[2].joints.measured[",
       [&](json& set) { set["captures"][2]["joints"]["measured"][knee] = "NaN"; }},
      {"refused", 1, "found \"tip\"", [](json& set) { set["captures"][0]["camera"] = "tip"; }},
      {"beyond-limits", 1, "LKneePitch of 2.900 rad",
       [&](json& set) { set["captures"][0]["joints"]["measured"][knee] = 2.9; }},
      {"unknown-camera", 1, "cameras.side", [](json& set) { set["cameras"]["side"] = set["cameras"]["top"]; }},
      {"focal-length", 1, "cameras.top", [](json& set) { set["cameras"]["top"]["fx"] = 60; }},
      {"principal-point", 1, "cameras.top", [](json& set) { set["cameras"]["top"]["cx"] = 900; }},
      {"time-order", 1, "captures[4]", [](json& set) { set["captures"][4]["time"] = 0.001; }},
      {"outside-picture", 1, "captures[0]",
       [](json& set) {
         set["captures"][0]["corners"][0]["uv"][0] = {-15, 20};
       }},
      {"corners-at-one-point", 1, "captures[0] (capture 0).corners: all ",
       [](json& set) {
         for (json& uv : set["captures"][0]["corners"][0]["uv"]) {
           uv = {320.2, 240};
         }
       }},
      {"corners-at-one-point", 1, "as a detector that found nothing",
       [](json& set) {
         for (json& uv : set["captures"][0]["corners"][0]["uv"]) {
           uv = {0, 0};
         }
       }},
      {"failed-corners", 1, "1 of ",
       [](json& set) {
         set["captures"][0]["corners"][0]["uv"][2] = {0, 0};
       }},
      {"unseen-board", 1, "board E",
       [](json& set) {
         set["boards"].push_back(set["boards"][0]);
         set["boards"].back()["id"] = "E";
         set["boards"].back()["firstMarkerId"] = 70;
       }},
      {"unused-stance", 1, "stance 77",
       [](json& set) {
         set["stances"].push_back({{"id", 77}, {"supportFoot", "left"}});
       }},
      {"still-joints", 1, "1 joint never moved: LKneePitch;",
       [&](json& set) {
         for (json& capture : set["captures"]) {
           capture["joints"]["measured"][knee] = 0.9;
         }
       }},
      {"missing-picture", 1, "images/none.png", [](json& set) { set["captures"][0]["image"] = "images/none.png"; }},
      {"not-usable", 1, "was not recorded",
       [&](json& set) {
         for (const char* list : {"measured", "commanded", "velocity", "approach", "temperature", "current"}) {
           set["captures"][0]["joints"][list][knee] = nullptr;
         }
       }},
      {"unknown-robot", 1, "robot.model", [](json& set) { set["robot"]["model"] = "V9"; }},
  };
  for (const Case& each : cases) {
    json set = simulatedSet();
    each.change(set);
    const CaptureSetCheck check = checkOf(set);
    INFO(each.kind << "\n" << sentences(check));
    CHECK(count(check, each.kind) == each.times);
    CHECK(check.problems.size() == each.times);
    CHECK(sentences(check).find(each.part) != std::string::npos);
  }
}

TEST_CASE("degrees are suspected once, before all that follows from them") {
  // Proves: of a set in degrees the first problem is the unit, and no joint is said to be beyond its limits.
  json set = simulatedSet();
  for (json& capture : set["captures"]) {
    for (json& angle : capture["joints"]["measured"]) {
      angle = 57.29578 * angle.get<double>();
    }
  }
  const CaptureSetCheck check = checkOf(set);
  REQUIRE_FALSE(check.problems.empty());
  CHECK(check.problems.front().kind == "degrees");
  CHECK(count(check, "degrees") == 1);
  CHECK(count(check, "beyond-limits") == 0);
}

TEST_CASE("pictures are compared with their camera") {
  // Proves: a picture of another size and a broken one are each reported for their capture; a fitting one is not.
  const TemporaryFolder folder;
  json set = simulatedSet();
  const auto picture = [](int width, int height) {
    return GreyPicture{width, height, std::vector<std::uint8_t>(std::size_t(width) * std::size_t(height), 128)};
  };
  writeImage(picture(640, 480), folder.path() / "right.png");
  writeImage(picture(320, 240), folder.path() / "small.png");
  writeAtomically(folder.path() / "broken.png", "no picture");
  set["captures"][0]["image"] = "right.png";
  set["captures"][1]["image"] = "small.png";
  set["captures"][2]["image"] = "broken.png";
  const CaptureSetCheck check = checkOf(set, folder);
  INFO(sentences(check));
  CHECK(check.problems.size() == 2);
  CHECK(count(check, "picture-size") == 1);
  CHECK(count(check, "broken-picture") == 1);
  CHECK(sentences(check).find("320 × 240") != std::string::npos);
}

TEST_CASE("few poses, and poses without repeats, are reported") {
  // Proves: three single captures are too few, and prove no noise.
  json set = simulatedSet(), captures = json::array();
  for (const json& capture : set["captures"]) {
    if (capture["camera"] == "top" && capture["repeat"] == 0 && captures.size() < 3) {
      captures.push_back(capture);
    }
  }
  set["captures"] = captures;
  const CaptureSetCheck check = checkOf(set);
  INFO(sentences(check));
  CHECK(count(check, "few-poses") == 1);
  CHECK(count(check, "no-repeats") == 1);
}

TEST_CASE("problems are sorted by severity, and what is no capture set is refused") {
  // Proves the order for a set with one problem of each severity; and that text which is no set throws.
  json set = simulatedSet();
  set["note"] = 1;
  set["captures"][4]["time"] = 0.001;
  set["captures"][0]["camera"] = "tip";
  const CaptureSetCheck check = checkOf(set);
  REQUIRE(check.problems.size() == 3);
  CHECK(check.problems[0].severity == Severity::refused);
  CHECK(check.problems[1].severity == Severity::doubtful);
  CHECK(check.problems[2].severity == Severity::remark);
  CHECK_THROWS_AS(checkOf(json{{"format", "naocal-result"}, {"version", 1}}), InputError);
  CHECK_THROWS_AS(checkCaptureSet("no-such-folder"), InputError);
}

TEST_CASE("what a calibration takes for granted about a set is told before it") {
  // Proves it for readings of a tracker that are none, with their captures, and for directions of approach that the
  // order of captures tells; both are said once.
  const TemporaryFolder folder;
  writeArmSet(folder.path(), {.frames = false, .contacts = false});
  json set = json::parse(readFile(folder.path() / "captures.json"));
  set["captures"][4]["points"][0]["xyz"] = set["captures"][9]["points"][0]["xyz"] = {0, 0, 0};
  const CaptureSetCheck check = checkOf(set, folder);
  INFO(sentences(check));
  CHECK(count(check, "no-reading") == 1);
  CHECK(count(check, "approach-from-order") == 1);
  CHECK(
      sentences(check).find("2 of 30 readings of ball by laser are exactly 0, 0, 0: taken as no reading and left out: "
                            "captures 4, 9") != std::string::npos);
}
