#include "Browser.hpp"
#include "Result.hpp"

#include "diagnosis/DiagnosisFile.hpp"
#include "diagnosis/OwnEffect.hpp"
#include "estimation/ModelFile.hpp"
#include "io/InputError.hpp"

#include <catch2/catch.hpp>

using namespace naocal;
using nlohmann::json;

namespace {

/// JSON of a simulated robot's diagnosis; created once.
const json& diagnosed() {
  static const json file = [] {
    const Robot robot = loadRobot(configurationDirectory(), "V6");
    const std::vector<CaptureSet> sets{simulate(robot, handMadePlan(robot), 7).set};
    return diagnosisJson(diagnose(buildMeasurements(sets, robot)));
  }();
  return file;
}

std::string pageOf(const json& diagnosis) {
  const TemporaryFolder folder;
  writeAtomically(folder.path() / "diagnosis.json", diagnosis.dump(-1, ' ', false, json::error_handler_t::replace));
  return renderReport(folder.path() / "diagnosis.json");
}

} // namespace

TEST_CASE("a page about a diagnosis shows every candidate with its numbers") {
  // Proves that no candidate is lost or changed in the page's data, and that angles are in degrees. Drawing is tested
  // in the browser.
  const json& file = diagnosed();
  const json data = shown(pageOf(file));
  CHECK(data["sentence"] == file["sentence"]);
  REQUIRE(file["ranking"].size() > 50);
  REQUIRE(data["candidates"].size() == file["ranking"].size());
  for (std::size_t i = 0; i < file["ranking"].size(); ++i) {
    const json &entry = file["ranking"][i], &candidate = data["candidates"][i];
    CHECK(candidate["label"] == entry["effect"].get<std::string>() + "@" + entry["at"].get<std::string>());
    CHECK(candidate["state"] == entry["state"]);
    CHECK(candidate["evidence"] == entry["evidence"]);
    CHECK(candidate["realDrop"] == entry["chi2Drop"]);
    CHECK(candidate["equivalent"] == entry["equivalent"]);
    for (const json& size : candidate["sizes"]) {
      const json& unknown = entry["unknowns"][size["name"].get<std::string>()];
      if (unknown["unit"] == "rad/Nm" && unknown["value"].is_number()) {
        CHECK(size["unit"] == "°/Nm");
        CHECK(size["value"].get<double>() == Approx(degrees(unknown["value"].get<double>())));
        CHECK(size["sigma"].get<double>() == Approx(degrees(unknown["sigma"].get<double>())));
      }
    }
  }
  CHECK(data["steps"].size() == file["steps"].size());
  REQUIRE(file["map"].size() > 50);
  CHECK(data["map"].size() == file["map"].size());
  CHECK(data["curves"].size() == 3);
}

TEST_CASE("a page about a diagnosis shows each figure's numbers in units that people read") {
  // Proves that added variables, correlations and signatures are those of the file, in degrees instead of radians. The
  // numbers themselves are tested with the diagnosis.
  const json& file = diagnosed();
  const json data = shown(pageOf(file));
  std::size_t plots = 0, imprints = 0;
  for (std::size_t i = 0; i < file["ranking"].size(); ++i) {
    const json &entry = file["ranking"][i], &candidate = data["candidates"][i];
    plots += entry.contains("addedVariable");
    imprints += entry.contains("imprint");
    CHECK(candidate["added"].is_null() != entry.contains("addedVariable"));
    CHECK(candidate["imprint"].is_null() != entry.contains("imprint"));
    if (entry.contains("addedVariable") && entry["addedVariable"]["unit"] == "rad/Nm") {
      const json &plot = entry["addedVariable"], &shownPlot = candidate["added"];
      CHECK(shownPlot["slope"].get<double>() == Approx(degrees(plot["slope"].get<double>())));
      REQUIRE(shownPlot["points"].size() == plot["points"].size());
      CHECK(degrees(shownPlot["points"][0][1].get<double>()) == Approx(plot["points"][0]["signature"].get<double>()));
      CHECK(shownPlot["points"][0][2] == plot["points"][0]["residual"]);
    }
    if (entry.contains("imprint")) {
      REQUIRE(candidate["imprint"]["pictures"].size() == entry["imprint"]["pictures"].size());
      CHECK(candidate["imprint"]["pictures"][0]["corners"] == entry["imprint"]["pictures"][0]["corners"]);
    }
  }
  CHECK(plots >= 5);
  CHECK(imprints == 10);
  CHECK(data["aliases"]["candidates"] == file["aliases"]["candidates"]);
  CHECK(data["aliases"]["correlations"] == file["aliases"]["correlations"]);
  CHECK(data["poses"].size() == file["poses"].size());
  const json &point = file["left"]["asGiven"]["whatIf"][0]["points"][0],
             &shownPoint = data["left"]["asGiven"]["whatIf"][0]["points"][0];
  CHECK(shownPoint[0] == point["pictures"]);
  CHECK(shownPoint[1].get<double>() == Approx(degrees(point["deflection"].get<double>())));
  CHECK(shownPoint[2].get<double>() == Approx(degrees(point["sigma"].get<double>())));
  CHECK(data["left"]["asGiven"]["within"]["cells"].size() == file["left"]["asGiven"]["withinPictures"]["cells"].size());
}

TEST_CASE("only drivers that were recorded and varied are offered") {
  // Proves the list of drivers with a value per picture; without temperatures they are not offered, while directions of
  // approach that were not recorded follow from the order of captures.
  const json& file = diagnosed();
  const json data = shown(pageOf(file));
  REQUIRE(data["drivers"].size() > 10);
  for (const json& driver : data["drivers"]) {
    CHECK(driver["values"].size() == data["pictures"].size());
    const auto [least, most] = std::minmax_element(driver["values"].begin(), driver["values"].end());
    CHECK(*least < *most);
  }
  const auto offered = [&](const std::string& unit) {
    return std::count_if(data["drivers"].begin(), data["drivers"].end(),
                         [&](const json& driver) { return driver["unit"] == unit; });
  };
  CHECK(offered("°") > 5);
  CHECK(offered("Nm") > 5);
  CHECK(offered("s") == 1);
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  CaptureSet bare = simulate(robot, handMadePlan(robot), 7).set;
  for (Capture& capture : bare.captures) {
    capture.joints.temperature.clear();
    capture.joints.approach.clear();
  }
  DiagnosisOptions quick;
  quick.calibration.candidateTests.draws = 0;
  const json without = diagnosisJson(diagnose(buildMeasurements({bare}, robot), quick));
  for (const json& driver : without["recorded"]) {
    CHECK(driver["driver"] != "T");
  }
}

TEST_CASE("a page says in words which candidates the captures cannot tell apart") {
  // Proves the sentence for the three cases: indistinguishable from another, distinguished from all others, nothing
  // found.
  json file = diagnosed();
  file["aliases"] = {{"candidates", {"elasticity@LKneePitch", "encoderGain@LKneePitch"}},
                     {"correlations", {{1, 0.97}, {0.97, 1}}},
                     {"confusable", json::array()}};
  file["suggested"] = json::array();
  const auto sentence = [&] { return shown(pageOf(file))["aliases"]["sentence"].get<std::string>(); };
  CHECK_THAT(sentence(), Catch::Contains("would hardly tell which"));
  file["suggested"] = json::array({"elasticity@LKneePitch"});
  CHECK_THAT(sentence(), Catch::Contains("tell elasticity@LKneePitch from"));
  file["aliases"]["confusable"] = {{{"taken", "elasticity@LKneePitch"},
                                    {"other", "encoderGain@LKneePitch"},
                                    {"correlation", 0.97},
                                    {"timesTheData", 2.34}}};
  CHECK_THAT(sentence(), Catch::Contains("cannot tell elasticity@LKneePitch from encoderGain@LKneePitch"));
  CHECK_THAT(sentence(), Catch::Contains("2.3 times as much data"));
}

TEST_CASE("a diagnosis file from before its figures were written still has a page") {
  // Proves that every newer key is optional.
  json file = diagnosed();
  for (const char* key : {"poses", "pictures", "cameras", "aliases", "recorded", "left"}) {
    file.erase(key);
  }
  for (json& entry : file["ranking"]) {
    entry.erase("addedVariable");
    entry.erase("imprint");
  }
  CHECK(shown(pageOf(file))["candidates"].size() == file["ranking"].size());
}

TEST_CASE("the expression that a page proposes is a model that can be calibrated") {
  // Proves that the text to copy is a valid model file and includes the suggested effects. That it describes the curve
  // is tested with the diagnosis.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  json file = diagnosed();
  file["suggested"] = {"focalLength@top"};
  file["drivers"][0]["at"] = "LKneePitch";
  file["drivers"][0]["driver"] = "q";
  file["drivers"][0]["expression"] = "a*sin(6*q) + b*cos(6*q)";
  file["drivers"][0]["effect"] = curveAsUserEffect({.place = "LKneePitch",
                                                    .driver = "q",
                                                    .expression = "a*sin(6*q) + b*cos(6*q)",
                                                    .coefficients = {{"a", 0.008}, {"b", -0.001}}});
  const json model = shown(pageOf(file))["curves"][0]["model"];
  const TemporaryFolder folder;
  writeAtomically(folder.path() / "model.json", model.dump());
  const ModelFile read = readModelFile(folder.path() / "model.json", robot);
  CHECK(read.with == std::vector<std::string>{"focalLength@top", "found_LKneePitch_over_q@LKneePitch"});
  REQUIRE(read.effects.back().name == "found_LKneePitch_over_q");
  CHECK(read.effects.back().unknowns.size() == 2);
}

TEST_CASE("a diagnosis of captures that cannot be fitted still has a page") {
  // Proves that a file without ladder, candidates and curves is shown with its verdict.
  json file = diagnosed();
  file["verdict"] = "bad-captures";
  for (const char* list : {"ranking", "steps", "drivers", "map"}) {
    file[list] = json::array();
  }
  file.erase("findings"); // as in earlier versions
  file["suspicious"] = {{{"capture", 17}, {"why", "board A was moved"}}};
  const json data = shown(pageOf(file));
  CHECK(data["headline"] == "Something is wrong with the captures or the set-up.");
  CHECK(data["findings"][0]["sentence"] == "board A was moved (capture 17)");
}

TEST_CASE("a broken diagnosis file is refused with one sentence", "[slow]") {
  // Proves the place in the message for a selection of faults.
  const auto refusal = [](const std::string& pointer, const json& value) {
    json file = diagnosed();
    file[json::json_pointer{pointer}] = value;
    try {
      pageOf(file);
    } catch (const InputError& error) {
      return std::string{error.what()};
    }
    return std::string{"no refusal"};
  };
  CHECK_THAT(refusal("/format", "naocal-captures"), Catch::Contains("\"naocal-diagnosis\""));
  CHECK_THAT(refusal("/version", 2), Catch::Contains("version"));
  CHECK_THAT(refusal("/verdict", "fine"), Catch::Contains("verdict: expected one of adequate"));
  CHECK_THAT(refusal("/ranking/3/state", "maybe"), Catch::Contains("ranking[3].state"));
  CHECK_THAT(refusal("/ranking/3/equivalent", 1), Catch::Contains("ranking[3].equivalent"));
  CHECK_THAT(refusal("/drivers/0/curve/5", {1, 2}), Catch::Contains("drivers[0].curve[5]"));
  CHECK_THAT(refusal("/drivers/0/curve", json::array()), Catch::Contains("drivers[0].curve: expected at least two"));
  CHECK_THAT(refusal("/poses/0/pictures/0", 100000), Catch::Contains("poses[0].pictures[0]"));
  CHECK_THAT(refusal("/aliases/correlations/1", {1}), Catch::Contains("aliases.correlations[1]"));
  CHECK_THAT(refusal("/ranking/0/addedVariable/points/0/pose", -1), Catch::Contains("addedVariable.points[0].pose"));
  CHECK_THAT(refusal("/recorded/0/values", {1, 2}), Catch::Contains("recorded[0].values"));
  CHECK_THAT(refusal("/left/asGiven/whatIf/0/points/0/pictures", json::array()), Catch::Contains("points[0].pictures"));
  CHECK_THAT(refusal("/ranking/0/imprint/pictures/0/corners/0", {1, 2}), Catch::Contains("corners[0]"));
  CHECK_THAT(refusal("/steps/0/heldOutPx", "small"), Catch::Contains("steps[0].heldOutPx"));
  CHECK_THAT(refusal("/findings", 3), Catch::Contains("findings"));
  CHECK_THAT(refusal("/findings/0", 3), Catch::Contains("findings[0]"));
  CHECK_THAT(refusal("/findings/0/level", "grave"), Catch::Contains("findings[0].level: expected one of stop"));
}

TEST_CASE("a browser draws the whole diagnosis without complaint", "[browser]") {
  // Proves that the scripts finish without console messages, with hostile names too, and that the page loads nothing
  // from elsewhere. The figures' look is not tested.
  json file = diagnosed();
  file["verdict"] = "unknown-effect";
  file["ranking"][1]["at"] = "<img src=x onerror=console.error('broken')>";
  file["drivers"][0]["evidence"] = 40;
  const std::string page = pageOf(file);
  for (const std::string reference : {"http:", "https:", "//www", "<link", "url(", "src=\"", "innerHTML"}) {
    INFO(reference);
    CHECK(occurrences(page, reference) == 0);
  }
  const auto output = drawnByBrowser(page);
  if (!output) {
    return;
  }
  CHECK_THAT(*output, Catch::Contains("Something that no known effect explains is at work.</h1>"));
  // added variables, aliases, signature, map, curves, joint errors, residual fields and distance, boards
  CHECK(occurrences(*output, "<canvas") == 4 + 1 + 2 + 1 + 3 + 1 + 2 + 1 + 4);
  CHECK(occurrences(*output, "<textarea") >= 1); // of the significant curve
  CHECK(occurrences(*output, "<tr>") == 1 + 12); // header and first candidates
  CHECK(occurrences(*output, "CONSOLE") == 0);
}

TEST_CASE("a page about a diagnosis draws curves of mounts, of boards and of lenses, which have no expression") {
  // Proves that such a curve does not cause a refusal, that its values are in display units, and that an empty proposal
  // is not shown.
  json file = diagnosed();
  file["next"] = {{"poses", json::array()}, {"why", ""}};
  const auto [unit, shownUnit, scale] = GENERATE(
      table<std::string, std::string, double>({{"rad", "°", degrees(1.0)}, {"m", "mm", 1000.0}, {"px", "px", 1.0}}));
  json& curve = file["drivers"][0];
  curve["expression"] = "";
  curve.erase("effect");
  curve["about"] = "y";
  curve["unit"] = unit;
  const json data = shown(pageOf(file)), &drawn = data["curves"][0];
  CHECK_FALSE(data.contains("next"));
  CHECK(drawn["valueUnit"] == shownUnit);
  CHECK(drawn["model"].is_null());
  CHECK(drawn["amplitude"].get<double>() == Approx(scale * curve["amplitude"].get<double>()));
}
