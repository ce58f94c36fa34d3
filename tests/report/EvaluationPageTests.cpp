#include "Browser.hpp"
#include "Result.hpp"

#include "io/InputError.hpp"

#include <catch2/catch.hpp>

using namespace naocal;
using nlohmann::json;

namespace {

/// JSON of an evaluation of one setting with two solvers.
json evaluation() {
  json cell{{"table", "5.7"},
            {"feature", "boards"},
            {"poses", 3},
            {"noise", "both"},
            {"jointNoise", "encoder"},
            {"samples", 1},
            {"errors", "6.5"},
            {"legs", "left"},
            {"places", "known"},
            {"chosenBy", "ours"},
            {"solver", "ours"},
            {"thesis", 0.25},
            {"success", {{"0.1", 0.5}, {"0.2", 0.75}, {"1.0", 1}}},
            {"limit", {{"0.1", 0.5}, {"0.2", 0.875}, {"1.0", 1}}},
            {"errorCounts", {{"HeadYaw", {1, 2, 1}}}},
            {"offsetCounts", {{"HeadYaw", {2, 2}}}}};
  json plain = cell;
  plain["solver"] = "lm";
  plain["success"]["0.2"] = 0.625;
  return {{"format", "naocal-evaluation"},
          {"version", 1},
          {"sets", 4},
          {"errorBins", {{"firstDegrees", -0.15}, {"widthDegrees", 0.1}}},
          {"offsetBins", {{"firstDegrees", -5}, {"widthDegrees", 5}}},
          {"cells", {cell, plain}}};
}

/// The same as the thesis's own program made it, with residuals on the floor and restarted failures.
json programEvaluation() {
  json file = evaluation();
  for (json& cell : file["cells"]) {
    cell["table"] = "5.6-program";
    cell["feature"] = "program-grid";
    cell["chosenBy"] = "thesis-program";
    cell["residuals"] = {{"squareMetres", 0.05},
                         {"squares", {{4, -2, 3, 6.0}, {5, -2, 2, 0.5}}},
                         {"fieldsOfView", {{{0.1, 0.2}, {1.5, 0.9}, {1.4, -0.9}, {0.1, -0.2}}}}};
  }
  file["cells"][1]["solver"] = "lm-program";
  file["restartedFailures"] = {{"failures", 40}, {"reached", 39}, {"ranOut", 20}, {"interval", {0.87, 0.995}}};
  return file;
}

std::string evaluationPage(const json& file) {
  const TemporaryFolder folder;
  writeAtomically(folder.path() / "evaluation.json", file.dump());
  return renderReport(folder.path() / "evaluation.json");
}

} // namespace

TEST_CASE("a page about an evaluation shows every solver's success and errors") {
  // Proves that values are unchanged, sorted by tolerance, and that solvers of a setting are grouped. Drawing is tested
  // below.
  const json data = shown(evaluationPage(evaluation()));
  CHECK(data["tolerances"] == json{0.1, 0.2, 1.0});
  REQUIRE(data["tables"].size() == 1);
  REQUIRE(data["tables"][0]["cells"].size() == 1);
  const json& figure = data["tables"][0]["cells"][0];
  CHECK(figure["thesis"] == 0.25);
  REQUIRE(figure["solvers"].size() == 2);
  CHECK(figure["solvers"][0]["limit"] == json{0.5, 0.875, 1});
  CHECK(figure["solvers"][1]["success"] == json{0.5, 0.625, 1});
  const json& joint = data["settings"][0]["joints"][0];
  CHECK(joint["name"] == "HeadYaw");
  CHECK(joint["before"]["counts"] == json{2, 2});
  CHECK(joint["solvers"][1]["counts"] == json{1, 2, 1});
  json none = evaluation();
  none["cells"] = json::array();
  CHECK_THROWS_AS(evaluationPage(none), InputError);
}

TEST_CASE("a browser draws the page about an evaluation without complaint", "[browser]") {
  // Proves, with Chromium installed, that both groups of figures exist and no script fails.
  const auto drawn = drawnByBrowser(evaluationPage(evaluation()));
  if (!drawn) {
    return;
  }
  CHECK_THAT(*drawn, !Catch::Contains("Uncaught"));
  CHECK_THAT(*drawn, Catch::Contains("aria-label=\"HeadYaw\""));
  CHECK_THAT(*drawn, Catch::Contains("aria-label=\"boards, 3 poses, noise: both (encoder)\""));
}

TEST_CASE("a page about the thesis's program has maps of residuals and the restarted failures") {
  // Proves that means, fields of view and counts are handed over, that tables have their titles, and that malformed
  // maps are refused.
  const json data = shown(evaluationPage(programEvaluation()));
  CHECK(data["tables"][0]["name"] == "5.6 as its program made it");
  REQUIRE(data["residualMaps"].size() == 1);
  const json& map = data["residualMaps"][0];
  REQUIRE(map["solvers"].size() == 2);
  CHECK(map["solvers"][1]["solver"] == "lm-program");
  CHECK(map["solvers"][1]["squares"][0] == json{4, -2, 3, 2});
  CHECK(map["fieldsOfView"][0][1] == json{1.5, 0.9});
  CHECK(data["restartedFailures"]["reached"] == 39);
  CHECK(shown(evaluationPage(evaluation()))["residualMaps"].empty());
  json bad = programEvaluation();
  bad["cells"][0]["residuals"]["squares"][0] = {4, -2};
  CHECK_THROWS_AS(evaluationPage(bad), InputError);
}

TEST_CASE("a browser draws maps of residuals without complaint", "[browser]") {
  // Proves, with Chromium installed, that a map per solver and the sentence about restarts exist and no script fails.
  const auto drawn = drawnByBrowser(evaluationPage(programEvaluation()));
  if (!drawn) {
    return;
  }
  CHECK_THAT(*drawn, !Catch::Contains("Uncaught"));
  CHECK_THAT(*drawn, Catch::Contains("aria-label=\"residuals on the floor, the thesis's program\""));
  CHECK_THAT(*drawn, Catch::Contains("of 40 noiseless failures here, 39 reach the true offsets"));
}
