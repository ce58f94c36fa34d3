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
  // Proves that every picture has the readings of its capture, in degrees.
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
  // Proves that the comparison with the drawing is shown while captures are available, and that its error is larger.
  const CalibratedFolder calibrated;
  const auto figure = [&] { return shown(calibrated.page())["facts"][0]["figure"].get<std::string>(); };
  CHECK(std::stod(figure()) > 5 * calibrated.result["rmsPx"].get<double>());
  CHECK_THAT(figure(), Catch::Contains("→"));
  std::filesystem::remove_all(calibrated.captures());
  CHECK_THAT(figure(), !Catch::Contains("→"));
}

TEST_CASE("a report is made without the captures and says that they are gone") {
  // Proves that all content of the result file is shown, without angles and photographs.
  const CalibratedFolder calibrated{"images/one.png"};
  writeNoise(calibrated.captures() / "images/one.png", 640, 480);
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
  // Proves that a result is never combined with modified captures.
  const CalibratedFolder calibrated{"images/one.png"};
  writeNoise(calibrated.captures() / "images/one.png", 640, 480);
  CaptureSet set = readCaptureSet(calibrated.captures()).set;
  set.captures.front().joints.measured.front() += 0.1;
  writeCaptureSet(set, calibrated.captures());
  const json data = shown(calibrated.page());
  CHECK_THAT(data["missing"][0].get<std::string>(), Catch::Contains("has changed"));
  CHECK(data["pictures"][0]["angles"].empty());
  CHECK_FALSE(hasPhotograph(data["pictures"][0]));
}

TEST_CASE("captures are also looked for beside the result file") {
  // Proves that a copied folder still gives a complete report.
  CalibratedFolder calibrated;
  calibrated.result["inputs"]["sets"] = json::array({"captures"});
  CHECK(shown(calibrated.page())["missing"].empty());
}

TEST_CASE("photographs are embedded, and none where there is no picture of the camera's size") {
  // Proves the data URI's header, JPEG signature and base64 padding, and that missing, invalid and larger images give
  // none. The reduced size of wide images is not tested.
  const CalibratedFolder calibrated{"images/large.png"};
  CHECK_FALSE(hasPhotograph(shown(calibrated.page())["pictures"][0]));
  writeNoise(calibrated.captures() / "images/large.png", 640, 480);
  const std::string photograph = shown(calibrated.page())["pictures"][0]["photograph"];
  const std::string head = "data:image/jpeg;base64,";
  REQUIRE(photograph.starts_with(head));
  CHECK(photograph.substr(head.size(), 4) == "/9j/"); // FF D8 FF, the start of every JPEG
  CHECK((photograph.size() - head.size()) % 4 == 0);
  writeAtomically(calibrated.captures() / "images/large.png", "this is no picture");
  CHECK_FALSE(hasPhotograph(shown(calibrated.page())["pictures"][0]));
  writeNoise(calibrated.captures() / "images/large.png", 1280, 960);
  CHECK_FALSE(hasPhotograph(shown(calibrated.page())["pictures"][0]));
}

TEST_CASE("a picture outside the set's folder is left where it is") {
  // Proves that a foreign result file cannot embed private images into a page, neither by its paths nor by links among
  // the captures; a link within the set is followed, so the size of the image is not the reason.
  CalibratedFolder calibrated;
  writeNoise(calibrated.captures() / ".." / "private.png", 640, 480);
  writeNoise(calibrated.captures() / "own.png", 640, 480);
  const std::string outside = (calibrated.captures() / ".." / "private.png").string();
  std::filesystem::create_symlink("../private.png", calibrated.captures() / "link.png");
  std::filesystem::create_symlink("..", calibrated.captures() / "up");
  std::filesystem::create_symlink("own.png", calibrated.captures() / "within.png");
  for (json& observation : calibrated.result["sightings"]) {
    observation["image"] = "within.png";
  }
  CHECK(hasPhotograph(shown(calibrated.page())["pictures"][0]));
  for (const std::string& path :
       {std::string{"../private.png"}, outside, std::string{"link.png"}, std::string{"up/private.png"}}) {
    for (json& observation : calibrated.result["sightings"]) {
      observation["image"] = path;
    }
    CHECK_FALSE(hasPhotograph(shown(calibrated.page())["pictures"][0]));
  }
}

TEST_CASE("a report stays small however many photographs there are") {
  // Proves the limit with incompressible images: the worst picture's photograph is kept, the page stays below 4 MB.
  const CalibratedFolder calibrated{"images/noise.png"};
  writeNoise(calibrated.captures() / "images/noise.png", 640, 480);
  const std::string page = calibrated.page();
  const json pictures = shown(page)["pictures"];
  CHECK(page.size() < 4'000'000);
  CHECK(hasPhotograph(pictures.front()));
  CHECK_FALSE(hasPhotograph(pictures.back()));
}
