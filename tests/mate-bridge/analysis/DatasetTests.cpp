#include "analysis/Dataset.hpp"

#include "TemporaryFolder.hpp"
#include "analysis/AnalysisSession.hpp"
#include "data/CaptureSetFile.hpp"
#include "estimation/ModelBuilder.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "simulation/Simulation.hpp"
#include "simulation/StandingPoses.hpp"

#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>

using namespace naocal;
using Catch::Contains;
using Json = nlohmann::json;

namespace {

/// A set "few" and a result of it beside it, with one more effect and an outdated path of the set.
void writeSetAndResult(const std::filesystem::path& folder) {
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan;
  plan.poses = planStandingPoses(robot, plan, SupportFoot::left, 8, 1);
  const std::vector<CaptureSet> sets{simulate(robot, plan, 1).set};
  writeCaptureSet(sets.front(), folder / "few");
  const Measurements measurements = buildMeasurements(sets, robot);
  const Model model = buildModel(measurements, {"elasticity@LKneePitch"}, {"jointOffset@HeadYaw"});
  const CalibrationResult fit = calibrate(measurements, model);
  const Json result = resultJson({measurements, model, fit}, {{"/gone/few"}, {""}});
  writeAtomically(folder / "result.json", result.dump());
}

} // namespace

TEST_CASE("a result is opened with its captures and its model") {
  // Proves that captures are found beside the result, and that the session starts with the result's model.
  const TemporaryFolder folder;
  writeSetAndResult(folder.path());
  std::map<std::string, Json> told;
  AnalysisSession session{openDataset({(folder.path() / "result.json").string()}),
                          [&](const std::string& kind, const Json& content) { told[kind] = content; }};
  session.fit();
  CHECK(told["fit"]["with"] == Json::array({"elasticity@LKneePitch"}));
  CHECK(told["fit"]["without"] == Json::array({"jointOffset@HeadYaw"}));
  CHECK_FALSE(told["fit"]["pictures"].empty());
}

TEST_CASE("a recording is opened with all its sets, a diagnosis with what it suggests") {
  // Proves both, and that an older diagnosis without inputs requires its sets to be named and is refused otherwise.
  const TemporaryFolder folder;
  writeSetAndResult(folder.path() / "recording");
  std::filesystem::rename(folder.path() / "recording" / "few", folder.path() / "recording" / "second");
  std::filesystem::copy(folder.path() / "recording" / "second", folder.path() / "recording" / "first",
                        std::filesystem::copy_options::recursive);
  const std::string recording = (folder.path() / "recording").string();
  const Dataset opened = openDataset({recording});
  REQUIRE(opened.sets.size() == 2);
  CHECK(opened.sets.front().name == "first");

  const std::string first = recording + "/first", file = (folder.path() / "diagnosis.json").string();
  Json diagnosis{{"format", "naocal-diagnosis"}, {"version", 1}, {"suggested", {"elasticity@LKneePitch"}}};
  writeAtomically(file, diagnosis.dump());
  CHECK_THROWS_WITH(openDataset({file}), Contains("name them behind it"));
  CHECK(openDataset({file, first}).with == std::vector<std::string>{"elasticity@LKneePitch"});
  diagnosis["inputs"] = {{"sets", {first}}, {"sha256", {""}}};
  writeAtomically(file, diagnosis.dump());
  CHECK(openDataset({file}).sets.size() == 1);
}

TEST_CASE("a model that was saved is opened with captures") {
  // Proves that added, removed and custom effects are restored; a model alone is refused.
  const TemporaryFolder folder;
  writeSetAndResult(folder.path());
  const std::string model = (folder.path() / "model.json").string(), set = (folder.path() / "few").string();
  const Json spring{{"name", "softness"},
                    {"at", "LKneePitch"},
                    {"correction", "a*tau"},
                    {"unknowns", {{"a", {{"unit", "rad/Nm"}, {"sigma", 0.01}}}}}};
  writeAtomically(model, Json{{"format", "naocal-model"},
                              {"version", 1},
                              {"with", {"softness@LKneePitch"}},
                              {"without", {"jointOffset@HeadYaw"}},
                              {"define", {spring}}}
                             .dump());
  std::map<std::string, Json> told;
  AnalysisSession session{openDataset({model, set}),
                          [&](const std::string& kind, const Json& content) { told[kind] = content; }};
  session.fit();
  CHECK(told["fit"]["with"] == Json::array({"softness@LKneePitch"}));
  CHECK(told["fit"]["without"] == Json::array({"jointOffset@HeadYaw"}));
  CHECK(told["set"]["own"][0] == spring);
  CHECK_THROWS_WITH(openDataset({model}), Contains("name them behind it"));
}

TEST_CASE("a session is kept as it goes, and gone on from", "[slow]") {
  // Proves that the file contains the history after each change; that it can be opened alone, with its captures, and by
  // a panel that keeps it, restoring the present revision and results; and that modified captures are refused.
  const TemporaryFolder folder;
  writeSetAndResult(folder.path());
  const std::string set = (folder.path() / "few").string(), file = (folder.path() / "kept").string();
  std::map<std::string, Json> told;
  const auto tell = [&](const std::string& kind, const Json& content) { told[kind] = content; };
  {
    AnalysisSession session{openSession({set}, file), tell};
    session.fit();
    session.add({"elasticity@LKneePitch"});
    session.search();
    session.add({"focalLength@top"});
    session.goTo(1);
  }
  const Json ladder = told["ladder"];
  for (const Dataset& opened : {openDataset({file}), openDataset({file, set}), openSession({set}, file)}) {
    told.clear();
    AnalysisSession session{opened, tell};
    session.fit();
    CHECK(told["fit"]["with"] == Json::array({"elasticity@LKneePitch"}));
    CHECK(told["ladder"] == ladder);
    CHECK(ladder["rungs"][1].contains("heldOut"));
    Json saved = Json::parse(session.generateFile("session.json")); // may be saved anywhere, so its places are whole
    CHECK(saved["sets"] == Json::array({std::filesystem::canonical(set).string()}));
    saved["sets"] = Json::array({"few"});
    CHECK(saved == Json::parse(readFile(file)));
  }
  writeAtomically(std::filesystem::path{set} / "captures.json",
                  readFile(std::filesystem::path{set} / "captures.json") + "\n");
  CHECK_THROWS_WITH(openSession({set}, file), Contains("expected a session of these captures"));
}

TEST_CASE("captures that were moved are opened where they are now") {
  // Proves it for a result and a session: relative places move with their file, others are found by their sum in a
  // folder that is named, and a set that is missing is asked for; a session does not take a set that has changed.
  const TemporaryFolder folder;
  const std::filesystem::path root = std::filesystem::canonical(folder.path()), work = root / "work";
  writeSetAndResult(work);
  const std::string set = (work / "few").string(), session = (work / "session.json").string();
  AnalysisSession{openSession({set}, session), [](const std::string&, const Json&) {}}.fit();
  CHECK(Json::parse(readFile(session))["sets"] == Json::array({"few"}));
  Json result = Json::parse(readFile(work / "result.json"));
  result["inputs"] = toJson(openDataset({set}).inputs.placedBeside(work / "result.json"));
  CHECK(result["inputs"]["sets"] == Json::array({"few"}));
  writeAtomically(work / "result.json", result.dump());

  std::filesystem::rename(work, root / "elsewhere");
  for (const char* file : {"result.json", "session.json"}) {
    const Dataset opened = openDataset({(root / "elsewhere" / file).string()});
    CHECK(opened.moved.empty());
    CHECK(opened.folders.at("few") == root / "elsewhere/few");
  }
  std::filesystem::create_directories(root / "a/b/c");
  std::filesystem::rename(root / "elsewhere/few", root / "a/b/c/renamed");
  for (const char* file : {"result.json", "session.json"}) {
    const std::vector<std::string> paths{(root / "elsewhere" / file).string()};
    CHECK_THROWS_AS(openDataset(paths), MissingCaptures);
    const Dataset opened = openDataset(paths, {root / "a"});
    CHECK(opened.folders.at("renamed") == root / "a/b/c/renamed");
    REQUIRE(opened.moved.size() == 1);
    CHECK_THAT(opened.moved.front(), Contains("were moved"));
  }
  std::filesystem::copy(root / "a/b/c/renamed", root / "elsewhere/few", std::filesystem::copy_options::recursive);
  writeAtomically(root / "elsewhere/few/captures.json", readFile(root / "elsewhere/few/captures.json") + "\n");
  CHECK_THROWS_AS(openDataset({(root / "elsewhere/session.json").string()}), MissingCaptures);
  const Dataset changed = openDataset({(root / "elsewhere/result.json").string()});
  REQUIRE(changed.moved.size() == 1);
  CHECK_THAT(changed.moved.front(), Contains("has changed"));
}

TEST_CASE("what cannot be opened is refused with its name and what to do") {
  // Proves the messages for unsupported files and for a result without its captures.
  const TemporaryFolder folder;
  writeSetAndResult(folder.path());
  const std::string result = (folder.path() / "result.json").string();
  CHECK_THROWS_AS(openDataset({(folder.path() / "nowhere").string()}), InputError);
  CHECK_THROWS_WITH(openDataset({result, result}), Contains("opened by itself"));
  writeAtomically(folder.path() / "other.json", R"({"format": "naocal-poses"})");
  CHECK_THROWS_WITH(openDataset({(folder.path() / "other.json").string()}),
                    Contains("opens capture sets, recordings, results, diagnoses, sessions and models"));
  const std::string overlong(5000, 'x'); // longer than any system's paths
  CHECK_THROWS_AS(openDataset({overlong}), InputError);
  CHECK_THROWS_AS(openDataset({overlong + ".json"}), InputError);
  std::filesystem::remove_all(folder.path() / "few");
  CHECK_THROWS_WITH(openDataset({result}), Contains("/gone/few") && Contains("--look-in"));
}
