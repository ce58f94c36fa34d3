#include "MeasuredArm.hpp"
#include "TemporaryFolder.hpp"
#include "calibration/Prediction.hpp"
#include "io/Files.hpp"
#include "library/naocal.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace naocal {

TEST_CASE("an arm before a camera beside it is compared with its own result, with and without a guess of the camera") {
  // Proves that the errors are those of the fit although a board of four points hardly tells where the camera stands,
  // and that the drawing alone is compared, too.
  const bool isGuessed = GENERATE(true, false);
  const TemporaryFolder folder;
  writeArmSet(folder.path(), {.corners = true});
  if (!isGuessed) {
    nlohmann::json set = nlohmann::json::parse(readFile(folder.path() / "captures.json"));
    set["cameras"]["side"].erase("placementGuess");
    writeAtomically(folder.path() / "captures.json", set.dump());
  }
  const Captures captures =
      readCaptures({folder.path()}, std::filesystem::path{NAOCAL_SOURCE_DIR} / "home" / "configuration");
  const Calibrated calibrated = calibrate(captures);
  writeResult(captures, calibrated, folder.path() / "result.json");
  const Comparison comparison = compare(readKnownResult(folder.path() / "result.json"), *captures.measurements.sets,
                                        captures.measurements.robot, false);
  CHECK(comparison.all.rmsPx == Approx(calibrated.result.rmsPx).epsilon(0.05));
  CHECK(comparison.nominal.rmsPx > comparison.all.rmsPx);
}

} // namespace naocal
