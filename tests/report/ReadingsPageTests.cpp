#include "Browser.hpp"
#include "MeasuredArm.hpp"
#include "Result.hpp"

#include "diagnosis/Diagnosis.hpp"
#include "diagnosis/DiagnosisFile.hpp"
#include "math/Angles.hpp"
#include "robot/RobotOfSet.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace naocal;
using nlohmann::json;

namespace {

/// An arm's captures, solved with the base model, in a folder that stays.
struct SolvedArm {
  explicit SolvedArm(const ArmReadings& holds = {}) {
    writeArmSet(captures(), holds);
    sets = {readCaptureSet(captures()).set};
    measurements = buildMeasurements(sets, loadRobot(sets.front()));
    const Model model = buildModel(measurements);
    const CalibrationResult fit = calibrate(measurements, model);
    result = resultJson({measurements, model, fit},
                        {{captures().string()}, {sha256(readFile(captures() / "captures.json"))}});
  }

  std::filesystem::path captures() const { return folder.path() / "captures"; }
  std::string page(const json& document) const { return renderReport(document, folder.path() / "document.json"); }
  json data() const { return shown(page(result)); }
  json diagnosis() const { return diagnosisJson(diagnose(measurements)); }

  TemporaryFolder folder;
  std::vector<CaptureSet> sets;
  Measurements measurements;
  json result;
};

double lengthOf(const json& vector) {
  return std::hypot(vector[0].get<double>(), vector[1].get<double>(), vector[2].get<double>());
}

Eigen::Vector3d pointAt(const json& list) {
  return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

double rmsOf(const json& series) {
  double squares = 0;
  for (const json& point : series["points"]) {
    squares += std::pow(lengthOf(point["reported"]), 2);
  }
  return std::sqrt(squares / static_cast<double>(series["points"].size()));
}

/// All sentences and figures of a page's head, and titles and units of its plots.
std::string wordsOf(json data) {
  for (const char* list : {"candidates", "groups", "map", "curves"}) {
    data.erase(list);
  }
  return data.dump();
}

} // namespace

TEST_CASE("a result tells where every reading lies in the world and how far its prediction misses it") {
  // Proves that a tracker's readings, brought back into its frame by the placement in the result, are those of the
  // captures; that contacts lie at their places; and that the errors' rms are the result's own `metres`, `radians` and
  // `contacts`.
  const SolvedArm arm;
  const json& placement = arm.result["placements"]["trackers"]["laser"];
  const RigidTransform worldFromTracker =
      transformFromPlacement((Twist{} << placement["x"], placement["y"], placement["z"], placement["roll"],
                              placement["pitch"], placement["yaw"])
                                 .finished());
  const json captures = json::parse(readFile(arm.captures() / "captures.json"));
  REQUIRE(arm.result["readings"].size() == 30 * (2 + 1 + 1));
  double squares = 0, turns = 0, touches = 0;
  for (const json& reading : arm.result["readings"]) {
    const json& capture = captures["captures"][reading["capture"].get<std::size_t>()];
    const Eigen::Vector3d measured = pointAt(reading["measured"]), off = pointAt(reading["predicted"]) - measured;
    CHECK(reading["pose"] == capture["pose"]);
    if (reading["kind"] == "contact") {
      const json& place = captures["places"][reading["capture"].get<std::size_t>()];
      CHECK(reading["place"] == place["id"]);
      CHECK((measured - pointAt(place["point"])).norm() < 1e-6);
      touches += off.squaredNorm() / 30;
      continue;
    }
    const bool isFrame = reading["kind"] == "frame";
    bool found = false;
    for (const json& one : capture[isFrame ? "frames" : "points"]) {
      if (one[isFrame ? "frame" : "marker"] == reading["target"]) {
        found = (worldFromTracker.inverse() * measured - pointAt(one["xyz"])).norm() < 1e-6;
      }
    }
    CHECK(found);
    squares += off.squaredNorm() / 90;
    turns += isFrame ? pointAt(reading["turn"]["predicted"]).squaredNorm() / 30 : 0;
  }
  CHECK(std::sqrt(squares) == Approx(arm.result["metres"]["laser"]["rms"].get<double>()).epsilon(1e-3));
  CHECK(std::sqrt(turns) == Approx(arm.result["radians"]["laser"]["rms"].get<double>()).epsilon(1e-3));
  CHECK(std::sqrt(touches) == Approx(arm.result["contacts"]["rms"].get<double>()).epsilon(1e-3));
}

TEST_CASE("a report of trackers and contacts is in millimetres and degrees and says nothing of pixels") {
  // Proves the series of a set without pictures, that their errors are those of the result in display units, that the
  // key figures name every kind with its error before, and that a sliding joint is in millimetres.
  const SolvedArm arm;
  const json data = arm.data();
  CHECK(data["pictures"].empty());
  REQUIRE(data["readings"].size() == 3);
  const json &contacts = data["readings"][0], &positions = data["readings"][1], &attitudes = data["readings"][2];
  CHECK(contacts["title"] == "contacts");
  CHECK(positions["title"] == "positions of laser");
  CHECK(attitudes["title"] == "attitudes of laser");
  CHECK(positions["unit"] == "mm");
  CHECK(attitudes["unit"] == "°");
  CHECK(positions["sigma"].get<double>() == Approx(0.3));
  CHECK(attitudes["sigma"].get<double>() == Approx(degrees(0.0005)));
  CHECK(rmsOf(contacts) == Approx(1e3 * arm.result["contacts"]["rms"].get<double>()).epsilon(1e-3));
  CHECK(rmsOf(positions) == Approx(1e3 * arm.result["metres"]["laser"]["rms"].get<double>()).epsilon(1e-3));
  CHECK(rmsOf(attitudes) == Approx(degrees(arm.result["radians"]["laser"]["rms"].get<double>())).epsilon(1e-3));
  CHECK_THAT(wordsOf(data), !Catch::Contains("px") && !Catch::Contains("corner"));
  CHECK_THAT(data["facts"][0]["figure"].get<std::string>(), Catch::Contains("→") && Catch::Contains(" mm"));
  CHECK_THAT(data["facts"][1]["figure"].get<std::string>(), Catch::Contains("→") && Catch::Contains("°"));
  CHECK_THAT(data["facts"][2]["sentence"].get<std::string>(), Catch::Contains("places that markers touched"));
  CHECK(data["jointUnits"] == json{{"slide", "mm"}});
  const json& first = data["captures"][positions["points"][0]["of"].get<std::size_t>()];
  const double slide = arm.sets[0].captures[first["capture"].get<std::size_t>()].joints.measured[2];
  CHECK(first["angles"]["slide"].get<double>() == Approx(1000 * slide).margin(0.01));
}

TEST_CASE("a report of pictures and readings shows both, each in its unit") {
  // Proves that neither kind hides the other in the key figures and the plots.
  const SolvedArm arm{{.frames = false, .contacts = false, .corners = true}};
  const json data = arm.data();
  CHECK(data["pictures"].size() == 30);
  REQUIRE(data["readings"].size() == 1);
  CHECK_THAT(data["facts"][0]["figure"].get<std::string>(), Catch::Contains("px"));
  CHECK_THAT(data["facts"][1]["figure"].get<std::string>(), Catch::Contains("mm"));
  CHECK_THAT(data["facts"].back()["sentence"].get<std::string>(), Catch::Contains("positions of laser 0.3 mm (given)"));
}

TEST_CASE("a diagnosis of readings has errors in their own units on its page") {
  // Proves that keys of pixels are shown in the file's unit, that every kind has its own ladder with the errors that
  // the file gives, and that plots of pictures are absent.
  const SolvedArm arm{{.gain = 0.05}};
  const json file = arm.diagnosis(), data = shown(arm.page(file));
  const double perPx = file["errorUnit"]["perPx"];
  REQUIRE(file["steps"].size() > 1);
  CHECK(data["unit"] == "mm");
  CHECK(data["steps"][0]["rms"].get<double>() == Approx(perPx * file["steps"][0]["rmsPx"].get<double>()));
  CHECK(data["steps"][1]["heldOut"].get<double>() == Approx(perPx * file["steps"][1]["heldOutPx"].get<double>()));
  CHECK(data["candidates"][0]["errorUnit"] == "mm");
  CHECK(data["candidates"][0]["imprint"].is_null());
  CHECK_THAT(wordsOf(data), !Catch::Contains(" px"));
  REQUIRE(data["kinds"].size() == 3);
  CHECK(data["kinds"][0]["title"] == "positions of laser");
  CHECK(data["kinds"][0]["rungs"][0]["rms"].get<double>() ==
        Approx(1e3 * file["fitted"]["given"]["metres"]["laser"]["rms"].get<double>()));
  CHECK(data["kinds"][1]["rungs"][1]["rms"].get<double>() ==
        Approx(degrees(file["fitted"]["suggested"]["radians"]["laser"]["rms"].get<double>())));
  CHECK(data["left"]["asGiven"]["readings"].size() == 3);
  CHECK(data["left"]["withSuggested"]["readings"].size() == 3);
  for (const json& joint : data["left"]["asGiven"]["whatIf"]) {
    CHECK(joint["unit"] == (joint["joint"] == "slide" ? "mm" : "°"));
  }
}

TEST_CASE("a suspected set-up stands on the page without numbers that nobody computed") {
  // Proves that an entry without evidence is no reason to refuse the file, and that one with evidence needs the rest.
  const SolvedArm arm{{.frames = false, .contacts = false}};
  json file = arm.diagnosis();
  file["ranking"].insert(file["ranking"].begin(), json{{"effect", "reversedJoint"},
                                                       {"at", "lift"},
                                                       {"unknowns", json::object()},
                                                       {"state", "present"},
                                                       {"equivalent", json::array()},
                                                       {"why", "lift turns the other way"}});
  const json first = shown(arm.page(file))["candidates"][0];
  CHECK(first["setUp"] == true);
  CHECK(first["evidence"].is_null());
  file["ranking"][0]["evidence"] = 3;
  CHECK_THROWS_WITH(arm.page(file), Catch::Contains("ranking[0]") && Catch::Contains("power"));
}

TEST_CASE("a browser draws pages of readings without complaint, and no view of pictures", "[browser]") {
  // Proves that the scripts finish without console messages and which figures they draw. Their look is not tested.
  const SolvedArm arm;
  const auto result = drawnByBrowser(arm.page(arm.result));
  if (!result) {
    return;
  }
  // dots, arrows, three histograms, three groups, angle and time along three axes
  CHECK(occurrences(*result, "<canvas") == 1 + 1 + 3 + 3 + 3 + 3);
  CHECK(occurrences(*result, "CONSOLE") == 0);
  CHECK_THAT(*result, Catch::Contains("<section data-of=\"pictures\" hidden"));
  const auto diagnosis = drawnByBrowser(arm.page(arm.diagnosis()));
  CHECK_THAT(*diagnosis, Catch::Contains("Errors by kind of measurement</h2>") && Catch::Contains("Readings</h2>") &&
                             !Catch::Contains("Within the pictures</h2>") && !Catch::Contains("On the boards</h2>"));
  CHECK(occurrences(*diagnosis, "CONSOLE") == 0);
}
