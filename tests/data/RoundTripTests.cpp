#include "GoodSet.hpp"
#include "RoundTrip.hpp"
#include "SharedData.hpp"
#include "data/CaptureSetFile.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

namespace naocal {
namespace {

using nlohmann::json;

} // namespace

TEST_CASE("what a set's file says is read into the set") {
  // Proves the meaning of the keys of a set that uses all features. Refusals are tested in BrokenSetsTests.
  const CaptureSet set = read(goodSet());
  CHECK(set.name == "set");
  CHECK(set.model == "V6");
  CHECK(set.bodyId == "body");
  CHECK(set.headId == "head");
  CHECK(set.jointNames == std::vector<std::string>{"HeadYaw", "HeadPitch", "LHipYawPitch", "RHipYawPitch"});
  CHECK(set.cameras.at("top").distortion == std::array{0.1, -0.2, 0.001, -0.002, 0.3});
  CHECK(set.cameras.at("bottom").width == 1280);

  const Board &a = set.boards.at(0), &b = set.boards.at(1), &mark = set.boards.at(2), &sandal = set.boards.at(3);
  CHECK(a.link == "floor");
  CHECK(a.pattern->dictionary == "DICT_4X4_100");
  CHECK(a.points.size() == 24);
  CHECK(a.placement->yaw == 0.25);
  CHECK_FALSE(a.hasGuess);
  CHECK(b.pattern->legacyPattern);
  CHECK(b.points.size() == 15);
  CHECK(b.hasGuess);
  CHECK(b.placementGuess.y == 0.5);
  CHECK(b.placementSigma->yaw == 0.3);
  CHECK_FALSE(mark.pattern);
  CHECK_FALSE(mark.placement);
  CHECK(mark.placementGuess.z == -0.03);
  CHECK(mark.placementSigma->z == 0.05);
  CHECK(sandal.points.at(1) == Eigen::Vector3d{0.01, 0.02, 0.03});
  CHECK(sandal.placement->pitch == -0.2);
  CHECK(set.stances.at(0).placement->yaw == -0.03);
  CHECK_FALSE(set.stances.at(1).placement);

  const Capture &first = set.captures.at(0), &second = set.captures.at(1), &third = set.captures.at(2);
  CHECK(first.time.count() == 12.345);
  CHECK(first.joints.approach == std::vector<double>{-1, 0, 1, 1});
  CHECK(*first.imu == Eigen::Vector2d{0.01, -0.02});
  CHECK(first.fsr->at(1) == 0.6);
  CHECK(first.corners->at(0).ids == std::vector{0, 1, 23});
  CHECK(first.corners->at(0).uv.at(1) == Eigen::Vector2d{330.9, 199.8});
  CHECK(first.repeatKind == RepeatKind::rest);
  CHECK(second.repeatKind == RepeatKind::reapproach);
  CHECK(second.supportFoot == SupportFoot::both);
  CHECK(std::isnan(second.joints.measured.at(1)));
  CHECK(second.joints.commanded.empty());
  CHECK_FALSE(second.corners);
  CHECK(second.image == "images/0001.png");
  CHECK(third.corners->empty());
  CHECK(third.repeatKind == RepeatKind::restand);
}

TEST_CASE("inner corners count along the rows, with y up the sheet") {
  // Proves corner 7 of a sheet 7 squares wide against values calculated by hand from the format's formula.
  const auto corners = innerCorners({.squaresX = 7, .squaresY = 5, .squareLength = 0.08});
  REQUIRE(corners.size() == 24);
  CHECK((corners[0] - Eigen::Vector3d{0.08, -0.08, 0}).norm() < 1e-15);
  CHECK((corners[7] - Eigen::Vector3d{0.16, -0.16, 0}).norm() < 1e-15);
  CHECK((corners[23] - Eigen::Vector3d{0.48, -0.32, 0}).norm() < 1e-15);
}

TEST_CASE("a set that is written says what the set that was read said") {
  // Proves that no feature is lost in a round trip, and that a second round trip changes nothing.
  const CaptureSet set = read(goodSet());
  const json copy = written(set);
  CHECK(holds(copy, goodSet()));
  CHECK(written(read(copy)) == copy);
}

TEST_CASE("keys that are unknown are kept wherever they stand, also when the rest changes") {
  // Proves it for every object of the format. Lists of numbers have no keys.
  json document = goodSet();
  for (const char* place :
       {"", "/robot", "/cameras/top", "/boards/0", "/boards/1", "/boards/0/placement", "/boards/1/placementGuess",
        "/boards/1/placementSigma", "/stances/0", "/stances/0/placement", "/captures/0", "/captures/2",
        "/captures/0/joints", "/captures/0/imu", "/captures/0/corners/1"}) {
    document[json::json_pointer{place}]["zz unknown"] = {{"of", place}, {"list", {1, 2.5, nullptr, "x", true}}};
  }
  CaptureSet set = read(document);
  CHECK(holds(written(set), document));

  std::reverse(set.captures.begin(), set.captures.end());
  set.boards.erase(set.boards.begin());
  set.boards[0].placement = Placement{.x = 2};
  const json changed = written(set);
  CHECK(changed["captures"][3]["zz unknown"]["of"] == "/captures/0");
  CHECK(changed["boards"][0]["zz unknown"]["of"] == "/boards/1");
  CHECK(changed["boards"][0]["placement"] == json{{"x", 2.0}, {"y", 0.0}, {"yaw", 0.0}});
}

TEST_CASE("numbers keep every bit") {
  // Proves it for numbers without a short decimal, the smallest denormal and a time near the format's maximum.
  CaptureSet set = read(goodSet());
  const double smallest = std::numeric_limits<double>::denorm_min();
  set.captures[0].joints.measured = {0.1 + 0.2, std::nextafter(1.0, 2.0), smallest, smallest};
  set.captures[0].time = Seconds{1e12 / 3};
  const CaptureSet copy = read(written(set));
  CHECK(copy.captures[0].joints.measured == set.captures[0].joints.measured);
  CHECK(copy.captures[0].time == set.captures[0].time);
}

TEST_CASE("a set made in code can be written and read") {
  // Proves that writing does not require anything that only the reader sets.
  CaptureSet set;
  set.jointNames = {"HeadYaw"};
  set.cameras["top"] = {.fx = 500, .fy = 500};
  const CharucoPattern pattern;
  set.boards.push_back({.id = "A", .pattern = pattern, .points = innerCorners(pattern)});
  set.stances.push_back({.id = 3, .supportFoot = SupportFoot::right});
  Capture capture;
  capture.pose = "P";
  capture.camera = "top";
  capture.supportFoot = SupportFoot::right;
  capture.stance = 3;
  capture.joints.measured = {std::nan("")};
  capture.corners.emplace();
  set.captures.push_back(capture);
  const CaptureSet copy = read(written(set));
  CHECK(copy.captures.size() == 1);
  CHECK(std::isnan(copy.captures[0].joints.measured[0]));
  CHECK(copy.captures[0].corners->empty());
  CHECK(copy.boards[0].points == set.boards[0].points);
}

TEST_CASE("every set of real measurements is read, and written without loss") {
  // Proves it for sets of other programs, where available; their content is not judged.
  for (const char* folder : {"nao-freiburg-2014", "conformance"}) {
    const auto sets = sharedData(folder);
    if (!sets) {
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator{*sets}) {
      if (!entry.is_directory()) {
        continue;
      }
      INFO(entry.path());
      std::ifstream file{entry.path() / "captures.json"};
      const CaptureSet set = readCaptureSet(entry.path()).set;
      CHECK(set.name == entry.path().filename());
      CHECK(set.captures.size() > 0);
      CHECK(holds(written(set), json::parse(file)));
    }
  }
}

} // namespace naocal
