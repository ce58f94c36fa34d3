#pragma once

#include "TemporaryFolder.hpp"
#include "calibration/result/ResultFile.hpp"
#include "data/CaptureSetFile.hpp"
#include "estimation/ModelBuilder.hpp"
#include "io/Files.hpp"
#include "report/ReportPage.hpp"
#include "simulation/HandMadePoses.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string>

namespace naocal {

/// Captures of a simulated robot and their calibration result, in a temporary folder.
class CalibratedFolder {
public:
  /// `image`: image path of all captures; empty: none.
  explicit CalibratedFolder(const std::string& image = "") {
    const Robot robot = loadRobot(configurationDirectory(), "V6");
    CaptureSet set = simulate(robot, handMadePlan(robot), 7).set;
    for (Capture& capture : set.captures) {
      capture.image = image;
    }
    writeCaptureSet(set, captures());
    const std::vector<CaptureSet> sets{readCaptureSet(captures()).set};
    const Measurements measurements = buildMeasurements(sets, robot);
    const Model model = buildModel(measurements, {}, {});
    const CalibrationResult fit = calibrate(measurements, model);
    result = resultJson({measurements, model, fit},
                        {{captures().string()}, {sha256(readFile(captures() / "captures.json"))}});
  }

  std::filesystem::path captures() const { return folder_.path() / "captures"; }
  std::filesystem::path resultFile() const { return folder_.path() / "result.json"; }

  /// The page of the present result.
  std::string page() const {
    writeAtomically(resultFile(), result.dump());
    return renderReport(resultFile());
  }

  nlohmann::json result;

private:
  TemporaryFolder folder_;
};

/// Data embedded in a page.
inline nlohmann::json shown(const std::string& page) {
  const std::string before = "<script type=\"application/json\" id=\"data\">";
  const std::size_t start = page.find(before) + before.size();
  return nlohmann::json::parse(page.substr(start, page.find("</script>", start) - start));
}

inline std::size_t occurrences(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) {
    ++count;
  }
  return count;
}

} // namespace naocal
