#include "SimulatedProcess.hpp"

#include "analysis/AnalysisSession.hpp"
#include "analysis/Dataset.hpp"
#include "math/Angles.hpp"

#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>

namespace naocal {

TEST_CASE("the panel says of a robot's recording what the robot said", "[robot]") {
  // Proves it for a leg's calibration, whose recording has two rounds, one for solving and one for checking: opened
  // alone, the panel shows the solved round with the robot's model, and the verdict, headline and numbers of its files.
  SimulatedProcess simulated{SimulatedProcess::plan(1, radians(5), radians(0.5))};
  const nlohmann::json state = simulated.calibrated("left leg");
  INFO(state.dump());
  REQUIRE(state["phase"] == "finished");
  const std::filesystem::path first = simulated.recording();
  const nlohmann::json result = nlohmann::json::parse(readFile(first / "result.json")),
                       diagnosis = nlohmann::json::parse(readFile(first / "diagnosis.json"));

  std::map<std::string, nlohmann::json> panel;
  AnalysisSession session{openDataset({first.parent_path().string()}),
                          [&](const std::string& kind, const nlohmann::json& content) { panel[kind] = content; }};
  session.fit();
  session.search();
  REQUIRE(panel.contains("fit"));
  REQUIRE(panel.contains("diagnosis"));
  const nlohmann::json &fit = panel["fit"], &shown = panel["diagnosis"];
  INFO(fit.dump().substr(0, 600));
  INFO(shown.dump().substr(0, 1500));
  CHECK(fit["verdict"] == result["verdict"]);
  CHECK(fit["rms"].get<double>() == Approx(result["rmsPx"].get<double>()));
  CHECK(fit["pValue"] == result["pValue"]);
  CHECK(result["sentence"].get<std::string>().starts_with(
      fit["headline"].get<std::string>().substr(0, fit["headline"].get<std::string>().size() - 1)));
  CHECK(shown["verdict"] == diagnosis["verdict"]);
  CHECK(shown["suggested"] == diagnosis["suggested"]);
}

} // namespace naocal
