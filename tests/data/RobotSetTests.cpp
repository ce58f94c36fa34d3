#include "Breaks.hpp"
#include "GoodRobotSet.hpp"
#include "RoundTrip.hpp"
#include "SharedData.hpp"
#include "data/CaptureSetFile.hpp"
#include "data/Refusal.hpp"
#include "io/Files.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace naocal {
namespace {

using nlohmann::json;

std::vector<Break> breaksOfRobotSets() {
  using enum Breaks;
  return {
      {file, "/version", "3", {"version: expected", "found 3"}},
      {file, "/robot/urdf", removed, {"robot", "\"model\""}},
      {file, "/robot/urdf", "'../robot.urdf'", {"robot.urdf", "inside the set's folder", "../robot.urdf"}},
      {file, "/robot/urdf", "'/etc/robot.urdf'", {"robot.urdf", "inside the set's folder"}},
      {file, "/robot/model", "'V6'", {"robot", "either `urdf` or `model`", "both"}},
      {file, "/robot/base", "3", {"robot.base", "text", "found 3"}},
      {file, "/jointNames/1", "'pan'", {"jointNames[1]", "every joint once"}},
      {file, "/cameras/side/link", removed, {"cameras.side", "\"link\""}},
      {file, "/cameras/side/axes", "'up'", {"cameras.side.axes", "forward, optical", "\"up\""}},
      {file, "/cameras/side/placementGuess/x", "'1'", {"cameras.side.placementGuess.x", "a number"}},
      {file, "/cameras/wrist/placement", "[0, 0, 0]", {"cameras.wrist.placement", "an object"}},
      {file, "/cameras/wrist/placementSigma/x", "0", {"cameras.wrist.placementSigma.x", "found 0"}},
      {file, "/trackers", "[]", {"trackers: expected an object"}},
      {file, "/trackers/vicon/sigma", "-1", {"trackers.vicon.sigma", "found -1"}},
      {file, "/trackers/vicon/placement/yaw", "90", {"trackers.vicon.placement.yaw", "radians", "90"}},
      {file, "/markers", "{}", {"markers: expected a list"}},
      {file, "/markers/0/link", removed, {"markers[0]", "\"link\""}},
      {file, "/markers/1/id", "'ball'", {"markers[1].id", "no other", "\"ball\""}},
      {file, "/markers/1/point", "[0, 0]", {"markers[1].point", "3 numbers"}},
      {file, "/markers/0/pointSigma", "0", {"markers[0].pointSigma", "found 0"}},
      {file, "/frames/1/id", "'tool'", {"frames[1].id", "no other"}},
      {file, "/frames/0/placement/x", "'NaN'", {"frames[0].placement.x", "NaN"}},
      {file, "/places/0/id", removed, {"places[0]", "\"id\""}},
      {file, "/places/1/point", "'here'", {"places[1].point", "3 numbers"}},
      {file, "/distances/0/between", "['A', 'Z']", {"distances[0].between[1]", "`places`", "\"Z\""}},
      {file, "/distances/0/between", "['A', 'A']", {"distances[0].between", "two places"}},
      {file, "/distances/0/metres", "-0.05", {"distances[0].metres", "-0.05"}},
      {file, "/distances/0/sigma", removed, {"distances[0]", "\"sigma\""}},
      {file, "/contactSigma", "0", {"contactSigma", "found 0"}},
      {file, "/soles", "[]", {"soles: expected an object"}},
      {file, "/soles/l_foot/z", "'low'", {"soles.l_foot.z", "a number"}},
      {file, "/gravity", "[0, 0, 0]", {"gravity", "acceleration"}},
      {file, "/gravity", "9.81", {"gravity", "3 numbers"}},
      {file, "/encoderSteps/pan", "0", {"encoderSteps.pan", "radians", "found 0"}},
      {file, "/slipSteps", "0.4", {"slipSteps", "an object"}},
      {file, "/stances/2/supportLinks", "[]", {"stances[2].supportLinks", "links whose soles"}},
      {file, "/stances/2/placement/z", "0.1", {"stances[2].placement.z", "x, y and yaw"}},
      {file, "/stances/1/placement", "1", {"stances[1].placement", "an object"}},
      {capture, "/captures/0/camera", removed, {"captures[0]", "\"camera\""}},
      {capture, "/captures/0/camera", "'head'", {"captures[0].camera", "`cameras`"}},
      {capture, "/captures/1/points/0/tracker", "'leica'", {"points[0].tracker", "`trackers`", "\"leica\""}},
      {capture, "/captures/1/points/0/marker", "'nose'", {"points[0].marker", "`markers`"}},
      {capture, "/captures/1/points/0/xyz", "[1, 2]", {"points[0].xyz", "3 numbers"}},
      {capture, "/captures/1/points/0/xyz/1", "null", {"points[0].xyz[1]", "null"}},
      {capture, "/captures/1/frames/0/frame", "'ball'", {"frames[0].frame", "`frames`"}},
      {capture, "/captures/1/frames/0/quaternion", "[1, 1, 0, 0]", {"quaternion", "add up to 1", "1.414"}},
      {capture, "/captures/1/contacts/0/place", "'C'", {"contacts[0].place", "`places`"}},
      {capture, "/captures/1/contacts", "{}", {"contacts", "a list"}},
      {capture, "/captures/1/joints/measured", "[0.1]", {"joints.measured", "2 numbers"}},
      {capture, "/captures/1/stance", "9", {"captures[1].stance", "`stances`"}},
  };
}

} // namespace

TEST_CASE("a set of any robot says which robot, cameras, instruments and supports there are") {
  // Proves the meaning of the keys of version 2 for a set that uses all of them.
  const CaptureSet set = read(goodRobotSet());
  CHECK(set.version == 2);
  CHECK(set.urdf == "robot.urdf");
  CHECK(set.base == "base_link");
  CHECK(set.model.empty());
  const CameraMounting &wrist = set.mountings.at("wrist"), &side = set.mountings.at("side");
  CHECK_FALSE(wrist.isOptical);
  CHECK(wrist.placement->pitch == 0.2);
  CHECK(wrist.sigma->roll == 0.02);
  CHECK(side.link == "world");
  CHECK(side.isOptical);
  CHECK_FALSE(side.placement);
  CHECK(side.guess->yaw == 0.5);
  const Instruments& instruments = set.instruments;
  CHECK(instruments.trackers.size() == 2);
  CHECK(instruments.markers.at(0).pointGuess.z() == 0.1);
  CHECK(instruments.markers.at(1).point->y() == 0.2);
  CHECK_FALSE(instruments.frames.at(1).placement);
  CHECK_FALSE(instruments.places.at(0).point);
  CHECK(instruments.distances.at(0).metres == 0.05);
  CHECK(*instruments.contactSigma == 0.0001);
  CHECK(set.soles.at("l_foot").z == -0.027);
  CHECK(set.gravity == Eigen::Vector3d{0, 1, -9.7});
  CHECK(set.encoderSteps.at("pan") == 0.0004);
  CHECK(set.slipSteps.at("lift") == 0.4);
  CHECK(set.stances.at(1).placement->roll == 0.2);
  CHECK(set.stances.at(2).supportLinks == std::vector<std::string>{"l_foot", "r_foot"});
  const Capture &first = set.captures.at(0), &second = set.captures.at(1);
  CHECK(first.supportFoot == SupportFoot::none);
  CHECK(second.camera.empty());
  CHECK_FALSE(second.corners);
  CHECK(second.points.at(0).xyz.z() == 1.104);
  CHECK(second.frames.at(0).rotation.y() == 0.8);
  CHECK(second.contacts.at(0).place == "A");
}

TEST_CASE("a set of any robot that is written says what the set that was read said") {
  // Proves that no feature of version 2 and no unknown key is lost, and that a second round trip changes nothing.
  json document = goodRobotSet();
  document["trackers"]["vicon"]["maker"] = "Vicon";
  document["captures"][1]["points"][0]["quality"] = 3;
  const json once = written(read(document));
  CHECK(holds(once, document));
  CHECK(written(read(once)) == once);
}

TEST_CASE("every broken set of any robot is refused with a sentence that says where, what was expected and found") {
  // Proves it for the single modifications in the table, and that only captures can be skipped.
  for (const Break& how : breaksOfRobotSets()) {
    json document = goodRobotSet();
    applyBreak(how, document);
    const std::string sentence = refusal(document.dump());
    INFO(how.place << " = " << how.value << "\n" << sentence);
    checkSentence(sentence, how.sentence);
    if (how.what == Breaks::file) {
      CHECK_THROWS_AS(parseCaptureSet(document.dump(), "set", BadCapturePolicy::skip), InputError);
    } else {
      CHECK(parseCaptureSet(document.dump(), "set", BadCapturePolicy::skip).skipped.size() == 1);
    }
  }
}

TEST_CASE("a capture without any measurement is refused") {
  // Proves that a capture has at least one of corners, points, frames and contacts.
  json document = goodRobotSet();
  for (const char* key : {"points", "frames", "contacts"}) {
    document["captures"][1].erase(key);
  }
  CHECK_THAT(refusal(document.dump()), Catch::Contains("captures[1]") && Catch::Contains("none of them"));
}

TEST_CASE("sets of other programs are read, written and read again without loss") {
  // Proves it for all sets of one independent simulator: arms, a tracker, contacts, a camera beside, one foot.
  const auto folder = sharedData("conformance-robots");
  if (!folder) {
    return;
  }
  std::size_t sets = 0;
  for (const auto& entry : std::filesystem::directory_iterator{*folder}) {
    if (!entry.is_directory()) {
      continue;
    }
    INFO(entry.path());
    const json original = json::parse(readFile(entry.path() / "captures.json"));
    const json once = written(readCaptureSet(entry.path()).set);
    CHECK(holds(once, original));
    CHECK(written(read(once)) == once);
    ++sets;
  }
  CHECK(sets == 8);
}

} // namespace naocal
