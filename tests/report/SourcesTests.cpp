#include "Result.hpp"

#include "io/GreyImage.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

using namespace naocal;
using nlohmann::json;

namespace {

void writeNoise(const std::filesystem::path& file, int width, int height) {
  GreyPicture picture{width, height, std::vector<std::uint8_t>(std::size_t(width) * std::size_t(height))};
  std::mt19937 random{1};
  std::generate(picture.pixels.begin(), picture.pixels.end(), [&] { return static_cast<std::uint8_t>(random()); });
  std::filesystem::create_directories(file.parent_path());
  writeImage(picture, file);
}

bool hasPhotograph(const json& picture) {
  return picture.contains("photograph");
}

} // namespace

TEST_CASE("joint angles in a report are those of the captures") {
  // Proves that every picture gets its own capture's readings, in degrees.
  const CalibratedFolder calibrated;
  const CaptureSet set = readCaptureSet(calibrated.captures()).set;
  const json data = shown(calibrated.page());
  CHECK(data["missing"].empty());
  for (const json& picture : data["pictures"]) {
    const Capture& capture = set.captures.at(picture["capture"].get<std::size_t>());
    REQUIRE(capture.id == picture["capture"].get<int>());
    for (std::size_t i = 0; i < set.jointNames.size(); ++i) {
      CHECK(picture["angles"][set.jointNames[i]].get<double>() ==
            Approx(degrees(capture.joints.measured[i])).margin(0.0051));
    }
  }
}

TEST_CASE("a report says how far the drawing alone is off where the captures are still there") {
  // Proves that the comparison is made and looks better after the calibration than before.
  const CalibratedFolder calibrated;
  const auto figure = [&] { return shown(calibrated.page())["facts"][0]["figure"].get<std::string>(); };
  CHECK(std::stod(figure()) > 5 * calibrated.result["rmsPx"].get<double>());
  CHECK_THAT(figure(), Catch::Contains("→"));
  std::filesystem::remove_all(calibrated.captures());
  CHECK_THAT(figure(), !Catch::Contains("→"));
}

TEST_CASE("a report is made without the captures and says that they are gone") {
  // Proves that everything the result file holds is shown without angles and photographs.
  const CalibratedFolder calibrated{"images/one.png"};
  writeNoise(calibrated.captures() / "images/one.png", 64, 48);
  const json before = shown(calibrated.page());
  std::filesystem::remove_all(calibrated.captures());
  const json after = shown(calibrated.page());
  REQUIRE(after["pictures"].size() == before["pictures"].size());
  for (std::size_t i = 0; i < after["pictures"].size(); ++i) {
    CHECK(after["pictures"][i]["boards"] == before["pictures"][i]["boards"]);
    CHECK(after["pictures"][i]["angles"].empty());
    CHECK_FALSE(hasPhotograph(after["pictures"][i]));
  }
  CHECK_THAT(after["missing"][0].get<std::string>(), Catch::Contains("no longer there"));
}

TEST_CASE("angles and photographs of captures that have changed are not shown") {
  // Proves that a report never mixes a result with other captures, such as another folder of the same name.
  const CalibratedFolder calibrated{"images/one.png"};
  writeNoise(calibrated.captures() / "images/one.png", 64, 48);
  CaptureSet set = readCaptureSet(calibrated.captures()).set;
  set.captures.front().joints.measured.front() += 0.1;
  writeCaptureSet(set, calibrated.captures());
  const json data = shown(calibrated.page());
  CHECK_THAT(data["missing"][0].get<std::string>(), Catch::Contains("has changed"));
  CHECK(data["pictures"][0]["angles"].empty());
  CHECK_FALSE(hasPhotograph(data["pictures"][0]));
}

TEST_CASE("captures are also looked for beside the result file") {
  // Proves that a folder that was copied as a whole still gives a whole report.
  CalibratedFolder calibrated;
  calibrated.result["inputs"]["sets"] = json::array({"captures"});
  CHECK(shown(calibrated.page())["missing"].empty());
}

TEST_CASE("photographs are embedded, made smaller, and none where there is no picture") {
  // Proves the data URI by reading it back as a browser would; its base64 by the picture's own size.
  const CalibratedFolder calibrated{"images/large.png"};
  CHECK_FALSE(hasPhotograph(shown(calibrated.page())["pictures"][0]));
  writeNoise(calibrated.captures() / "images/large.png", 1280, 960);
  const std::string photograph = shown(calibrated.page())["pictures"][0]["photograph"];
  const std::string head = "data:image/jpeg;base64,";
  REQUIRE(photograph.starts_with(head));
  CHECK(photograph.substr(head.size(), 4) == "/9j/"); // FF D8 FF, with which every JPEG begins
  CHECK((photograph.size() - head.size()) % 4 == 0);
  writeAtomically(calibrated.captures() / "images/large.png", "this is no picture");
  CHECK_FALSE(hasPhotograph(shown(calibrated.page())["pictures"][0]));
}

TEST_CASE("a picture outside the set's folder is left where it is") {
  // Proves that somebody else's result file cannot take private pictures into a page that is passed on.
  CalibratedFolder calibrated;
  writeNoise(calibrated.captures() / ".." / "private.png", 64, 48);
  const std::string outside = (calibrated.captures() / ".." / "private.png").string();
  for (const std::string& path : {std::string{"../private.png"}, outside}) {
    for (json& observation : calibrated.result["sightings"]) {
      observation["image"] = path;
    }
    CHECK_FALSE(hasPhotograph(shown(calibrated.page())["pictures"][0]));
  }
}

TEST_CASE("a report stays small however many photographs there are") {
  // Proves the bound with pictures that cannot be compressed: the worst are kept, the page stays below 4 MB.
  const CalibratedFolder calibrated{"images/noise.png"};
  writeNoise(calibrated.captures() / "images/noise.png", 640, 480);
  const std::string page = calibrated.page();
  const json pictures = shown(page)["pictures"];
  CHECK(page.size() < 4'000'000);
  CHECK(hasPhotograph(pictures.front()));
  CHECK_FALSE(hasPhotograph(pictures.back()));
}
