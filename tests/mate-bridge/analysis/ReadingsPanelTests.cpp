#include "MeasuredArm.hpp"
#include "TemporaryFolder.hpp"
#include "analysis/AnalysisSession.hpp"
#include "data/CaptureSetFile.hpp"
#include "io/Files.hpp"
#include "math/Angles.hpp"
#include "robot/RobotOfSet.hpp"
#include "scenes/SceneNextPoses.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

using namespace naocal;
using Json = nlohmann::json;

namespace {

/// A session about an arm that a tracker and contacts measured, whose gain the base model lacks.
struct ArmBench {
  ArmBench() { writeArmSet(folder.path() / "arm", {.gain = 0.05}); }

  TemporaryFolder folder;
  std::map<std::string, Json> told;
  AnalysisSession::MessageSink sink = [this](const std::string& kind, const Json& content) { told[kind] = content; };
};

} // namespace

TEST_CASE("the panel is told the errors of readings in their own units, with the captures that they belong to") {
  // Proves the fit's message of a set without pictures: series in display units, an index of each capture in the
  // drivers' values, the ladder in the same unit as the diagnosis, and sentences without pixels. Numbers are tested
  // with the report.
  ArmBench bench;
  AnalysisSession session{openDataset({(bench.folder.path() / "arm").string()}), bench.sink};
  CHECK(bench.told["set"]["isNao"] == false);
  CHECK(bench.told["set"]["readings"] == 30 * (2 + 1 + 1));
  session.fit();
  const Json& fit = bench.told["fit"];
  CHECK(fit["pictures"].empty());
  REQUIRE(fit["readings"].size() == 3);
  CHECK(fit["readings"][1]["title"] == "positions of laser");
  REQUIRE(fit["captures"].size() == 30 * (2 + 1 + 1));
  const Json captures = Json::parse(readFile(bench.folder.path() / "arm/captures.json"))["captures"];
  for (const Json& driver : fit["drivers"]) {
    CHECK(driver["values"].size() == 30);
    const bool isTurn = driver["what"] == "the angle of turn", isSlide = driver["what"] == "the position of slide";
    for (const Json& capture : fit["captures"]) { // less what the fit takes for their zeros
      const double value = driver["values"][capture["index"].get<std::size_t>()];
      const Json& read = captures[capture["capture"].get<std::size_t>()]["joints"]["measured"];
      if (isTurn) {
        CHECK(value == Approx(degrees(read[0].get<double>())).margin(5));
      }
      if (isSlide) {
        CHECK(value == Approx(1e3 * read[2].get<double>()).margin(15));
      }
    }
    CHECK(driver["unit"] == (isSlide ? "mm" : isTurn ? "°" : driver["unit"]));
  }
  for (const Json& sentence : fit["facts"]) {
    CHECK_THAT(sentence.dump(), !Catch::Contains("px"));
  }
  CHECK(bench.told["ladder"]["unit"] == "mm");
  CHECK(bench.told["ladder"]["rungs"][0]["rms"] == fit["rms"]);

  session.search();
  const Json &diagnosis = bench.told["diagnosis"], &rung = bench.told["ladder"]["rungs"][0];
  CHECK(diagnosis["unit"] == "mm");
  CHECK(rung["rms"].get<double>() == Approx(diagnosis["steps"][0]["rms"].get<double>()));
  CHECK(rung["heldOut"].get<double>() == Approx(diagnosis["steps"][0]["heldOut"].get<double>()));
  CHECK(diagnosis["candidates"][0]["label"] == "encoderGain@lift");
}

TEST_CASE("a joint's gain is shown as its error over its own angle, before and after") {
  // Proves that the first cause is of the right joint, in its units, that its own part is proportional to the angle,
  // and that it accounts for most of the error.
  ArmBench bench;
  AnalysisSession session{openDataset({(bench.folder.path() / "arm").string()}), bench.sink};
  session.fit();
  session.search();
  const Json& causes = bench.told["diagnosis"]["causes"];
  REQUIRE_FALSE(causes.empty());
  const Json& cause = causes[0];
  CHECK(cause["label"] == "encoderGain@lift");
  CHECK(cause["error"] == "lift");
  CHECK(cause["over"] == "the angle of lift");
  CHECK(cause["unit"] == "°");
  CHECK(cause["overUnit"] == "°");
  double before = 0, after = 0;
  const Json &first = cause["points"][0], &last = cause["points"].back();
  const double gain = (last["own"].get<double>() - first["own"].get<double>()) /
                      (last["over"].get<double>() - first["over"].get<double>());
  for (const Json& point : cause["points"]) {
    const double own = point["own"], left = point["left"], over = point["over"];
    CHECK(own - first["own"].get<double>() == Approx(gain * (over - first["over"].get<double>())).margin(1e-3));
    before += (own + left) * (own + left);
    after += left * left;
  }
  CHECK(after < 0.1 * before);
}

TEST_CASE("a comparison with other readings has a line for every kind") {
  // Proves titles, units and that the drawing alone is worse; the errors are those of `naocal compare`.
  ArmBench bench;
  writeArmSet(bench.folder.path() / "other", {.contacts = false, .gain = 0.05});
  AnalysisSession session{openDataset({(bench.folder.path() / "arm").string()}), bench.sink};
  session.fit();
  session.compareWith(openDataset({(bench.folder.path() / "other").string()}));
  const Json& kinds = bench.told["compared"]["kinds"];
  REQUIRE(kinds.size() == 2);
  CHECK(kinds[0]["title"] == "positions of laser");
  CHECK(kinds[0]["unit"] == "mm");
  CHECK(kinds[0]["count"] == 90);
  CHECK(kinds[0]["rms"].get<double>() == Approx(1e3 * bench.told["compared"]["metres"]["laser"]["rms"].get<double>()));
  CHECK(kinds[0]["nominal"].get<double>() > 1.2 * kinds[0]["rms"].get<double>());
  CHECK(kinds[1]["unit"] == "°");
}

TEST_CASE("poses are proposed for an arm, as the command line proposes them", "[slow]") {
  // Proves that the panel is told the poses of proposeSceneNextPoses, their angles in the joints' display units, and
  // what to do with them; and that the file holds them.
  ArmBench bench;
  AnalysisSession session{openDataset({(bench.folder.path() / "arm").string()}), bench.sink};
  session.fit();
  session.proposePoses(2);
  const Json& next = bench.told["next"];
  CAPTURE(next.dump(2));
  REQUIRE(next["poses"].size() == 2);
  CHECK(next["whyNone"] == "");
  CHECK(next["howToTake"] == "Leave everything where it stands, record the poses as a new set with \"stance\": 0");
  const CaptureSet set = readCaptureSet(bench.folder.path() / "arm").set;
  const Measurements measurements = buildMeasurements({set}, loadRobot(set));
  const NextPoses expected = proposeSceneNextPoses(measurements, diagnose(measurements), {}, {.count = 2});
  for (std::size_t i = 0; i < 2; ++i) {
    const Json& pose = next["poses"][i];
    CHECK(pose["observes"] == Json{"ball", "tip", "tool"});
    REQUIRE(pose["angles"].size() == 4);
    for (std::size_t joint = 0; joint < 4; ++joint) {
      const Json& angle = pose["angles"][joint];
      const double exact = expected.poses.at(i).pose.angles[Eigen::Index(joint)];
      const bool isSlide = angle["joint"] == "slide";
      CHECK(pose["joints"][angle["joint"].get<std::string>()] == exact);
      CHECK(angle["unit"] == (isSlide ? "mm" : "°"));
      CHECK(angle["value"].get<double>() == Approx(isSlide ? 1000 * exact : degrees(exact)).margin(0.001));
    }
  }
  CHECK(Json::parse(session.generateFile("poses.json"))["poses"].size() == 2);
}
