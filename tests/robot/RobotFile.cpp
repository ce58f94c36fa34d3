#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"
#include "robot/Kinematics.hpp"
#include "robot/LegKinematics.hpp"

#include "TemporaryFolder.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace naocal;
using nlohmann::json;

namespace {

const std::filesystem::path drawings = std::filesystem::path{NAOCAL_SOURCE_DIR} / "home/configuration/drawings";

json v5() {
  return json::parse(readFile(drawings / "NaoV5.json"));
}

std::string refusal(const std::filesystem::path& drawing) {
  try {
    loadRobot(drawing);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

double mass(const Robot& robot) {
  double sum = 0;
  for (const Link& link : robot.links) {
    sum += link.mass;
  }
  return sum;
}

} // namespace

TEST_CASE("the drawings of all models are read, and weigh what their sources say") {
  // Proves that the three files are complete and that overriding works. The sums are those of HULKs' body_v_5.json with
  // head_v_5.json and head_v_6.json, and the manufacturer's for V4 (5.19535 kg, with a torso 0.04 g lighter). Single
  // values are not tested.
  const std::map<std::string, double> sums{{"V4", 5.19539}, {"V5", 5.30539}, {"V6", 5.35979}};
  for (const auto& [model, sum] : sums) {
    const Robot robot = loadRobot(drawings.parent_path(), model);
    CHECK(robot.model == model);
    CHECK(robot.links.size() == 27);
    CHECK(robot.joints.size() == 24);
    CHECK(robot.cameras.size() == 2);
    CHECK(robot.soles.size() == 2);
    CHECK(mass(robot) == Approx(sum).epsilon(1e-12));
  }
}

TEST_CASE("a base's numbers stay where a drawing does not replace them") {
  // Proves it for a mass replaced without its centre; JSON merge patches in general are not tested.
  const Robot v4 = loadRobot(drawings / "NaoV4.json"), v5 = loadRobot(drawings / "NaoV5.json");
  const std::size_t neck = *v4.linkIndex("Neck");
  CHECK(v4.links[neck].mass == 0.06442);
  CHECK(v4.links[neck].centreOfMass == v5.links[neck].centreOfMass);
}

TEST_CASE("parents stand before their children and joints know their links") {
  // Proves the order that all tree traversals rely on, for the existing drawings.
  for (const char* model : {"V4", "V5", "V6"}) {
    const Robot robot = loadRobot(drawings.parent_path(), model);
    CHECK_FALSE(robot.links.front().parent);
    for (std::size_t link = 1; link < robot.links.size(); ++link) {
      CHECK(*robot.links[link].parent < link);
    }
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      CHECK(robot.links[robot.joints[joint].link].joint == joint);
      CHECK(robot.joints[joint].axis.norm() == Approx(1).epsilon(1e-15));
    }
  }
}

TEST_CASE("both hip yaw-pitch joints have one motor, every other joint its own") {
  // Proves the drawing and the reader; how the motor is used is tested elsewhere.
  const Robot robot = loadRobot(drawings / "NaoV6.json");
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    const std::string& name = robot.joints[joint].name;
    CHECK(robot.joints[robot.joints[joint].motor].name == (name == "RHipYawPitch" ? "LHipYawPitch" : name));
  }
}

TEST_CASE("coupled limits are interpolated, end at the ends and never exceed the joint's own") {
  // Proves jointLimitsAt at rows of the drawing's tables and half-way between two; the tables' values are not tested.
  const Robot robot = loadRobot(drawings / "NaoV6.json");
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot.joints.size()));
  const std::size_t headPitch = *robot.jointIndex("HeadPitch"), ankleRoll = *robot.jointIndex("LAnkleRoll");
  double& headYaw = angles[static_cast<Eigen::Index>(*robot.jointIndex("HeadYaw"))];
  double& anklePitch = angles[static_cast<Eigen::Index>(*robot.jointIndex("LAnklePitch"))];

  CHECK(degrees(jointLimitsAt(robot, headPitch, angles).upper) == Approx(29.5)); // the table alone would permit 29.51
  headYaw = radians(-87.49);
  CHECK(degrees(jointLimitsAt(robot, headPitch, angles).lower) == Approx(-18.91));
  headYaw = radians((62.45 + 87.49) / 2);
  CHECK(degrees(jointLimitsAt(robot, headPitch, angles).lower) == Approx((-24.64 - 18.91) / 2));
  CHECK(degrees(jointLimitsAt(robot, headPitch, angles).upper) == Approx((17.19 + 11.46) / 2));
  headYaw = radians(170);
  CHECK(degrees(jointLimitsAt(robot, headPitch, angles).upper) == Approx(18.91));
  anklePitch = radians(52.87);
  CHECK(degrees(jointLimitsAt(robot, ankleRoll, angles).lower) == Approx(0).margin(1e-12));
  CHECK(degrees(jointLimitsAt(robot, *robot.jointIndex("LKneePitch"), angles).upper) == Approx(121.04));
}

TEST_CASE("the right sole mirrors the left one and both run counter-clockwise") {
  // Proves the parsing of outlineMirroredFrom; the area, 122.7 cm^2, is that of the outline's source.
  const Robot robot = loadRobot(drawings / "NaoV6.json");
  const auto area = [](const std::vector<Eigen::Vector2d>& outline) {
    double twice = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Eigen::Vector2d &a = outline[i], &b = outline[(i + 1) % outline.size()];
      twice += a.x() * b.y() - a.y() * b.x();
    }
    return twice / 2;
  };
  const Sole &left = *robot.findSole("left"), &right = *robot.findSole("right");
  CHECK(area(left.outline) == Approx(122.7e-4).epsilon(1e-3));
  CHECK(area(right.outline) == Approx(area(left.outline)).epsilon(1e-12));
  CHECK(right.outline.back() == Eigen::Vector2d{left.outline.front().x(), -left.outline.front().y()});
  CHECK(robot.findSole("middle") == nullptr);
}

TEST_CASE("every broken drawing is refused with a sentence that names the file, the place and the fault") {
  // Proves it for one variant of each rule of the format; rules that the reader lacks are not detected.
  struct Variant {
    std::string pointer; // what is replaced in V5's drawing
    json value;          // new value; null: removed
    std::string said;    // part of the message
  };
  const std::vector<Variant> variants{
      {"/format", "naocal-result", "format: expected one of naocal-drawing, found \"naocal-result\""},
      {"/version", 2, "version: expected 1, found 2"},
      {"/model", nullptr, "expected the key \"model\", found none"},
      {"/model", "", "model: expected a text that is not empty"},
      {"/mases", json::object(), "expected no keys but format, version"},
      {"/lengthsMillimetres/thigh", "long", "lengthsMillimetres.thigh: expected a number from 0 to 10000 millimetres"},
      {"/lengthsMillimetres/thigh", -1, "lengthsMillimetres.thigh: expected a number"},
      {"/lengthsMillimetres/thigh", nullptr,
       "alongLengths: expected only names of lengthsMillimetres, found \"thigh\""},
      {"/tree", nullptr, "expected the key \"tree\""},
      {"/tree/joints", json::array(), "tree: expected no keys but links"},
      {"/tree/links", json::array(), "tree.links: expected at least one link"},
      {"/tree/links/0/joint", "HeadYaw", "tree.links[0]: expected no keys but name"},
      {"/tree/links/2/name", "Neck", "tree.links[2].name: expected a name that no link before has, found \"Neck\""},
      {"/tree/links/2/parent", nullptr, "tree.links[2]: expected the key \"parent\""},
      {"/tree/links/1/parent", "Head", "tree.links[1].parent: expected the name of a link before this one"},
      {"/tree/links/2/parent", "Head", "tree.links[2].parent: expected the name of a link before this one"},
      {"/tree/links/2/joint", "HeadYaw", "tree.links[2].joint: expected a joint that moves no link before"},
      {"/tree/links/2/joint", "HeadRoll", "joints.HeadPitch: expected only joints of the tree"},
      {"/tree/links/3/originMillimetres", {0, 98}, "tree.links[3].originMillimetres: expected a list of 3 numbers"},
      {"/tree/links/3/originMillimetres/1", nullptr, "tree.links[3].originMillimetres[1]: expected a number"},
      {"/tree/links/1/alongLengths/neckZ", {0, 0, 126.5}, "alongLengths.neckZ[2]: expected a number from -1 to 1"},
      {"/joints/HeadYaw", nullptr, "joints: expected the key \"HeadYaw\", found none"},
      {"/joints/HeadYaw/axis", {0, 0, 0}, "joints.HeadYaw.axis: expected a direction"},
      {"/joints/HeadYaw/limitDegrees", {-1, 1}, "joints.HeadYaw: expected no keys but axis, limitsDegrees"},
      {"/joints/HeadYaw/limitsDegrees", {5, -5}, "joints.HeadYaw.limitsDegrees: expected a lower limit not above"},
      {"/joints/HeadYaw/maxSpeedDegreesPerSecond", 0, "maxSpeedDegreesPerSecond: expected a number from 0.1"},
      {"/joints/LShoulderPitch/restingDegrees", true, "restingDegrees: expected a number from -360 to 360 degrees"},
      {"/joints/RHipYawPitch/drivenBy", "HipYawPitch", "drivenBy: expected the name of a joint of the tree"},
      {"/joints/LHipYawPitch/drivenBy", "RHipYawPitch", "drivenBy: expected a joint with a motor of its own"},
      {"/joints/HeadPitch/coupledLimits/on", "HeadPitch", "coupledLimits.on: expected another joint"},
      {"/joints/HeadPitch/coupledLimits/rowsDegrees", json::array(), "rowsDegrees: expected at least one row"},
      {"/joints/HeadPitch/coupledLimits/rowsDegrees/1", {0, 1}, "rowsDegrees[1]: expected a list of 3 numbers"},
      {"/joints/HeadPitch/coupledLimits/rowsDegrees/1/0", -120, "rowsDegrees[1]: expected an angle above"},
      {"/joints/HeadPitch/coupledLimits/rowsDegrees/1/1", 30, "rowsDegrees[1]: expected a lower limit not above"},
      {"/masses/Tail", json::object(), "masses.Tail: expected only links of the tree"},
      {"/masses/Head/kilograms", -0.6, "masses.Head.kilograms: expected a number from 0 to 1000 kilograms"},
      {"/masses/Head/centreMillimetres", nullptr, "masses.Head: expected the key \"centreMillimetres\""},
      {"/cameras/top/link", "Hat", "cameras.top.link: expected the name of a link of the tree, found \"Hat\""},
      {"/cameras/top/pitchDegrees", "1.2", "cameras.top.pitchDegrees: expected a number from -360 to 360 degrees"},
      {"/cameras/top/roll", 0, "cameras.top: expected no keys but link, originMillimetres, pitchDegrees"},
      {"/soles/left/link", "Floor", "soles.left.link: expected the name of a link of the tree"},
      {"/soles/left/outlineMillimetres", {{0, 0}, {1, 0}}, "outlineMillimetres: expected a strictly convex outline"},
      {"/soles/left/outlineMillimetres", {{0, 0}, {0, 1}, {1, 0}}, "expected a strictly convex outline"},
      {"/soles/left/outlineMillimetres/0", {0, 0, 0}, "outlineMillimetres[0]: expected a list of 2 numbers"},
      {"/soles/left/outlineMirroredFrom", "right", "expected outlineMillimetres or outlineMirroredFrom, found both"},
      {"/soles/right/outlineMirroredFrom", "right", "expected the name of a sole with outlineMillimetres"},
      {"/soles/left/forceSensorsMillimetres/FL", nullptr, "expected the key \"FL\""},
      {"/base", "NaoV9.json", "NaoV9.json"},
  };
  const TemporaryFolder folder;
  const auto file = folder.path() / "broken.json";
  for (const auto& [pointer, value, said] : variants) {
    json drawing = v5();
    const json::json_pointer place{pointer};
    if (value.is_null() && drawing.at(place.parent_pointer()).is_object()) {
      drawing.at(place.parent_pointer()).erase(place.back());
    } else {
      drawing[place] = value;
    }
    writeAtomically(file, drawing.dump());
    CAPTURE(pointer, value.dump());
    const std::string sentence = refusal(file);
    CHECK_THAT(sentence, Catch::Contains(said));
    CHECK_THAT(sentence, Catch::StartsWith(folder.path().string()));
  }
}

TEST_CASE("a fault in a drawing with a base names both files") {
  // Proves that the message names both files, as the fault may be in either.
  const TemporaryFolder folder;
  writeAtomically(folder.path() / "base.json", v5().dump());
  json derived{{"format", "naocal-drawing"}, {"version", 1}, {"model", "X"}, {"base", "base.json"}};
  derived["masses"]["Head"]["kilograms"] = "heavy";
  writeAtomically(folder.path() / "derived.json", derived.dump());
  CHECK_THAT(refusal(folder.path() / "derived.json"),
             Catch::Contains("derived.json (with its base base.json): masses.Head.kilograms: expected a number"));
  derived["base"] = "derived.json";
  writeAtomically(folder.path() / "derived.json", derived.dump());
  CHECK_THAT(refusal(folder.path() / "derived.json"),
             Catch::Contains("derived.json: base: expected a drawing that has no base of its own"));
}

TEST_CASE("poses on the feet are planned for the legs of a NAO") {
  // Proves the question that commands ask before they plan, for every shipped robot.
  for (const auto& [model, isNao] :
       std::map<std::string, bool>{{"V4", true}, {"V5", true}, {"V6", true}, {"K1", false}}) {
    CHECK(hasPlannableLegs(loadRobot(drawings.parent_path(), model)) == isNao);
  }
}

TEST_CASE("an unknown model is refused with the list of the known ones") {
  // Proves it for the source tree's folder.
  CHECK_THROWS_WITH(loadRobot(drawings.parent_path(), "V9"),
                    Catch::Contains("{K1, V4, V5, V6}") && Catch::Contains("V9"));
  CHECK_THROWS_WITH(loadRobot(drawings.parent_path(), "/../NaoV6"), Catch::Contains("found none of"));
  CHECK_THROWS_WITH(
      loadRobot(drawings.parent_path(), std::string(100'000, 'V')),
      Catch::EndsWith("found none of \"" + std::string(60, 'V') +
                      "...\"; name one of them, or set NAOCAL_CONFIGURATION to the configuration's folder"));
}

TEST_CASE("a drawing whose model is not that of its file's name is refused") {
  // Proves it for a copy of one model under another's name: its numbers would pass for the other robot's.
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "drawings");
  std::filesystem::copy(drawings / "NaoV5.json", folder.path() / "drawings" / "NaoV5.json");
  std::filesystem::copy(drawings / "NaoV5.json", folder.path() / "drawings" / "NaoV4.json");
  CHECK(loadRobot(folder.path(), "V5").model == "V5");
  CHECK_THROWS_WITH(loadRobot(folder.path(), "V4"),
                    Catch::Contains("NaoV4.json: model: expected \"V4\", as in the file's name, found \"V5\""));
}

TEST_CASE("a file that is no drawing is refused by name") {
  // Proves it for invalid JSON, for JSON other than an object, and for a missing file.
  const TemporaryFolder folder;
  const auto file = folder.path() / "no.json";
  CHECK_THAT(refusal(file), Catch::Contains("no.json"));
  writeAtomically(file, "{");
  CHECK_THAT(refusal(file), Catch::Contains("no.json: expected valid JSON"));
  writeAtomically(file, "[]");
  CHECK_THAT(refusal(file), Catch::Contains("no.json: top level: expected an object, found a list of 0"));
}

TEST_CASE("the environment says where the configuration lies, else the source tree does") {
  // Proves the first and the last of the three locations; the installed one requires an installation.
  const char* before = std::getenv("NAOCAL_CONFIGURATION");
  const std::string kept = before == nullptr ? "" : before;
  ::setenv("NAOCAL_CONFIGURATION", "/somewhere/else", 1);
  CHECK(configurationDirectory() == "/somewhere/else");
  ::unsetenv("NAOCAL_CONFIGURATION");
  CHECK(configurationDirectory() == drawings.parent_path());
  if (before != nullptr) {
    ::setenv("NAOCAL_CONFIGURATION", kept.c_str(), 1);
  }
}
