#include "robot/CapturePictures.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

using Json = nlohmann::json;

/// A robot's list after `count` captures, one pose each, top camera.
Json captures(int count, const std::string& calibration = "L") {
  Json list = Json::array();
  for (int i = 1; i <= count; ++i) {
    list.push_back({{"number", i}, {"round", 0}, {"pose", calibration + std::to_string(i)}, {"camera", "top"}});
  }
  return list;
}

} // namespace

TEST_CASE("each capture keeps the picture of its own moment, whoever asks later") {
  // Proves that the image nearest in time to a capture is assigned, whether it arrived before or after the capture's
  // announcement, that later ones are ignored, and the list sent to panels.
  CapturePictures taken;
  taken.beginWatch();
  taken.onCaptures(captures(0), 500);
  taken.onImage("top", 900, "early");
  taken.onImage("bottom", 1000, "of the other camera");
  CHECK(taken.onCaptures(captures(1), 1000));
  CHECK(taken.picture(0, 0) == "early");
  CHECK(taken.onImage("top", 1010, "right"));
  CHECK_FALSE(taken.onImage("top", 1200, "later"));
  CHECK(taken.picture(0, 0) == "right");
  CHECK(taken.onCaptures(captures(2), 3000) == false); // no image close in time
  CHECK(taken.list() == Json{{"series", 0}, {"places", {0}}});
  CHECK_FALSE(taken.picture(0, 1));
  CHECK_FALSE(taken.picture(1, 0));
  CHECK_FALSE(taken.picture(0, 7));
}

TEST_CASE("where images are rare, a capture has none rather than another's") {
  // Proves that an image goes to the nearest of several captures, and that one which loses it takes the next nearest.
  CapturePictures taken;
  taken.beginWatch();
  taken.onCaptures(captures(0), 500);
  taken.onImage("top", 1400, "between");
  taken.onCaptures(captures(1), 1000);
  CHECK(taken.picture(0, 0) == "between");
  CHECK(taken.onCaptures(captures(2), 1500));
  CHECK_FALSE(taken.picture(0, 0));
  CHECK(taken.picture(0, 1) == "between");
  CHECK(taken.onImage("top", 1700, "late"));
  CHECK(taken.picture(0, 0) == "late");
  CHECK(taken.picture(0, 1) == "between");
}

TEST_CASE("captures that nobody watched have no picture, whatever the cameras show now") {
  // Proves that neither captures from before the first watch nor those taken in a gap get the present image.
  CapturePictures taken;
  taken.beginWatch();
  taken.onImage("top", 8990, "now");
  taken.onCaptures(captures(3), 9000);
  taken.onImage("top", 9010, "now");
  CHECK(taken.list()["places"].empty());
  CHECK(taken.onCaptures(captures(4), 9020));
  CHECK(taken.picture(0, 3) == "now");
  taken.beginWatch(); // after an interruption
  taken.onCaptures(captures(6), 20000);
  taken.onImage("top", 20001, "later");
  CHECK(taken.list()["places"] == Json{3});
  CHECK(taken.picture(0, 3) == "now"); // assigned images are kept
}

TEST_CASE("a new calibration begins with no pictures of the old one") {
  // Proves it for a shorter list and for one of equal length with other poses; URLs of the two series differ.
  CapturePictures taken;
  taken.beginWatch();
  taken.onCaptures(captures(0), 0);
  taken.onImage("top", 1000, "first");
  taken.onImage("top", 1300, "second");
  taken.onCaptures(captures(2), 1000);
  CHECK(taken.list()["places"].size() == 2);
  CHECK(taken.onCaptures(captures(0), 2000));
  CHECK(taken.list() == Json{{"series", 1}, {"places", Json::array()}});
  taken.onCaptures(captures(2), 60000);
  CHECK(taken.onCaptures(captures(2, "R"), 61000));
  CHECK(taken.list()["series"] == 2);
  CHECK_THROWS_AS(taken.onCaptures({{{"number", "one"}}}, 1), Json::exception);
}

} // namespace naocal
