#include "dialects/Dialects.hpp"

#include "RobotV6.hpp"
#include "io/InputError.hpp"

#include <catch2/catch.hpp>
#include <map>
#include <random>

namespace naocal {
namespace {

/// A calibration with every number different, of a robot and its two cameras.
RobotCalibration randomCalibration(unsigned seed) {
  std::mt19937 random{seed};
  std::uniform_real_distribution<double> angle{-0.2, 0.2}, shift{-0.01, 0.01}, share{0.45, 0.55}, bend{-0.1, 0.1};
  RobotCalibration calibration;
  for (const std::string_view joint : offsetJoints()) {
    calibration.offsets[std::string{joint}] = angle(random);
  }
  for (const char* const name : {"top", "bottom"}) {
    CameraCalibration& camera = calibration.cameras[name];
    camera.rotation = Eigen::Vector3d{angle(random), angle(random), angle(random)};
    camera.translation = Eigen::Vector3d{shift(random), shift(random), shift(random)};
    camera.lens = CameraIntrinsics{640,
                                   480,
                                   1280 * share(random),
                                   1280 * share(random),
                                   640 * share(random),
                                   480 * share(random),
                                   {bend(random), bend(random), bend(random), bend(random), 0}};
  }
  return calibration;
}

RobotCalibration readBack(const Dialect& dialect, const std::vector<DialectFile>& files) {
  ParsedCalibration all;
  for (const DialectFile& file : files) {
    addCalibration(dialect.parse(file.text, file.name, v6()), file.name, all);
  }
  CHECK(all.unused.empty());
  return all.calibration;
}

std::map<std::string, std::string> texts(const std::vector<DialectFile>& files) {
  std::map<std::string, std::string> all;
  for (const DialectFile& file : files) {
    all[file.name] = file.text;
  }
  return all;
}

std::string refusal(const char* dialect, const std::string& text) {
  try {
    (void)findDialect(dialect).parse(text, "some.cfg", v6());
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

} // namespace

TEST_CASE("what a dialect writes, it reads and writes again to the same digit") {
  // Proves for every dialect that text -> calibration -> text is the identity, from 50 random calibrations.
  for (const Dialect& dialect : dialects()) {
    for (unsigned seed = 1; seed <= 50; ++seed) {
      INFO(dialect.name << ", seed " << seed);
      const auto written = dialect.write(randomCalibration(seed), v6());
      REQUIRE_FALSE(written.empty());
      CHECK(texts(dialect.write(readBack(dialect, written), v6())) == texts(written));
    }
  }
}

TEST_CASE("what a dialect has a place for comes back as the same numbers") {
  // Proves that offsets, rotations, focal lengths and principal points survive each dialect to its last digit, and that
  // the right hip yaw-pitch stands for the left one's motor.
  const RobotCalibration given = randomCalibration(7);
  for (const Dialect& dialect : dialects()) {
    INFO(dialect.name);
    const RobotCalibration back = readBack(dialect, dialect.write(given, v6()));
    CHECK(back.offsets.size() == (dialect.hasJoints ? given.offsets.size() : 0));
    for (const auto& [joint, offset] : back.offsets) {
      INFO(joint);
      CHECK(std::abs(offset - given.offsets.at(joint)) < 1e-8);
    }
    for (const auto& [name, camera] : back.cameras) {
      INFO(name);
      const CameraCalibration& before = given.cameras.at(name);
      if (dialect.hasJoints) {
        REQUIRE(camera.rotation);
        CHECK((*camera.rotation - *before.rotation).norm() < 3e-8);
      }
      REQUIRE(camera.lens);
      CHECK(std::abs(camera.lens->fx - before.lens->fx) < 2e-5); // 6 decimals of an opening angle [deg]
      CHECK(std::abs(camera.lens->fy - before.lens->fy) < 2e-5);
      CHECK(std::abs(camera.lens->cx - before.lens->cx) < 1e-6);
      CHECK(std::abs(camera.lens->cy - before.lens->cy) < 1e-6);
    }
  }
}

TEST_CASE("what a dialect loses is named") {
  // Proves the lists for one that loses shifts and distortion, and one that loses joints and mounts.
  const RobotCalibration given = randomCalibration(3);
  const auto lost = unwritten(findDialect("bhuman"), given, v6());
  CHECK(lost == std::vector<std::string>{"the shift of camera bottom", "the distortion of camera bottom",
                                         "the shift of camera top", "the distortion of camera top"});
  CHECK(unwritten(findDialect("ros"), given, v6()).front() == "joint offsets");
  CHECK(unwritten(findDialect("hulks"), RobotCalibration{{{"LKneePitch", 0.1}}, {}, "", ""}, v6()).empty());
}

TEST_CASE("a dialect writes only what is known, where a file may leave it out") {
  // Proves that HULKs' files name no other joint, that B-Human's name all 26 with 0 for others, and that nothing is
  // written of a calibration without numbers.
  const RobotCalibration knee{{{"LKneePitch", -0.0396}, {"LHipYawPitch", 0.0581}}, {}, "", ""};
  const auto hulks = findDialect("hulks").write(knee, v6());
  REQUIRE(hulks.size() == 1);
  CHECK(hulks[0].text == "{\n  \"lHipYawPitch\": 3.328885,\n  \"lKneePitch\": -2.268913,\n  \"rHipYawPitch\": "
                         "3.328885\n}\n");
  const auto bhuman = findDialect("bhuman").write(knee, v6());
  REQUIRE(bhuman.size() == 1);
  CHECK(bhuman[0].text.find("  lKneePitch = -2.268913deg;\n") != std::string::npos);
  CHECK(bhuman[0].text.find("  rKneePitch = 0deg;\n") != std::string::npos);
  CHECK(bhuman[0].text.find("  rHipYawPitch = 3.328885deg;\n") != std::string::npos);
  for (const Dialect& dialect : dialects()) {
    CHECK(dialect.write({}, v6()).empty());
  }
}

TEST_CASE("files as the teams' releases have them are read") {
  // Proves that the layouts of the public configuration files (spacing, comments, units, older names) are understood.
  const auto bhuman = [](const std::string& text) { return findDialect("bhuman").parse(text, "a.cfg", v6()); };
  const ParsedCalibration offsets =
      bhuman("// robot\noffsets = {\n  headYaw = 1deg;\n  lHand = 0deg; /* a\nhand */ lHipYawPitch = 0.02rad;\n"
             "  rHipYawPitch = 0.02;\n};\n");
  CHECK(offsets.calibration.offsets.at("HeadYaw") == Approx(0.01745329252));
  CHECK(offsets.calibration.offsets.at("LHipYawPitch") == 0.02);
  CHECK(offsets.calibration.offsets.size() == 2);
  CHECK(offsets.unused.empty());

  const ParsedCalibration older = bhuman("joints = {\n  headPitch = {\n    offset = -2deg;\n    minAngle = -38.5deg;\n"
                                         "    maxAngle = 29.5deg;\n  };\n};\n");
  CHECK(older.calibration.offsets.at("HeadPitch") == Approx(-0.0349065850));

  const ParsedCalibration devils = findDialect("naodevils")
                                       .parse("lowerCameraRotationCorrection = { x = 0deg; y = -5deg; z = 0deg; };\n"
                                              "bodyRotationCorrection = { x = 0deg; y = -1.9deg; };\n",
                                              "a.cfg", v6());
  CHECK(devils.calibration.cameras.at("bottom").rotation->y() == Approx(-0.0872664626));
  CHECK(devils.unused == std::vector<std::string>{"bodyRotationCorrection.y in line 2"});

  const ParsedCalibration tree =
      findDialect("hulks-tree")
          .parse(R"({"joint_calibration_offsets": {"left_leg": {"hip_yaw_pitch": -0.2}, "right_leg": {"hip_yaw_pitch":
                 -0.2}}, "walking_engine": {"base": {}}})",
                 "body.json", v6());
  CHECK(tree.calibration.offsets == std::map<std::string, double>{{"LHipYawPitch", -0.2}});
  CHECK(tree.unused == std::vector<std::string>{"walking_engine"});

  const ParsedCalibration hulks = findDialect("hulks").parse(
      "// degrees\n{\"rHipYawPitch\": 1.0, \"lHipYawPitch\": 2.0, \"fov\": [56.3, 43.7]}", "a.json", v6());
  CHECK(hulks.calibration.offsets.at("LHipYawPitch") == Approx(0.0349065850)); // the left one's counts
  CHECK(hulks.unused.size() == 2);
}

TEST_CASE("bad files are refused with the line and the reason") {
  // Proves place, expectation and finding in the messages of each parser; each text has one fault.
  const std::map<std::string, std::string> maps{
      {"offsets = {\n  headYaw = 1deg\n};",
       "some.cfg: line 3: expected \";\" behind the value of headYaw, found \"}\""},
      {"offsets = {\n  headYaw = 1mm;\n};",
       "some.cfg: line 2: headYaw: expected an angle such as -1.5deg or 0.02rad, found \"1mm\""},
      {"offsets = {\n  headYaw = 4;\n};",
       "some.cfg: line 2: headYaw: expected an angle within 180 degrees (is its unit missing?), found \"4\""},
      {"offsets = {\n\n  leftKnee = 1deg;\n};",
       "some.cfg: line 3: offsets: expected joints of a NAO, such as lKneePitch, found leftKnee"},
      {"offsets = {\n  headYaw = 1deg;\n  headYaw = 2deg;\n};",
       "some.cfg: line 3: expected each name once, found headYaw again (first in line 2)"},
      {"offsets = {\n  headYaw = nandeg;\n};",
       "some.cfg: line 2: headYaw: expected an angle such as -1.5deg or 0.02rad, found \"nandeg\""},
      {"offsets = {", "some.cfg: line 1: expected \"}\" to close the \"{\" of line 1, found the end of the file"},
      {"cameraRotationCorrections = {\n  upper = {x = 0deg; y = 0deg;};\n};",
       "some.cfg: line 2: cameraRotationCorrections.upper: expected z = ... in it, found none"},
      {"upperOpeningAngleWidth = 60.97;\nupperOpeningAngleHeight = 47deg;\nupperOpticalCenter = {x = 0; y = 0;};",
       "some.cfg: line 1: the opening angle: expected 5deg to 170deg, with its unit, found \"60.97\""}};
  for (const auto& [text, sentence] : maps) {
    CHECK(refusal("bhuman", text) == sentence);
  }
  CHECK(refusal("naodevils", "walkHeight = 3;").find("found walkHeight = ...") != std::string::npos);
  CHECK(refusal("bhuman", std::string(3000, '{')).find("line 1") != std::string::npos);
  CHECK(refusal("bhuman", "a = " + std::string(3000, '[')).find("nested less deeply") != std::string::npos);
  CHECK(refusal("hulks", "{\"lKneePitch\": 1\n \"x\": 2}").find("line 2") != std::string::npos);
  CHECK(refusal("hulks", R"({"lKneePitch": "much"})").find("lKneePitch") != std::string::npos);
  CHECK(refusal("hulks", R"({"top_ext": [0, 0]})").find("top_ext") != std::string::npos);
  CHECK(refusal("hulks", R"({"walk": 1})").find("none of them") != std::string::npos);
  CHECK(refusal("hulks-tree", R"({"joint_calibration_offsets": {"left_leg": {"knee": 0.1}}})")
            .find("joint_calibration_offsets") != std::string::npos);
  CHECK(refusal("ros", "image_width: 640\nimage_height: [").find("expected valid YAML") != std::string::npos);
  CHECK(refusal("ros", "image_width: 640\nimage_height: tall\n") ==
        "some.cfg: line 2: image_height: expected a number, found \"tall\"");
  CHECK(refusal("kalibr", "cam0:\n  camera_model: omni\n") ==
        "some.cfg: line 2: cam0.camera_model: expected pinhole, the one model that is known here, found omni");
}

TEST_CASE("damaged files are read or refused, and nothing else happens") {
  // Proves that 400 random changes of a byte in each written file end in a calibration or in an InputError; another
  // exception would fail the test.
  std::mt19937 random{11};
  for (const Dialect& dialect : dialects()) {
    for (const DialectFile& file : dialect.write(randomCalibration(5), v6())) {
      std::size_t refused = 0;
      for (int i = 0; i < 400; ++i) {
        std::string text = file.text;
        for (int change = 0; change < 3; ++change) {
          text[random() % text.size()] = static_cast<char>("{}[]:;,=.\n x-9\"\xff"[random() % 17]);
        }
        INFO(dialect.name << ": " << text);
        try {
          (void)dialect.parse(text, file.name, v6());
        } catch (const InputError& error) {
          ++refused;
          CHECK(std::string{error.what()}.find(file.name) != std::string::npos);
        }
      }
      CHECK(refused > 50);
    }
  }
}

TEST_CASE("a number that two files of an import have is refused") {
  // Proves that no file wins silently.
  ParsedCalibration all;
  const auto one = findDialect("hulks").parse(R"({"headYaw": 1})", "a.json", v6());
  addCalibration(one, "a.json", all);
  CHECK_THROWS_WITH(addCalibration(one, "b.json", all), Catch::Contains("b.json: the offset of HeadYaw is in another"));
}

} // namespace naocal
