#include "Browser.hpp"
#include "Result.hpp"

#include <catch2/catch.hpp>

using namespace naocal;

TEST_CASE("a browser draws the whole report without complaint", "[browser]") {
  // Proves that the scripts finish without console messages, with hostile names too, and draw the expected figures.
  // Their look is not tested.
  CalibratedFolder calibrated;
  for (nlohmann::json& observation : calibrated.result["sightings"]) {
    observation["pose"] = "<img src=x onerror=console.error('broken')>" + observation["pose"].get<std::string>();
  }
  const auto output = drawnByBrowser(calibrated.page());
  if (!output) {
    return;
  }
  CHECK_THAT(*output, Catch::Contains("<h1 id=\"headline\">This calibration is good"));
  CHECK_THAT(*output, Catch::Contains(">LKneePitch</option>"));
  CHECK(occurrences(*output, "<canvas") == 6 + 2 + 2 + 4); // pictures, cameras, poses and boards, angles and times
  CHECK(occurrences(*output, "CONSOLE") == 0);
}
